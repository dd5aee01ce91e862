#include "core/base/message_table.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace knittsim {

namespace {

// KS00xx files and resources, KS01xx reading machine data, KS02xx the machine, KS03xx physics, KS04xx
// drawing, KS05xx charts.
constexpr auto kMessages = std::to_array<Message>({
    {"KS0001", "cannot-read", "The file cannot be read: {0}.", "Check the path and the permissions."},
    {"KS0002", "cannot-write", "The file cannot be written: {0}.",
     "Check the folder, its permissions and the free space."},
    {"KS0003", "bad-json", "The file is not valid JSON: {0}.", "Correct the text at this place."},
    {"KS0004", "bad-value", "'{0}' is {1}, expected {2}.", "Correct the value."},
    {"KS0005", "missing-value", "'{0}' is missing, expected {1}.", "Add the value."},
    {"KS0006", "unknown-format", "Files of this format cannot be read: {0}.",
     "Open knitout (.k, .knitout), Shima DAT (.dat), Kniterate k-code (.kc) or Stoll Sintral text (.sin)."},
    {"KS0007", "file-too-large", "The file has {0} bytes, the limit is {1}.",
     "Check that the right file was chosen; split a program that is so large."},
    {"KS0008", "not-found", "{0} '{1}' does not exist.", "Choose one of: {2}."},
    {"KS0009", "cancelled", "The work was cancelled; nothing was written.", ""},
    {"KS0012", "no-bytes", "The file is empty.", "Check that the right file was chosen."},
    {"KS0013", "other-encoding", "The file is text in {0}, expected UTF-8.", "Save the file as UTF-8."},
    {"KS0014", "not-text", "This is not a text file: {0} of its {1} bytes are control characters.",
     "Check that the right file was chosen."},
    {"KS0020", "undocumented-format", "{0} data is not publicly documented, so it cannot be read.",
     "Knitout (.k) or Stoll Sintral text (.sin) fills its place; export the program as one of them."},
    {"KS0021", "cannot-write-format", "Files of this format cannot be written: {0}.",
     "Choose knitout (.k, .knitout), Shima DAT (.dat) or Kniterate k-code (.kc)."},
    {"KS0022", "cannot-export", "Nothing can be exported as '{0}'.",
     "Choose .png, .obj, .gltf, .glb, .bcc, .svg or .csv."},
    {"KS0023", "export-too-large", "The fabric is larger than {0}, which this format cannot hold.",
     "Choose another format."},
    {"KS0025", "report-format", "A report cannot be written in this format: {0}.",
     "Choose a name that ends with .html or .json."},

    {"KS0101", "no-magic", "The first line is {0}, expected ';!knitout-2'.",
     "Write ';!knitout-2' as the first line."},
    {"KS0102", "newer-version", "The file says it is knitout version {0}; this program knows version 2.",
     "Check that nothing of the newer version is lost."},
    {"KS0103", "no-carriers", "The header has no ';;Carriers:' line.",
     "Name the carriers, for example ';;Carriers: 1 2 3'."},
    {"KS0104", "bad-header", "The value of ';;{0}:' is {1}, expected {2}.", "Correct the header line."},
    {"KS0105", "duplicate-header", "The header ';;{0}:' appears again.",
     "Keep one of them; the first one counts."},
    {"KS0106", "late-header", "A header line ';;{0}:' stands after the first operation and is not used.",
     "Move it to the top of the file."},
    {"KS0107", "unknown-operation", "Found '{0}', expected an operation of knitout 2.",
     "Correct the spelling."},
    {"KS0108", "wrong-argument", "Found {0}, expected {1}.", "Correct the operation."},
    {"KS0109", "unknown-carrier", "Carrier '{0}' is not in the header.",
     "Add it to ';;Carriers:' or correct the name."},
    {"KS0110", "carrier-twice", "Carrier '{0}' stands twice in one carrier set.", "Remove one of them."},
    {"KS0111", "unknown-extension", "The extension '{0}' is kept but not simulated.", ""},
    {"KS0112", "line-ends", "Lines end with CR LF, expected LF.", "Save the file with Unix line ends."},
    {"KS0113", "not-utf8", "The line is not valid UTF-8.", "Save the file as UTF-8."},
    {"KS0114", "missing-blank", "There is no blank after ';;{0}:'.", "Write ';;{0}: value'."},
    {"KS0115", "too-many-problems", "More than {0} problems; reading stopped here.",
     "Correct the problems above first."},
    {"KS0116", "line-too-long", "The line has {0} bytes, the limit is {1}.",
     "Check that this is a text file."},
    {"KS0117", "too-many-carriers", "There are {0} carriers, the limit is {1}.", "Use fewer carriers."},
    {"KS0118", "unicode-minus", "Found a typographic minus sign, expected '-'.",
     "Replace it by the minus of the keyboard."},
    {"KS0119", "number-range", "{0} is {1}, expected {2} to {3}.", "Correct the number."},
    {"KS0120", "unknown-header", "The header ';;{0}:' is kept but not used.", ""},
    {"KS0121", "empty-file", "The file holds no operation.", "Check that the right file was chosen."},
    {"KS0122", "nul-byte", "The file holds a NUL byte.", "Check that this is a text file."},
    {"KS0123", "split-header",
     "The header line ';;{0}:' stands after the end of the header; it is used all the same.",
     "Remove the lines before it that do not begin with ';;'."},
    {"KS0124", "too-many-warnings", "More than {0} warnings; further ones are left out.",
     "Correct the warnings above first."},
    {"KS0125", "too-many-operations", "More than {0} operations; reading stopped here.",
     "Split the program."},
    {"KS0126", "byte-order-mark", "The file begins with a byte order mark.",
     "Save the file as UTF-8 without it."},
    {"KS0127", "not-this-format", "This does not look like {0}: more than {1} problems, here the first: {2}",
     "Check that the right file was chosen."},

    {"KS0130", "dat-header", "This is not a Shima DAT picture: {0}.",
     "Check that the right file was chosen."},
    {"KS0131", "dat-size", "The picture claims {0} by {1} pixels, but the file holds {2}.",
     "The file is cut off or damaged; write it again."},
    {"KS0132", "dat-run", "A run of {0} pixels goes beyond the end of its row of {1}.",
     "The file is damaged; write it again."},
    {"KS0133", "dat-layout", "No rows with option lines were found that follow each other.",
     "Only pictures laid out as the open knitout tools do can be read."},
    {"KS0134", "dat-colour", "Colour {0} at needle {1} is not known.",
     "Only the colours of the open knitout tools can be read."},
    {"KS0135", "dat-option", "Option line {0} says {1}, which is not simulated.", ""},
    {"KS0136", "dat-option-value", "Option line {0} says {1}, expected {2}.",
     "Only the values of the open knitout tools can be read."},
    {"KS0137", "dat-frame", "The fixed passes at the beginning or end are missing.",
     "Check that the picture is whole."},
    {"KS0138", "dat-sliders", "The sliders of one pass give loops back by different ways.",
     "Give them a pass each."},
    {"KS0139", "dat-cannot-write", "A Shima DAT picture cannot say this, {0}: {1}.",
     "Change the program or write knitout (.k)."},

    {"KS0140", "kcode-no-pass", "The file holds no pass of Kniterate k-code.",
     "Check that the right file was chosen."},
    {"KS0141", "kcode-order", "Found {0}, expected {1}.", "Correct the pass or write the file again."},
    {"KS0142", "kcode-text", "{0} is taken for a text that the machine shows while it waits.",
     "Check the spelling if it is none."},
    {"KS0143", "kcode-needles", "The needle line is wrong at this place.",
     "Write a margin of 15 dots, the needles as - and _, and 15 dots."},
    {"KS0144", "kcode-size", "Found the stitch size {0}, expected 0 to 9 or A to Z.", "Correct the size."},
    {"KS0145", "kcode-length", "The line has {0} places, expected {1}.",
     "Make the lines of the pass equally long."},
    {"KS0146", "kcode-between", "{0} faces no needle at racking {1}.", "Rack to a whole number first."},
    {"KS0149", "kcode-cannot-write", "Kniterate k-code cannot say this, {0}: {1}.",
     "Change the program or write knitout (.k)."},

    {"KS0150", "sintral-unknown", "{0} is no command of the Sintral subset that is read.",
     "Only the classic written form is read."},
    {"KS0151", "sintral-kept", "{0} is kept but not simulated.", ""},
    {"KS0152", "sintral-direction", "The carriage goes {0} here, but the line says {1}.",
     "Correct the direction or add an empty stroke S0."},
    {"KS0153", "jacquard-text", "The jacquard text is wrong here: {0}.", "Correct the row."},
    {"KS0154", "sintral-no-range", "It is not known which needles work.", "Write SEN=first-last."},
    {"KS0155", "sintral-missing", "There is no {0} {1}.", "Correct the number."},
    {"KS0156", "sintral-endless", "The program did not end after {0}.", "Check the repeats and jumps."},
    {"KS0157", "sintral-no-row", "The stroke chooses needles by symbols, but the jacquard has no {0}.",
     "Put the .jac file beside the .sin file and check JA1= and the repeats."},
    {"KS0158", "sintral-no-home", "Yarn carrier {0} is missing in YG.", "Add it to YG:left/right;."},
    {"KS0159", "sintral-without", "{0} stands without {1}.", "Add it or remove the command."},

    {"KS0201", "carrier-not-in", "Carrier {0} is used but was not brought in.",
     "Bring it in with 'in {0}' or 'inhook {0}'."},
    {"KS0202", "carrier-in-twice", "Carrier {0} is brought in while it is in.", "Take it out first."},
    {"KS0203", "carrier-out-unused", "Carrier {0} is taken out but is not in.", "Remove the operation."},
    {"KS0204", "hook-busy", "The yarn inserting hook already holds a yarn.", "Release it first."},
    {"KS0205", "hook-empty", "The hook is released but holds no yarn of carrier {0}.",
     "Remove the operation or bring the carrier in with 'inhook'."},
    {"KS0206", "not-aligned", "{0} does not face {1} at racking {2}.", "Rack to {3} first."},
    {"KS0207", "same-bed", "{0} and {1} lie on the same bed.", "Transfer over the other bed."},
    {"KS0208", "needle-range", "{0} lies more than {1} needles from needle 0.", "Correct the needle number."},
    {"KS0209", "slider-loop", "A slider cannot make a loop: {0}.", "Knit on {1}."},
    {"KS0210", "carrier-stays-in", "Carrier {0} is never taken out.", "End with 'out {0}' or 'outhook {0}'."},
    {"KS0211", "too-many-findings", "More than {0} problems; the rest is not listed.",
     "Correct the problems above first."},
    {"KS0212", "hook-not-released", "The yarn inserting hook still holds carrier {0} at the end.",
     "Add 'releasehook {0}' after the first stitches."},
    {"KS0213", "out-on-hook", "Carrier {0} is taken out while the hook still holds its yarn.",
     "Release the hook first with 'releasehook {0}'."},
    {"KS0214", "hook-released-early", "The hook lets go of carrier {0} before it made a stitch.",
     "Move 'releasehook {0}' behind the first stitches."},
    {"KS0215", "no-hook", "{0} has no yarn inserting hook.", "Write 'in' and 'out' for this machine."},
    {"KS0216", "hook-direction", "The first stitch after inhook of carrier {0} runs to the right.",
     "Begin with a pass to the left; the hook comes from the right."},
    {"KS0217", "hook-blocks", "{0} lies behind the hook, which waits at {1} with carrier {2}.",
     "Release the hook first."},
    {"KS0218", "rack-range", "Racking {0} is out of range, {1} goes from {2} to {3}.",
     "Move in smaller steps."},
    {"KS0219", "rack-fraction", "Racking {0} ends between the positions that {1} has: {2}.",
     "Use one of these parts of a pitch."},
    {"KS0220", "outside-bed", "{0} lies outside the bed: {1}.", "Move or narrow the piece."},
    {"KS0221", "no-sliders", "{0} names a slider, {1} has none.", "Transfer to the hook of the needle."},
    {"KS0222", "slider-to-slider", "Loops cannot go from slider {0} to slider {1}.",
     "Transfer from a slider to a hook or back."},
    {"KS0223", "sliders-hold", "{0} makes a loop while sliders hold {1}.",
     "Give the loops back to hooks first."},
    {"KS0224", "nothing-there", "{0} holds no loop to move or drop ({1}).",
     "Remove the operation if the loop was not expected."},
    {"KS0225", "carrier-kickback", "Carrier {0} stands beyond {1}, seen in the direction of the stitch.",
     "Bring it back with a miss first, or turn the direction."},
    {"KS0226", "yarn-in-the-way", "The yarn of the waiting carrier {1} lies in the way at {0} ({2}).",
     "The machine must move it aside; write a miss where that matters."},
    {"KS0227", "carriers-collide", "Carrier {0} runs into carrier {1}, which stands on the same rail.",
     "Move carrier {1} first or use another rail."},
    {"KS0228", "knit-on-empty", "{0} is empty: the loop hangs without a stitch below it ({1}).", ""},
    {"KS0229", "dropped-loop-runs", "Dropping {1} from {0} lets {2} stitches run.",
     "Draw a loop through or move the loop before it is dropped."},
    {"KS0230", "loops-left", "{0} stay on the needles at the end, from {1} to {2}.",
     "Bind off, or drop them after waste yarn."},
    {"KS0231", "too-many-loops", "{0} holds {1} loops, {2} are allowed.", "Knit before more loops come."},
    {"KS0232", "held-too-long", "The loop of {0} from line {1} waited for {2} passes, {3} are allowed.",
     "Knit it earlier."},
    {"KS0233", "long-float",
     "The yarn of carrier {0} floats {1} mm over {2} needles, {3} mm and {4} are allowed.",
     "Tuck it on the way or knit it on the other bed."},
    {"KS0234", "tuck-stack", "{0} holds {1} tucks without a stitch, {2} are allowed.",
     "Knit the needle in between."},
    {"KS0235", "overstretched",
     "{0} and {1} lie {2} mm apart, but the loops between them have {3} mm of yarn: it will break.",
     "Move in smaller steps or knit larger loops before."},
    {"KS0236", "plating-order", "The carriers {0} stitch in another order than before, {1}.",
     "Keep the order, or plating changes its face."},
    {"KS0237", "from-both-sides", "Carriers {0} and {1} come to {2} from different sides.",
     "Bring them to one side first."},
    {"KS0238", "carrier-unused", "Carrier {0} is brought in but makes no loop.", "Remove it or use it."},
    {"KS0239", "stitch-size-range", "Stitch size {0} is not in the table of {1}, which goes from {2} to {3}.",
     "Choose a size of the table; the nearest one is used."},
    {"KS0240", "other-set", "Carrier {0} was brought in together with others, but stitches as {1}.",
     "Bring in what stitches together."},
    {"KS0241", "carrier-unknown-there", "{1} has no carrier {0}.", "Choose another carrier or machine."},
    {"KS0242", "unknown-machine", "No profile fits the machine '{0}'; {1} is used.",
     "Name another machine or add its profile."},
    {"KS0243", "more-findings", "{0} further findings of {1} are not listed.",
     "Correct the ones above first."},
    {"KS0244", "no-reason", "Rule {0} is turned off without a reason.", "Write RULE=REASON."},

    {"KS0401", "no-opengl", "There is no OpenGL without a window: {0}.",
     "Install libegl1, libgl1 and libgl1-mesa-dri."},
    {"KS0402", "old-opengl", "OpenGL is {0}, expected 3.3 or newer.",
     "Update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1."},
    {"KS0403", "shader", "A shader does not build: {0}", "Check the folder resources/shaders."},
    {"KS0404", "no-picture", "The picture cannot be made: {0}.", "Choose a smaller size or a smaller part."},
    {"KS0405", "not-png", "The file is not a PNG picture: {0}.", "Choose another file."},
    {"KS0406", "not-settled", "The fabric cannot be settled as yarn: {0}.", "Settle bonding points instead."},

    {"KS0501", "chart-size", "The chart has {0} wales, {1} courses and {2} cells.",
     "Give every course one cell for each wale."},
    {"KS0502", "chart-yarn", "Wale {0} uses yarn {1}, but the chart has {2} yarns.",
     "Choose one of the chart's yarns."},
    {"KS0503", "chart-move", "The loop of wale {0} cannot move to wale {1}.",
     "Stay inside the chart and move every loop once."},
    {"KS0504", "chart-beds", "The course has {0}, which needs a chart for {1}.",
     "Choose another stitch or the other kind of chart."},
    {"KS0505", "chart-carrier-twice", "Carrier '{0}' is given to two yarns of the chart.",
     "Give every yarn its own carrier."},
    {"KS0506", "chart-nothing-to-move", "Wale {0} has no loop to move.",
     "Knit the wale before the loop moves."},
    {"KS0507", "chart-racking", "The course needs racking {0}, the machine has {1} to {2}.",
     "Move the loops less far."},
    {"KS0508", "chart-loop-left", "Wale {0} is empty here but still holds a loop.",
     "Move the loop to a neighbour or let the wale rest."},
    {"KS0509", "project-too-new", "The project has version {0}, this program knows up to {1}.",
     "Open it with a newer KnittSim."},
});

static_assert(std::is_sorted(kMessages.begin(), kMessages.end(),
                             [](const Message& a, const Message& b) { return a.id < b.id; }));

} // namespace

std::span<const Message> messages() {
    return kMessages;
}

const Message* findMessage(std::string_view id) {
    const auto* found = std::lower_bound(kMessages.begin(), kMessages.end(), id,
                                         [](const Message& m, std::string_view key) { return m.id < key; });
    return found != kMessages.end() && found->id == id ? found : nullptr;
}

std::string fillMessage(std::string_view pattern, const std::vector<std::string>& arguments) {
    std::string text;
    text.reserve(pattern.size() + 32);
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        std::size_t index = 0;
        const std::size_t close = pattern[i] == '{' ? pattern.find('}', i) : std::string_view::npos;
        if (close != std::string_view::npos) {
            const char* first = pattern.data() + i + 1;
            const char* last = pattern.data() + close;
            const auto [end, error] = std::from_chars(first, last, index);
            if (error == std::errc{} && end == last && index < arguments.size()) {
                text += arguments[index];
                i = close;
                continue;
            }
        }
        text += pattern[i];
    }
    return text;
}

std::string causeText(const Diagnostic& diagnostic) {
    const Message* message = findMessage(diagnostic.id);
    return message ? fillMessage(message->cause, diagnostic.arguments) : diagnostic.id;
}

std::string cureText(const Diagnostic& diagnostic) {
    const Message* message = findMessage(diagnostic.id);
    return message ? fillMessage(message->cure, diagnostic.arguments) : std::string();
}

std::string toLine(const Diagnostic& diagnostic) {
    std::string line;
    const Place& place = diagnostic.place;
    if (!place.file.empty()) {
        line += place.file + ':';
        if (place.line > 0) {
            line += std::to_string(place.line) + ':';
        }
        if (place.line > 0 && place.column > 0) {
            line += std::to_string(place.column) + ':';
        }
        line += ' ';
    }
    line += std::string(toString(diagnostic.severity)) + ' ' + diagnostic.id + ": " + causeText(diagnostic);
    const std::string cure = cureText(diagnostic);
    if (!cure.empty()) {
        line += ' ' + cure;
    }
    return line;
}

} // namespace knittsim
