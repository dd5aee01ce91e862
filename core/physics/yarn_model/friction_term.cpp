#include "core/physics/yarn_model/friction_term.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {

constexpr double kTiny = 1e-14; ///< below, a slip has no direction
/// Square of the sine of the angle about which crossing yarns become yarns side by side.
constexpr double kSideBySide = 0.05;

Eigen::Vector3d across(const Eigen::Vector3d& normal, const Eigen::Vector3d& v) {
    return v - normal.dot(v) * normal;
}

/// `v` without its parts along the unit vectors a and b; less and less of b's where they are nearly one.
Eigen::Vector3d acrossBoth(const Eigen::Vector3d& v, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3d other = across(a, b);
    const Eigen::Vector3d rest = across(a, v);
    return rest - other * (other.dot(rest) / (other.squaredNorm() + kSideBySide));
}

/// A number of its own for every pair of places (of fewer than 16 million nodes).
template<std::size_t Count> std::uint64_t nameOf(const Stencil<Count>& apart) {
    const Place& a = apart.places.front();
    const Place& b = apart.places.back();
    const auto byte = [](int i) { return static_cast<std::uint64_t>(static_cast<std::uint8_t>(i)); };
    return static_cast<std::uint64_t>(a.node) << 40U | static_cast<std::uint64_t>(b.node) << 16U |
           byte(b.across) << 8U | byte(b.up);
}

} // namespace

FrictionTerm::FrictionTerm(const YarnChains& chains)
    : m_friction(static_cast<std::size_t>(chains.nodeCount())), m_before(m_friction.size()),
      m_after(m_friction.size()), m_cell(chains.cellEntry()),
      m_threshold(kThreshold * thickestYarn(chains.yarns)), m_reference(chains.start()),
      m_shellHessian(m_cell), m_coreHessian(m_cell) {
    for (const Chain& c : chains.chains) {
        for (Entry i = 0; i < c.count; ++i) {
            const auto node = static_cast<std::size_t>(c.first + i);
            m_friction[node] = chains.yarns[static_cast<std::size_t>(c.yarn)].friction;
            m_before[node] = c.place(c.closed || i > 0 ? i - 1 : i);
            m_after[node] = c.place(c.closed || i + 1 < c.count ? i + 1 : i);
        }
    }
}

Eigen::Vector3d FrictionTerm::tangentAt(const Vector& x, Entry node) const {
    const auto i = static_cast<std::size_t>(node);
    return (position(x, m_cell, m_after[i]) - position(x, m_cell, m_before[i])).normalized();
}

template<std::size_t Count>
void FrictionTerm::keepStrains(const Rubs<Count>& rubs, const Vector& x, Strains& strains) const {
    strains.clear();
    for (const Rub<Count>& rub : rubs) {
        const Eigen::Vector3d slip = slipOf(rub, x);
        strains[nameOf(rub.apart)] = slip * std::min(1.0, m_threshold / std::max(slip.norm(), kTiny));
    }
}

void FrictionTerm::holdAt(const Vector& reference) {
    keepStrains(m_shells, reference, m_shellStrains);
    keepStrains(m_cores, reference, m_coreStrains);
    m_reference = reference;
}

template<std::size_t Count>
void FrictionTerm::lagOn(const std::vector<Press<Count>>& presses, const Strains& strains, const Vector& x,
                         Rubs<Count>& rubs) const {
    rubs.clear();
    for (const Press<Count>& press : presses) {
        const Entry a = press.apart.places.front().node;
        const Entry b = press.apart.places.back().node;
        const Eigen::Vector3d normal = acrossBoth(press.direction, tangentAt(x, a), tangentAt(x, b));
        const double size = normal.norm();
        const double friction =
            0.5 * (m_friction[static_cast<std::size_t>(a)] + m_friction[static_cast<std::size_t>(b)]);
        if (size > kTiny && friction > 0) {
            const auto known = strains.find(nameOf(press.apart));
            const Eigen::Vector3d strain = known == strains.end() ? Eigen::Vector3d(0, 0, 0) : known->second;
            rubs.push_back({press.apart, press.apart.of(m_reference, m_cell), across(normal / size, strain),
                            normal / size, friction * size * press.force});
        }
    }
}

void FrictionTerm::lag(const ContactTerm& shells, const HardCoreTerm& cores, const Vector& x) {
    lagOn(shells.presses(x), m_shellStrains, x, m_shells);
    lagOn(cores.presses(x), m_coreStrains, x, m_cores);
}

double FrictionTerm::limit() const {
    double sum = 0;
    for (const auto& rub : m_shells) {
        sum += rub.limit;
    }
    for (const auto& rub : m_cores) {
        sum += rub.limit;
    }
    return sum;
}

double FrictionTerm::largestSlip(const Vector& x) const {
    double square = 0;
    const auto look = [&](const auto& rubs) {
        for (const auto& rub : rubs) {
            square = std::max(square, (slipOf(rub, x) - rub.strain).squaredNorm());
        }
    };
    look(m_shells);
    look(m_cores);
    return std::sqrt(square);
}

template<std::size_t Count>
double FrictionTerm::evaluateOn(const Rubs<Count>& rubs, const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (const Rub<Count>& rub : rubs) {
        const Eigen::Vector3d slip = slipOf(rub, x);
        const double size = slip.norm();
        const double share = size / m_threshold;
        const bool slides = share >= 1;
        const double dry = slides ? size : m_threshold * (share * share * (1 - share / 3) + 1.0 / 3);
        const Eigen::Vector3d way = slip - rub.strain;
        energy += rub.limit * (dry + 0.5 * way.squaredNorm() / m_doublingSlip);
        if (gradient != nullptr) {
            const double pull = slides ? 1 / size : (2 - share) / m_threshold; // f0' / |u|
            rub.apart.spread(rub.limit * (pull * slip + way / m_doublingSlip), *gradient, m_cell);
        }
    }
    return energy;
}

double FrictionTerm::evaluate(const Vector& x, Vector* gradient) const {
    return evaluateOn(m_shells, x, gradient) + evaluateOn(m_cores, x, gradient);
}

template<std::size_t Count>
void FrictionTerm::lineariseOn(const Rubs<Count>& rubs, const Vector& x,
                               StencilHessian<Count>& hessian) const {
    hessian.parts().clear();
    for (const Rub<Count>& rub : rubs) {
        const Eigen::Vector3d slip = slipOf(rub, x);
        const double size = slip.norm();
        const double share = size / m_threshold;
        const double beside = share >= 1 ? 1 / size : (2 - share) / m_threshold; // f0' / |u|
        const double along = share >= 1 ? 0 : 2 * (1 - share) / m_threshold;     // f0''
        Matrix3 stiffness =
            (beside + 1 / m_doublingSlip) * (Matrix3::Identity() - rub.normal * rub.normal.transpose());
        if (size > kTiny) {
            const Eigen::Vector3d way = slip / size;
            stiffness -= (beside - along) * way * way.transpose();
        }
        hessian.parts().push_back({rub.apart, rub.limit * stiffness});
    }
}

void FrictionTerm::linearise(const Vector& x) {
    lineariseOn(m_shells, x, m_shellHessian);
    lineariseOn(m_cores, x, m_coreHessian);
}

void FrictionTerm::multiply(const Vector& v, Vector& y) const {
    m_shellHessian.multiply(v, y);
    m_coreHessian.multiply(v, y);
}

void FrictionTerm::addDiagonal(Eigen::Matrix3Xd& blocks) const {
    m_shellHessian.addDiagonal(blocks);
    m_coreHessian.addDiagonal(blocks);
}

void FrictionTerm::addBlocks(BlockSink& sink) const {
    m_shellHessian.addBlocks(sink);
    m_coreHessian.addBlocks(sink);
}

} // namespace knittsim::physics
