#include "core/pattern/samples.h"

#include "core/formats/knitout/writer.h"
#include "core/pattern/compile.h"
#include "core/pattern/sample_charts.h"
#include "core/pattern/swatch.h"

#include <fmt/format.h>

#include <algorithm>

namespace knittsim::pattern {

namespace {

struct Entry {
    Sample sample;
    Chart (*chart)();
};

Chart dyed(Chart chart, const char* carrier, yarn::Colour colour, const char* libraryId) {
    chart.yarns = {{.carrier = carrier, .colour = colour, .libraryId = libraryId}};
    return chart;
}

const std::vector<Entry>& entries() {
    static const std::vector<Entry> kEntries{
        {{"plain", "Plain", "All stitches on the front bed: the edges curl."},
         [] {
             return dyed(plainChart(28, 36), "1", {0xe9, 0xdf, 0xc8}, "merino-2-30");
         }},
        {{"reverse-plain", "Reverse plain", "All stitches on the rear bed: the technical back of plain."},
         [] {
             return dyed(ribChart(28, 36, 0, 1), "2", {0x24, 0x3b, 0x5e}, "merino-2-48");
         }},
        {{"rib-1x1", "Rib 1x1", "Front and rear wales alternate: narrow, thick and very stretchy."},
         [] {
             return dyed(ribChart(29, 36), "3", {0xb5, 0x52, 0x33}, "acrylic-hb-2-28");
         }},
        {{"rib-2x2", "Rib 2x2", "Two front wales, two rear wales."},
         [] {
             return dyed(ribChart(30, 36, 2, 2), "4", {0x3f, 0x6b, 0x4f}, "acrylic-hb-2-28");
         }},
        {{"garter", "Garter",
          "Courses alternate between the beds; all loops change beds before each course."},
         [] {
             return dyed(garterChart(26, 40), "5", {0xd9, 0xa6, 0x2e}, "acrylic-hb-2-28");
         }},
        {{"seed", "Seed", "Knit and purl like a chess board of single stitches."},
         [] {
             return dyed(seedChart(26, 36), "6", {0x6d, 0x35, 0x5a}, "viscose-2-30");
         }},
        {{"moss", "Moss", "Knit and purl like a chess board, two courses high."},
         [] {
             return dyed(mossChart(26, 36), "8", {0x1f, 0x6f, 0x78}, "merino-2-48");
         }},
        {{"cable-left", "Cable 2x2, left", "Two loops pass in front of two others to the left."},
         [] { return cableChart(Front::Right); }},
        {{"cable-right", "Cable 2x2, right", "Two loops pass in front of two others to the right."},
         [] { return cableChart(Front::Left); }},
        {{"cable-braid", "Braid", "Three strands of two wales, crossed right and left in turn."}, braidChart},
        {{"lace", "Lace", "Loops stacked on their neighbours leave eyelets in lines that meet."}, laceChart},
        {{"ladder", "Ladders", "Needles out of work leave rungs of bare yarn between the stitches."},
         ladderChart},
        {{"tuck", "Tuck", "Held loops take two tucks each and push the courses apart."}, tuckChart},
        {{"slip", "Slip stitch", "The yarn misses held loops, which draw two colours over each other."},
         slipChart},
        {{"float-jacquard", "Float jacquard", "Two colours in every course, each floating behind the other."},
         floatJacquardChart},
        {{"intarsia", "Intarsia", "Three yarns, each in its own zone, joined by tucks."}, intarsiaChart},
        {{"tube", "Tube", "The front bed one way, the rear bed back: a seamless tube."}, tubeChart},
        {{"short-rows", "Short rows", "The carrier turns earlier each time: wedges that bend the fabric."},
         shortRowsChart},
        {{"racked-rib", "Racked rib",
          "All needles of both beds, the rear bed shifted from course to course."},
         rackedRibChart},
        {{"transfer-demo", "Transfers",
          "Two strands wander over a purl ground, then both edges are narrowed."},
         transferChart},
    };
    return kEntries;
}

const Entry* find(std::string_view id) {
    const auto found =
        std::ranges::find_if(entries(), [&](const Entry& entry) { return entry.sample.id == id; });
    return found == entries().end() ? nullptr : &*found;
}

} // namespace

const std::vector<Sample>& samples() {
    static const std::vector<Sample> kSamples = [] {
        std::vector<Sample> list;
        for (const Entry& entry : entries()) {
            list.push_back(entry.sample);
        }
        return list;
    }();
    return kSamples;
}

Chart sampleChart(std::string_view id) {
    const Entry* entry = find(id);
    return entry ? entry->chart() : Chart();
}

machine::Program makeSample(std::string_view id) {
    Result<machine::Program> program = compile(sampleChart(id));
    return program ? std::move(program).value() : machine::Program{};
}

std::string sampleText(std::string_view id) {
    const Entry* entry = find(id);
    if (!entry) {
        return {};
    }
    std::string text = formats::knitout::write(makeSample(id));
    // The header ends with the first line that does not begin with ";;"; the first line begins with ";!".
    std::size_t end = text.find('\n') + 1;
    while (text.compare(end, 2, ";;") == 0) {
        end = text.find('\n', end) + 1;
    }
    const Chart chart = entry->chart();
    return text.insert(end, fmt::format("; {}: {}\n; {} wales x {} courses, made by knittsim-make-samples.\n",
                                        entry->sample.title, entry->sample.description, chart.width,
                                        chart.height()));
}

} // namespace knittsim::pattern
