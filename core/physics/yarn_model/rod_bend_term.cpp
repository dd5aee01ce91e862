#include "core/physics/yarn_model/rod_bend_term.h"

#include <algorithm>

namespace knittsim::physics {

namespace {
constexpr double kTiny = 1e-9; // below, a turn has no direction
}

RodBendTerm::RodBendTerm(const YarnChains& chains)
    : m_nodeCount(static_cast<std::size_t>(chains.nodeCount())), m_hessian(chains.cellEntry()) {
    for (const Chain& c : chains.chains) {
        const RodYarn& yarn = chains.yarns[static_cast<std::size_t>(c.yarn)];
        const auto rest = [&](const Place& p) { return chains.restLength[static_cast<std::size_t>(p.node)]; };
        for (Entry i = c.closed ? 0 : 1; i < c.segmentCount(); ++i) {
            const double before = 1 / rest(c.place(i - 1));
            const double after = 1 / rest(c.place(i));
            const double length = 0.5 * (1 / before + 1 / after);
            const auto node = static_cast<std::size_t>(c.first + i);
            const double curvature = chains.restCurvature.empty() ? 0 : chains.restCurvature[node];
            m_bends.push_back(
                {{{c.place(i - 1), c.place(i), c.place(i + 1)}, {before, -(before + after), after}},
                 length,
                 yarn.bendingStiffness / length,
                 length * curvature,
                 yarn.set});
        }
    }
}

double RodBendTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (const Bend& b : m_bends) {
        const Eigen::Vector3d turn = b.turn.of(x, m_hessian.cell());
        const double size = b.restTurn > 0 ? turn.norm() : 0;
        // The part of the turn that is at rest; none where the turn has no direction.
        const double share = size > kTiny ? b.restTurn / size : 0;
        energy += 0.5 * b.stiffness *
                  (b.restTurn > 0 ? (size - b.restTurn) * (size - b.restTurn) : turn.squaredNorm());
        if (gradient != nullptr) {
            b.turn.spread(b.stiffness * (1 - share) * turn, *gradient, m_hessian.cell());
        }
    }
    return energy;
}

void RodBendTerm::linearise(const Vector& x) {
    m_hessian.parts().clear();
    m_hessian.parts().reserve(m_bends.size());
    for (const Bend& b : m_bends) {
        Matrix3 stiffness = b.stiffness * Matrix3::Identity();
        if (b.restTurn > 0) {
            const Eigen::Vector3d turn = b.turn.of(x, m_hessian.cell());
            const double size = turn.norm();
            if (size > kTiny) {
                const Eigen::Vector3d n = turn / size;
                const double across = b.stiffness * std::max(0.0, 1 - b.restTurn / size);
                stiffness = across * Matrix3::Identity() + (b.stiffness - across) * n * n.transpose();
            }
        }
        m_hessian.parts().push_back({b.turn, stiffness});
    }
}

void RodBendTerm::takeSet(const Vector& x) {
    for (Bend& b : m_bends) {
        b.restTurn = b.set * b.turn.of(x, m_hessian.cell()).norm();
    }
}

std::vector<double> RodBendTerm::restCurvatures() const {
    std::vector<double> result(m_nodeCount, 0);
    for (const Bend& b : m_bends) {
        result[static_cast<std::size_t>(b.turn.places[1].node)] = b.restTurn / b.length;
    }
    return result;
}

std::vector<double> RodBendTerm::curvatures(const Vector& x) const {
    std::vector<double> result(m_nodeCount, 0);
    for (const Bend& b : m_bends) {
        result[static_cast<std::size_t>(b.turn.places[1].node)] =
            b.turn.of(x, m_hessian.cell()).norm() / b.length;
    }
    return result;
}

} // namespace knittsim::physics
