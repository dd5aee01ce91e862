#include "core/pattern/catalogue.h"

#include "core/pattern/chart_edit.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace knittsim::pattern {

namespace {

/// Courses from the top, as one sees them: k knit, p purl, t tuck, m miss, . empty.
Chart drawn(std::initializer_list<std::string_view> rows) {
    Chart part(static_cast<int>(rows.begin()->size()), static_cast<int>(rows.size()));
    int course = part.height();
    for (const std::string_view row : rows) {
        --course;
        for (int wale = 0; wale < part.width; ++wale) {
            switch (row[static_cast<std::size_t>(wale)]) {
            case 'p':
                part.at(wale, course).stitch = Stitch::Purl;
                break;
            case 't':
                part.at(wale, course).stitch = Stitch::Tuck;
                break;
            case 'm':
                part.at(wale, course).stitch = Stitch::Miss;
                break;
            case '.':
                part.at(wale, course).stitch = Stitch::Empty;
                break;
            default:
                break;
            }
        }
    }
    return part;
}

Chart moved(Chart part, int course, const std::vector<LoopMove>& moves) {
    auto& own = part.course(course).moves;
    own.insert(own.end(), moves.begin(), moves.end());
    return part;
}

/// Two groups of loops change places, and courses until they may again.
Chart cable(int left, int right, Front front) {
    return moved(Chart(left + right, std::max(4, left + right)), 1, cross(0, left, right, front));
}

/// Wide ones have a wale of ground on both sides: beside each other they would need more yarn than loops
/// have.
Chart wideCable(int strand, Front front) {
    return moved(Chart(2 * strand + 2, 2 * strand + 2), 2, cross(1, strand, strand, front));
}

/// Loop by loop is drawn over its neighbour and knitted with it.
Chart bindOff(int wales) {
    Chart part(wales, wales - 1, Stitch::Rest);
    for (int c = 0; c < part.height(); ++c) {
        for (int w = 0; w <= c; ++w) {
            part.at(w, c).stitch = Stitch::Empty;
        }
        part.at(c + 1, c).stitch = Stitch::Knit;
        part.course(c).moves = {{c, c + 1}};
    }
    return part;
}

Chart mirrored(Chart part) {
    mirror(part, {0, 0, part.width, part.height()}, Mirror::LeftRight);
    return part;
}

/// Three strands, the left and the right pair in turn.
Chart braid(int strand) {
    Chart part(3 * strand, 4 * strand);
    part = moved(part, 1, cross(0, strand, strand, Front::Right));
    return moved(part, 1 + 2 * strand, cross(strand, strand, strand, Front::Left));
}

/// Two crosses beside each other lean against each other.
Chart doubleCable(int strand, bool inwards) {
    Chart part(4 * strand, 2 + 2 * strand);
    part = moved(part, 1, cross(0, strand, strand, inwards ? Front::Right : Front::Left));
    return moved(part, 1, cross(2 * strand, strand, strand, inwards ? Front::Left : Front::Right));
}

/// Eyelets in a slanting line, a wale farther every second course.
Chart slantingLace(int wales, int step) {
    Chart part(wales, 2 * wales);
    for (int i = 0; i < wales; ++i) {
        const int at = step > 0 ? i : wales - 1 - i;
        const int to = at + step;
        if (to >= 0 && to < wales) {
            part.course(2 * i + 1).moves.push_back({at, to});
        }
    }
    return part;
}

/// Eyelets to both sides that meet in a stack of three.
Chart leafLace() {
    Chart part(7, 8);
    for (int i = 0; i < 3; ++i) {
        part.course(2 * i + 1).moves = {{i, i + 1}, {6 - i, 5 - i}};
    }
    return part;
}

std::vector<Module> makeCatalogue() {
    using enum ModuleGroup;
    std::vector<Module> all{
        {"knit", "Plain", Texture, drawn({"k"})},
        {"purl", "Reverse plain", Texture, drawn({"p"})},
        {"rib-1x1", "Rib 1x1", Texture, drawn({"kp"})},
        {"rib-2x2", "Rib 2x2", Texture, drawn({"kkpp"})},
        {"rib-3x1", "Rib 3x1", Texture, drawn({"kkkp"})},
        {"broken-rib", "Broken rib", Texture, drawn({"kk", "kp"})},
        {"garter", "Garter", Texture, drawn({"p", "k"})},
        {"ridges", "Purl ridges", Texture, drawn({"p", "k", "k", "k"})},
        {"seed", "Seed", Texture, drawn({"pk", "kp"})},
        {"moss", "Moss", Texture, drawn({"pk", "pk", "kp", "kp"})},
        {"basket-2", "Basket weave 2x2", Texture, drawn({"ppkk", "ppkk", "kkpp", "kkpp"})},
        {"basket-4", "Basket weave 4x4", Texture,
         drawn({"ppppkkkk", "ppppkkkk", "ppppkkkk", "ppppkkkk", "kkkkpppp", "kkkkpppp", "kkkkpppp",
                "kkkkpppp"})},
        {"diagonal", "Diagonal", Texture, drawn({"pkkp", "kkpp", "kppk", "ppkk"})},
        {"chevron", "Chevron", Texture, drawn({"pkkkkkkp", "kpkkkkpk", "kkpkkpkk", "kkkppkkk"})},
        {"dots", "Purl dots", Texture, drawn({"kkkk", "kkkp", "kkkk", "kpkk"})},
    };
    for (const auto& [left, right] : {std::pair{1, 1}, {2, 1}, {1, 2}, {2, 2}}) {
        const std::string size = std::to_string(left) + 'x' + std::to_string(right);
        all.push_back(
            {"cable-" + size + "-left", "Cable " + size + ", left", Cable, cable(left, right, Front::Right)});
        all.push_back({"cable-" + size + "-right", "Cable " + size + ", right", Cable,
                       cable(left, right, Front::Left)});
    }
    std::vector<Module> rest{
        {"cable-3x3-left", "Cable 3x3, left", Cable, wideCable(3, Front::Right)},
        {"cable-3x3-right", "Cable 3x3, right", Cable, wideCable(3, Front::Left)},
        {"braid-2", "Braid of three strands", Cable, braid(2)},
        {"cable-in", "Double cable, inwards", Cable, doubleCable(2, true)},
        {"cable-out", "Double cable, outwards", Cable, doubleCable(2, false)},
        {"eyelet-right", "Eyelet, loop to the right", Lace, moved(drawn({"kkkk", "kkkk"}), 1, {{1, 2}})},
        {"eyelet-left", "Eyelet, loop to the left", Lace, moved(drawn({"kkkk", "kkkk"}), 1, {{2, 1}})},
        {"eyelet-double", "Two eyelets, stack of three", Lace,
         moved(drawn({"kkkkk", "kkkkk"}), 1, {{1, 2}, {3, 2}})},
        {"mesh", "Mesh", Lace, moved(moved(drawn({"kk", "kk", "kk", "kk"}), 1, {{0, 1}}), 3, {{1, 0}})},
        {"lace-right", "Lace line, right", Lace, slantingLace(6, 1)},
        {"lace-left", "Lace line, left", Lace, slantingLace(6, -1)},
        {"leaf", "Leaf lace", Lace, leafLace()},
        {"tuck-chess", "Tuck, like a chess board", TuckAndSlip, drawn({"kk", "tk", "kk", "kt"})},
        {"tuck-double", "Double tuck", TuckAndSlip, drawn({"kk", "tk", "tk", "kk", "kt", "kt"})},
        {"tuck-bramble", "Tuck bramble", TuckAndSlip,
         drawn({"kkkk", "tkkk", "tkkk", "tkkk", "kkkk", "kktk", "kktk", "kktk"})},
        {"slip-chess", "Slip, like a chess board", TuckAndSlip, drawn({"kk", "mk", "kk", "km"})},
        {"slip-long", "Long slip stitch", TuckAndSlip, drawn({"kkk", "kmk", "kmk", "kmk"})},
        {"slip-float", "Slip, floats of three", TuckAndSlip, drawn({"kkkk", "mmmk", "kkkk", "kmmm"})},
        {"narrow-left", "Narrowing at the left edge", Shaping, moved(drawn({".kkk"}), 0, {{0, 1}}), false},
        {"narrow-right", "Narrowing at the right edge", Shaping, moved(drawn({"kkk."}), 0, {{3, 2}}), false},
        {"cast-on-second", "Cast-on, every second needle", Shaping, drawn({"mt", "tm"})},
        {"cast-on-fourth", "Cast-on, every fourth needle", Shaping, drawn({"mmmt", "mmtm", "mtmm", "tmmm"})},
        {"bind-off-right", "Bind off at the left edge", Shaping, bindOff(6), false},
        {"bind-off-left", "Bind off at the right edge", Shaping, mirrored(bindOff(6)), false},
    };
    std::ranges::move(rest, std::back_inserter(all));
    return all;
}

} // namespace

const std::vector<Module>& catalogue() {
    static const std::vector<Module> kAll = makeCatalogue();
    return kAll;
}

const Module* findModule(std::string_view id) {
    const auto found = std::ranges::find(catalogue(), id, &Module::id);
    return found == catalogue().end() ? nullptr : &*found;
}

} // namespace knittsim::pattern
