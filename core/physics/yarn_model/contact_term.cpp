#include "core/physics/yarn_model/contact_term.h"

#include <cmath>

namespace knittsim::physics {

namespace {
constexpr double kSkin = 0.3;   ///< outer diameters of the thickest yarn
constexpr double kTiny = 1e-12; ///< below, two nodes have no direction between them
} // namespace

ContactTerm::ContactTerm(const YarnChains& chains)
    : m_yarns(chains.yarns), m_own(chains), m_share(nodeLengths(chains)), m_nodeCount(chains.nodeCount()),
      m_cell(chains.cellEntry()), m_hessian(chains.cellEntry()),
      m_skin(chains.nodeCount(), chains.cellEntry(), kSkin * thickestYarn(chains.yarns)) {
    setThickness(1);
}

void ContactTerm::setThickness(double share) {
    m_thickness = share;
    m_kernels.clear();
    for (const RodYarn& a : m_yarns) {
        for (const RodYarn& b : m_yarns) {
            m_kernels.emplace_back(0.5 * share * (a.coreDiameter + b.coreDiameter),
                                   0.5 * share * (a.outerDiameter + b.outerDiameter),
                                   std::sqrt(a.contactStiffness * b.contactStiffness));
        }
    }
    m_skin.forget();
}

std::uint32_t ContactTerm::kernelOf(int yarnA, int yarnB) const {
    return static_cast<std::uint32_t>(static_cast<std::size_t>(yarnA) * m_yarns.size() +
                                      static_cast<std::size_t>(yarnB));
}

/// Both nodes on one piece of yarn too short to touch itself.
bool ContactTerm::sameStretch(const NearPair& pair) const {
    const RodYarn& yarn = m_yarns[static_cast<std::size_t>(m_own.yarnOf(pair.a))];
    return m_own.along(pair.a, pair.b) < OwnStretch::kExclusion * 0.5 * yarn.outerDiameter;
}

void ContactTerm::addCandidates(const std::vector<NearPair>& pairs) const {
    for (const NearPair& pair : pairs) {
        if (sameStretch(pair)) {
            continue;
        }
        const double weight =
            2 * m_share[static_cast<std::size_t>(pair.a)] * m_share[static_cast<std::size_t>(pair.b.node)];
        m_candidates.push_back(
            {pair.a, pair.b, kernelOf(m_own.yarnOf(pair.a), m_own.yarnOf(pair.b.node)), weight});
    }
}

void ContactTerm::prepare(const Vector& x) const {
    const double range = m_thickness * thickestYarn(m_yarns);
    const Skin::Age age = m_skin.renew(x, range);
    if (age == Skin::Age::Fresh) {
        return;
    }
    ++m_rebuilds;
    const Eigen::Matrix3Xd points =
        Eigen::Map<const Eigen::Matrix3Xd>(m_skin.reference().data(), 3, m_nodeCount);
    if (age == Skin::Age::Partly) {
        std::vector<char> moved(static_cast<std::size_t>(m_nodeCount));
        for (Entry e = 0; e < m_nodeCount; ++e) {
            moved[static_cast<std::size_t>(e)] = m_skin.moved(e) ? 1 : 0;
        }
        std::erase_if(m_candidates,
                      [&](const Candidate& c) { return m_skin.moved(c.a) || m_skin.moved(c.b.node); });
        addCandidates(findNearPairsOf(points, moved, range + m_skin.thickness()));
        return;
    }
    m_candidates.clear();
    const std::optional<Eigen::Vector2d> cell = cellAt(x, m_cell);
    if (x.allFinite() && (!cell || cell->minCoeff() > 0)) {
        addCandidates(findNearPairs(points, cell, range + m_skin.thickness()));
    }
}

double ContactTerm::evaluate(const Vector& x, Vector* gradient) const {
    prepare(x);
    double energy = 0;
    for (const Candidate& c : m_candidates) {
        const ContactKernel& kernel = m_kernels[c.kernel];
        const Eigen::Vector3d apart = position(x, m_cell, c.b) - at(x, c.a);
        const double square = apart.squaredNorm();
        if (square >= kernel.reach() * kernel.reach()) {
            continue;
        }
        const double distance = std::sqrt(square);
        const ContactKernel::Value v = kernel.at(distance);
        energy += c.weight * v.energy;
        if (gradient != nullptr && distance > kTiny) {
            const Eigen::Vector3d force = (c.weight * v.slope / distance) * apart;
            at(*gradient, c.a) -= force;
            addAt(*gradient, m_cell, c.b, force);
        }
    }
    return energy;
}

std::vector<Press<2>> ContactTerm::presses(const Vector& x) const {
    prepare(x);
    std::vector<Press<2>> result;
    for (const Candidate& c : m_candidates) {
        const Eigen::Vector3d apart = position(x, m_cell, c.b) - at(x, c.a);
        const double distance = apart.norm();
        if (distance < m_kernels[c.kernel].reach() && distance > kTiny) {
            result.push_back({{{Place{c.a, 0, 0}, c.b}, {-1, 1}},
                              apart / distance,
                              -c.weight * m_kernels[c.kernel].at(distance).slope});
        }
    }
    return result;
}

void ContactTerm::linearise(const Vector& x) {
    prepare(x);
    m_hessian.parts().clear();
    for (const Candidate& c : m_candidates) {
        const ContactKernel& kernel = m_kernels[c.kernel];
        const Eigen::Vector3d apart = position(x, m_cell, c.b) - at(x, c.a);
        const double distance = apart.norm();
        if (distance >= kernel.reach() || distance <= kTiny) {
            continue;
        }
        const Eigen::Vector3d n = apart / distance;
        const double stiffness = c.weight * kernel.at(distance).curvature;
        m_hessian.parts().push_back({{{Place{c.a, 0, 0}, c.b}, {-1, 1}}, stiffness * n * n.transpose()});
    }
    m_pairCount = m_hessian.parts().size();
}

} // namespace knittsim::physics
