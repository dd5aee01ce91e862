#include "core/physics/yarn_model/hard_core_term.h"

#include "core/base/segment_distance.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {
constexpr double kSkin = 0.3; ///< outer diameters of the thickest yarn
constexpr double kTiny = 1e-12;
constexpr double kUsualOff =
    0.16; ///< about the mean square of how far two places are off the middles of segments

double square(double v) {
    return v * v;
}
} // namespace

HardCoreTerm::HardCoreTerm(const YarnChains& chains)
    : m_own(chains), m_yarns(chains.yarns), m_cell(chains.cellEntry()), m_hessian(chains.cellEntry()),
      m_skin(chains.nodeCount(), chains.cellEntry(), kSkin * thickestYarn(chains.yarns)) {
    for (const Chain& chain : chains.chains) {
        const RodYarn& yarn = m_yarns[static_cast<std::size_t>(chain.yarn)];
        for (Entry i = 0; i < chain.segmentCount(); ++i) {
            const double rest = chains.restLength[static_cast<std::size_t>(chain.first + i)];
            m_segments.push_back({chain.place(i), chain.place(i + 1), rest,
                                  OwnStretch::kExclusion * 0.5 * yarn.outerDiameter + rest,
                                  static_cast<std::size_t>(chain.yarn)});
        }
    }
    setThickness(1);
}

void HardCoreTerm::setThickness(double share) {
    m_thickness = share;
    m_kernels.clear();
    m_reach = 0;
    for (const RodYarn& a : m_yarns) {
        for (const RodYarn& b : m_yarns) {
            const double core = 0.5 * share * (a.coreDiameter + b.coreDiameter);
            const double stiffness = kStiffness * std::sqrt(a.contactStiffness * b.contactStiffness);
            m_kernels.push_back({ContactKernel(core, kReach * core, stiffness), kSmoothing * core * core});
            m_reach = std::max(m_reach, kReach * core);
        }
    }
    m_skin.forget();
}

void HardCoreTerm::prepare(const Vector& x) const {
    const Skin::Age age = m_skin.renew(x, m_reach);
    if (age == Skin::Age::Fresh) {
        return;
    }
    const Vector& places = m_skin.reference();
    Eigen::Matrix3Xd middles(3, static_cast<Eigen::Index>(m_segments.size()));
    std::vector<char> moved(m_segments.size(), 0);
    double longest = 0;
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        const Segment& s = m_segments[i];
        const Eigen::Vector3d begin = position(places, m_cell, s.begin);
        const Eigen::Vector3d end = position(places, m_cell, s.end);
        middles.col(static_cast<Eigen::Index>(i)) = 0.5 * (begin + end);
        longest = std::max(longest, (end - begin).norm());
        moved[i] =
            age == Skin::Age::Partly && (m_skin.moved(s.begin.node) || m_skin.moved(s.end.node)) ? 1 : 0;
    }
    const double range = m_reach + m_skin.thickness() + longest;
    if (age == Skin::Age::Partly) {
        std::erase_if(m_candidates, [&](const Candidate& c) {
            return std::ranges::any_of(c.places, [&](const Place& p) { return m_skin.moved(p.node); });
        });
        for (const NearPair& pair : findNearPairsOf(middles, moved, range)) {
            addCandidate(pair);
        }
        return;
    }
    m_candidates.clear();
    const std::optional<Eigen::Vector2d> cell = cellAt(x, m_cell);
    if (x.allFinite() && (!cell || cell->minCoeff() > 0)) {
        for (const NearPair& pair : findNearPairs(middles, cell, range)) {
            addCandidate(pair);
        }
    }
}

void HardCoreTerm::addCandidate(const NearPair& pair) const {
    const Segment& a = m_segments[static_cast<std::size_t>(pair.a)];
    const Segment& b = m_segments[static_cast<std::size_t>(pair.b.node)];
    const Place begin = b.begin.shifted(pair.b.across, pair.b.up);
    const Place end = b.end.shifted(pair.b.across, pair.b.up);
    if (m_own.along(a.begin.node, begin) < a.exclusion) {
        return;
    }
    const Vector& x = m_skin.reference();
    const double distance = closestPoints(position(x, m_cell, a.begin), position(x, m_cell, a.end),
                                          position(x, m_cell, begin), position(x, m_cell, end))
                                .distance;
    if (distance < m_reach + m_skin.thickness()) {
        m_candidates.push_back(
            {{a.begin, a.end, begin, end}, a.yarn * m_yarns.size() + b.yarn, 2 * a.rest * b.rest});
    }
}

template<class Visit> void HardCoreTerm::forTouches(const Vector& x, double ahead, Visit visit) const {
    prepare(x);
    for (const Candidate& c : m_candidates) {
        const Eigen::Vector3d a0 = position(x, m_cell, c.places[0]);
        const Eigen::Vector3d a1 = position(x, m_cell, c.places[1]);
        const Eigen::Vector3d b0 = position(x, m_cell, c.places[2]);
        const Eigen::Vector3d b1 = position(x, m_cell, c.places[3]);
        const Kernel& kernel = m_kernels[c.kernel];
        const double most = (1 + ahead) * kernel.value.reach();
        const double reach = std::sqrt(square(most) + kUsualOff * kernel.smoothing);
        // Balls around the segments: most candidates are not that near.
        const double balls = reach + 0.5 * ((a1 - a0).norm() + (b1 - b0).norm());
        if ((b0 + b1 - a0 - a1).squaredNorm() >= 4 * balls * balls) {
            continue;
        }
        const ClosestPoints closest = closestPoints(a0, a1, b0, b1, kernel.smoothing);
        const double off = square(closest.s - 0.5) + square(closest.t - 0.5) - kUsualOff;
        const double distance = std::sqrt(std::max(0.0, square(closest.distance) + kernel.smoothing * off));
        if (distance >= most || distance <= kTiny) {
            continue;
        }
        const Eigen::Vector3d apart = b0 + closest.t * (b1 - b0) - a0 - closest.s * (a1 - a0);
        ContactKernel::Value value = kernel.value.at(std::min(distance, (1 - ahead) * kernel.value.reach()));
        const double lever = closest.distance / distance; // what `distance` grows when `apart` does
        value.energy *= c.weight;
        value.slope *= c.weight * lever;
        value.curvature *= c.weight * lever * lever;
        visit(Touch{{c.places, {closest.s - 1, -closest.s, 1 - closest.t, closest.t}},
                    apart / closest.distance,
                    value});
    }
}

double HardCoreTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    forTouches(x, 0, [&](const Touch& touch) {
        energy += touch.value.energy;
        if (gradient != nullptr) {
            touch.apart.spread(touch.value.slope * touch.direction, *gradient, m_cell);
        }
    });
    return energy;
}

std::vector<Press<4>> HardCoreTerm::presses(const Vector& x) const {
    std::vector<Press<4>> result;
    forTouches(x, 0, [&](const Touch& touch) {
        result.push_back({touch.apart, touch.direction, -touch.value.slope});
    });
    return result;
}

void HardCoreTerm::linearise(const Vector& x) {
    m_hessian.parts().clear();
    forTouches(x, kAhead, [&](const Touch& touch) {
        m_hessian.parts().push_back(
            {touch.apart, touch.value.curvature * touch.direction * touch.direction.transpose()});
    });
}

} // namespace knittsim::physics
