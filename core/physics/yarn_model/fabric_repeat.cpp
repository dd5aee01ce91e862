#include "core/physics/yarn_model/fabric_repeat.h"

#include "core/physics/strand.h"

#include <algorithm>
#include <map>

namespace knittsim::physics {

namespace {

using fabric::Fabric;
using fabric::LoopIndex;
using Course = std::map<std::int32_t, LoopIndex>; ///< by needle number; empty where a course does not count

const machine::Loop& madeOf(const Fabric& f, LoopIndex loop) {
    return f.made.loops[static_cast<std::size_t>(loop)];
}

bool isPlainStitch(const Fabric& f, LoopIndex loop) {
    const machine::Loop& made = madeOf(f, loop);
    const auto parents = f.made.parentsOf(loop);
    return made.kind == machine::OperationKind::Knit && parents.size() == 1 &&
           madeOf(f, parents[0]).needle.index == made.needle.index;
}

std::vector<Course> findCourses(const Fabric& f) {
    std::vector<Course> courses(static_cast<std::size_t>(std::max(0, f.courseCount)));
    std::vector<char> spoilt(courses.size(), 0);
    for (std::size_t i = 0; i < f.loops.size(); ++i) {
        const auto loop = static_cast<LoopIndex>(i);
        const auto course = static_cast<std::size_t>(f.loops[i].course);
        const bool alone = courses[course].emplace(madeOf(f, loop).needle.index, loop).second;
        if (!alone || !isPlainStitch(f, loop)) {
            spoilt[course] = 1;
        }
    }
    for (std::size_t c = 0; c < courses.size(); ++c) {
        const Course& course = courses[c];
        if (spoilt[c] != 0 || course.size() < 4 ||
            course.rbegin()->first - course.begin()->first + 1 != static_cast<std::int32_t>(course.size())) {
            courses[c].clear();
        }
    }
    return courses;
}

bool belongTogether(const Fabric& f, const Course& a, const Course& b) {
    return !a.empty() && a.size() == b.size() && a.begin()->first == b.begin()->first &&
           std::all_of(b.begin(), b.end(), [&](const auto& stitch) {
               return madeOf(f, stitch.second).carrier == madeOf(f, a.begin()->second).carrier;
           });
}

/// Knit and purl of a part of the fabric, and yarn by stitch.
struct Part {
    int wales = 0;
    int courses = 0;
    std::vector<int> faces;
    std::vector<double> lengths;

    std::size_t index(int wale, int course) const { return static_cast<std::size_t>(course * wales + wale); }

    bool repeats(int right, int up) const {
        for (int course = 0; course + up < courses; ++course) {
            for (int wale = 0; wale + right < wales; ++wale) {
                if (faces[index(wale, course)] != faces[index(wale + right, course + up)]) {
                    return false;
                }
            }
        }
        return true;
    }
};

Part partOf(const Fabric& f, const std::vector<Course>& courses, std::size_t first, std::size_t count) {
    Part part{static_cast<int>(courses[first].size()) - 2, static_cast<int>(count), {}, {}};
    for (std::size_t c = first; c < first + count; ++c) {
        // The wales at the edges turn into the next course.
        for (auto stitch = std::next(courses[c].begin()); std::next(stitch) != courses[c].end(); ++stitch) {
            const machine::Loop& made = madeOf(f, stitch->second);
            part.faces.push_back(faceOf(f, stitch->second));
            part.lengths.push_back(made.lengthMm + made.floatMm);
        }
    }
    return part;
}

/// The first stitches of the part, their yarn averaged over all repeats.
Repeat repeatOf(const Part& part, int wales, int courses) {
    Repeat repeat{{wales, courses, {}}, {}};
    for (int course = 0; course < courses; ++course) {
        for (int wale = 0; wale < wales; ++wale) {
            double sum = 0;
            int count = 0;
            for (int c = course; c < part.courses; c += courses) {
                for (int w = wale; w < part.wales; w += wales) {
                    sum += part.lengths[part.index(w, c)];
                    ++count;
                }
            }
            repeat.pattern.faces.push_back(part.faces[part.index(wale, course)]);
            repeat.loopLengths.push_back(sum / count);
        }
    }
    return repeat;
}

} // namespace

std::optional<FabricRepeat> findFabricRepeat(const Fabric& f) {
    const std::vector<Course> courses = findCourses(f);
    std::size_t best = 0;
    std::size_t bestCount = 0;
    for (std::size_t first = 0; first < courses.size();) {
        std::size_t end = first + 1;
        while (end < courses.size() && belongTogether(f, courses[first], courses[end])) {
            ++end;
        }
        if (!courses[first].empty() && end - first > bestCount) {
            best = first;
            bestCount = end - first;
        }
        first = end;
    }
    if (bestCount < 2 || 2 * bestCount * courses[best].size() < f.loops.size()) {
        return std::nullopt;
    }
    const Part part = partOf(f, courses, best, bestCount);
    const auto smallest = [](int size, auto repeats) {
        for (int period = 1; period <= std::min(size / 2, kLargestRepeat); ++period) {
            if (repeats(period)) {
                return period;
            }
        }
        return 0;
    };
    const int across = smallest(part.wales, [&](int p) { return part.repeats(p, 0); });
    const int up = smallest(part.courses, [&](int p) { return part.repeats(0, p); });
    if (across == 0 || up == 0) {
        return std::nullopt;
    }
    return FabricRepeat{repeatOf(part, across, up), madeOf(f, courses[best].begin()->second).carrier,
                        static_cast<int>(best), part.wales, part.courses};
}

} // namespace knittsim::physics
