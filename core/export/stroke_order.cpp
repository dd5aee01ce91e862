#include "core/export/stroke_order.h"

#include "core/geometry/projected_crossings.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <tuple>
#include <utility>

namespace knittsim::exports {

namespace {

using geometry::YarnCurves;

/// One strand of one crossing.
struct Pass {
    std::size_t yarn = 0;
    float arc = 0;
    std::size_t crossing = 0;
    bool front = false;
};

float arcAt(const YarnCurves& curves, std::int32_t node, float share) {
    const auto n = static_cast<std::size_t>(node);
    return curves.arc[n] + share * (curves.arc[n + 1] - curves.arc[n]);
}

class Cutter {
public:
    Cutter(const YarnCurves& curves, float mostMm, bool back)
        : m_curves(curves), m_mostMm(mostMm), m_back(back), m_crossings(projectCrossings(curves)) {
        cut();
        relate();
    }

    std::vector<Stroke> order() {
        using Ready = std::pair<float, std::size_t>; // the farthest first
        std::priority_queue<Ready, std::vector<Ready>, std::greater<>> ready;
        for (std::size_t s = 0; s < m_strokes.size(); ++s) {
            if (m_waitsFor[s] == 0) {
                ready.emplace(m_nearness[s], s);
            }
        }
        std::vector<Stroke> ordered;
        ordered.reserve(m_strokes.size());
        while (!ready.empty()) {
            const std::size_t s = ready.top().second;
            ready.pop();
            ordered.push_back(m_strokes[s]);
            for (const std::size_t over : m_over[s]) {
                if (--m_waitsFor[over] == 0) {
                    ready.emplace(m_nearness[over], over);
                }
            }
        }
        return ordered;
    }

private:
    std::vector<Pass> passes() const {
        std::vector<Pass> passes;
        passes.reserve(2 * m_crossings.size());
        for (std::size_t c = 0; c < m_crossings.size(); ++c) {
            const geometry::ProjectedCrossing& crossing = m_crossings[c];
            passes.push_back({yarnAt(m_curves, crossing.over),
                              arcAt(m_curves, crossing.over, crossing.overShare), c, !m_back});
            passes.push_back({yarnAt(m_curves, crossing.under),
                              arcAt(m_curves, crossing.under, crossing.underShare), c, m_back});
        }
        std::ranges::sort(passes, {}, [](const Pass& p) { return std::tuple(p.yarn, p.arc, p.crossing); });
        return passes;
    }

    /// Half-way between two crossings where the yarn changes from front to behind.
    void cut() {
        m_frontOf.resize(m_crossings.size());
        m_behindOf.resize(m_crossings.size());
        const std::vector<Pass> all = passes();
        auto next = all.begin();
        for (std::size_t y = 0; y < m_curves.yarns.size(); ++y) {
            const YarnCurves::Range& yarn = m_curves.yarns[y];
            const auto last = std::find_if(next, all.end(), [y](const Pass& p) { return p.yarn != y; });
            float from = 0;
            while (next != last) {
                const auto change =
                    std::find_if(next, last, [next](const Pass& p) { return p.front != next->front; });
                if (change == last) {
                    break;
                }
                const float to = 0.5F * ((change - 1)->arc + change->arc);
                addParts({y, from, to}, std::span(next, change));
                from = to;
                next = change;
            }
            const float end = m_curves.arc[static_cast<std::size_t>(yarn.first + yarn.count - 1)];
            addParts({y, from, end}, std::span(next, last));
            next = last;
        }
    }

    /// `on`: crossings of the stroke.
    void addParts(const Stroke& stroke, std::span<const Pass> on) {
        const float length = stroke.to - stroke.from;
        const auto parts = static_cast<std::size_t>(std::max(1.0F, std::ceil(length / m_mostMm)));
        const float part = length / static_cast<float>(parts);
        for (const Pass& pass : on) {
            const auto i =
                part > 0 ? static_cast<std::size_t>(std::max(0.0F, (pass.arc - stroke.from) / part)) : 0;
            (pass.front ? m_frontOf : m_behindOf)[pass.crossing] = m_strokes.size() + std::min(i, parts - 1);
        }
        for (std::size_t i = 0; i < parts; ++i) {
            add({stroke.yarn, stroke.from + part * static_cast<float>(i),
                 i + 1 < parts ? stroke.from + part * static_cast<float>(i + 1) : stroke.to});
        }
    }

    void add(const Stroke& stroke) {
        const YarnCurves::Range& yarn = m_curves.yarns[stroke.yarn];
        const auto begin = m_curves.arc.begin() + yarn.first;
        const auto end = begin + yarn.count;
        const auto first = std::lower_bound(begin, end, stroke.from) - m_curves.arc.begin();
        const auto last = std::upper_bound(begin, end, stroke.to) - m_curves.arc.begin();
        float sum = 0;
        for (auto n = first; n < last; ++n) {
            sum += m_curves.nodes[static_cast<std::size_t>(n)].z();
        }
        const auto at =
            static_cast<std::size_t>(std::min<std::ptrdiff_t>(first, yarn.first + yarn.count - 1));
        const float z = last > first ? sum / static_cast<float>(last - first) : m_curves.nodes[at].z();
        m_strokes.push_back(stroke);
        m_nearness.push_back(m_back ? -z : z);
    }

    void relate() {
        m_over.resize(m_strokes.size());
        m_waitsFor.resize(m_strokes.size(), 0);
        for (std::size_t c = 0; c < m_crossings.size(); ++c) {
            m_over[m_behindOf[c]].push_back(m_frontOf[c]);
            ++m_waitsFor[m_frontOf[c]];
        }
    }

    const YarnCurves& m_curves;
    float m_mostMm;
    bool m_back;
    std::vector<geometry::ProjectedCrossing> m_crossings;
    std::vector<std::size_t> m_frontOf, m_behindOf; ///< by crossing: the strokes
    std::vector<Stroke> m_strokes;
    std::vector<float> m_nearness;                ///< by stroke
    std::vector<std::vector<std::size_t>> m_over; ///< by stroke: those that cover it
    std::vector<std::size_t> m_waitsFor;          ///< by stroke
};

} // namespace

std::vector<Stroke> strokesInOrder(const YarnCurves& curves, float mostMm, bool back) {
    return Cutter(curves, mostMm, back).order();
}

} // namespace knittsim::exports
