#include "core/physics/yarn_model/yarn_preconditioner.h"

#include "core/physics/yarn_model/parallel.h"
#include "core/physics/yarn_model/yarn_model.h"

#include <Eigen/LU>

#include <algorithm>

namespace knittsim::physics {

/// Sorts blocks of stretch and bending into bands, border and corner.
class YarnPreconditioner::Sink final : public BlockSink {
public:
    explicit Sink(YarnPreconditioner& owner) : m_owner(owner) {}

    void add(Entry row, Entry column, const Matrix3& block) override {
        const Entry cell = m_owner.m_model.cellEntry();
        if (m_owner.m_model.isPinned(row) || m_owner.m_model.isPinned(column)) {
            return;
        }
        if (row == cell && column == cell) {
            m_owner.m_corner += block;
        } else if (column == cell) {
            m_owner.m_border.middleRows<3>(Eigen::Index{3} * row) += block;
        } else if (row != cell) {
            const auto chain = static_cast<std::size_t>(m_owner.m_chainOf[static_cast<std::size_t>(row)]);
            const Entry first = m_owner.m_model.chains()[chain].first;
            m_owner.m_bands[chain].add(row - first, column - first, block);
        }
    }

private:
    YarnPreconditioner& m_owner;
};

YarnPreconditioner::YarnPreconditioner(const YarnModel& model) : m_model(model) {
    for (const Chain& c : model.chains()) {
        m_chainOf.insert(m_chainOf.end(), static_cast<std::size_t>(c.count),
                         static_cast<int>(m_bands.size()));
        m_bands.emplace_back(c.count, c.closed);
    }
}

template<class Work> void YarnPreconditioner::forChains(Work work) const {
    // A thread pays from some ten thousand nodes on.
    const int threads = m_model.nodeCount() > 20'000 ? m_model.m_threads : 1;
    parallelFor(m_bands.size(), threads, work);
}

void YarnPreconditioner::build(double massFactor) {
    for (BandedCholesky& band : m_bands) {
        band.setZero();
    }
    m_corner.setZero();
    const bool bordered = m_model.cellEntry() >= 0;
    const bool cellMoves = bordered && !m_model.isPinned(m_model.cellEntry());
    const Eigen::Index nodes = Eigen::Index{3} * m_model.nodeCount();
    m_border = bordered ? Border(Border::Zero(nodes, 3)) : Border(0, 3);
    Sink sink(*this);
    m_model.m_stretch.addBlocks(sink);
    m_model.m_bend.addBlocks(sink);

    Eigen::Matrix3Xd held = Eigen::Matrix3Xd::Zero(3, m_model.size());
    for (const auto& term : m_model.m_others) {
        term->addDiagonal(held);
    }
    if (cellMoves) { // what acts on the cell itself
        m_corner += held.middleCols<3>(Eigen::Index{3} * m_model.cellEntry());
    }
    m_model.m_contact.addDiagonal(held);
    m_model.m_cores.addDiagonal(held);
    Eigen::Vector3d cell = Eigen::Vector3d::Ones();
    if (bordered) {
        cell.head<2>() = at(m_model.m_linearisedAt, m_model.cellEntry()).head<2>();
    }
    for (Entry e = 0; e < m_model.nodeCount(); ++e) {
        const auto chain = static_cast<std::size_t>(m_chainOf[static_cast<std::size_t>(e)]);
        const Entry i = e - m_model.chains()[chain].first;
        if (m_model.isPinned(e)) {
            m_bands[chain].add(i, i, m_model.stiffnessScale() * Matrix3::Identity());
            continue;
        }
        const Matrix3 block = held.middleCols<3>(Eigen::Index{3} * e);
        const double ground = m_model.m_ground + massFactor * m_model.mass()[e];
        m_bands[chain].add(i, i, block + ground * Matrix3::Identity());
        if (cellMoves) {
            Eigen::Vector3d way = Eigen::Vector3d(at(m_model.m_linearisedAt, e)).cwiseQuotient(cell);
            way.z() = 0;
            m_border.middleRows<3>(Eigen::Index{3} * e) -= block * way.asDiagonal();
            m_corner += way.asDiagonal() * block * way.asDiagonal();
        }
    }
    if (bordered) {
        const double ground = cellMoves ? m_model.m_ground : m_model.stiffnessScale();
        m_corner += (ground + massFactor * m_model.mass()[m_model.cellEntry()]) * Matrix3::Identity();
    }
    factorise();
}

void YarnPreconditioner::factorise() {
    forChains([&](std::size_t chain) {
        // Definite by construction; only numbers that are none, or beyond all bounds, could spoil it.
        if (!m_bands[chain].factorise()) {
            m_bands[chain].setZero();
            for (Entry i = 0; i < m_bands[chain].nodeCount(); ++i) {
                m_bands[chain].add(i, i, m_model.stiffnessScale() * Matrix3::Identity());
            }
            m_bands[chain].factorise();
        }
    });
    if (m_model.cellEntry() < 0) {
        return;
    }
    m_solvedBorder = m_border;
    for (Eigen::Index k = 0; k < 3; ++k) {
        solveChains(m_solvedBorder.col(k));
    }
    const Matrix3 schur = m_corner - m_border.transpose() * m_solvedBorder;
    m_schurInverse = schur.inverse();
    m_schurInverse = (0.5 * (m_schurInverse + m_schurInverse.transpose())).eval();
}

void YarnPreconditioner::solveChains(Eigen::Ref<Vector> x) const {
    forChains([&](std::size_t chain) {
        const Chain& c = m_model.chains()[chain];
        m_bands[chain].solve(x.segment(Eigen::Index{3} * c.first, Eigen::Index{3} * c.count));
    });
}

void YarnPreconditioner::apply(const Vector& r, Vector& z) const {
    z = r;
    m_model.mask(z);
    const Eigen::Index nodes = Eigen::Index{3} * m_model.nodeCount();
    solveChains(z.head(nodes));
    if (m_model.cellEntry() >= 0) {
        const Eigen::Vector3d cell = m_schurInverse * (z.tail<3>() - m_border.transpose() * z.head(nodes));
        z.head(nodes) -= m_solvedBorder * cell;
        z.tail<3>() = cell;
    }
    m_model.mask(z);
}

double YarnPreconditioner::halfSquare(const Vector& v) const {
    double sum = 0;
    for (std::size_t chain = 0; chain < m_bands.size(); ++chain) {
        const Chain& c = m_model.chains()[chain];
        sum += m_bands[chain].square(v.segment(Eigen::Index{3} * c.first, Eigen::Index{3} * c.count));
    }
    if (m_model.cellEntry() >= 0) {
        const Eigen::Vector3d cell = v.tail<3>();
        const Eigen::Vector3d side = m_border.transpose() * v.head(Eigen::Index{3} * m_model.nodeCount());
        sum += 2 * cell.dot(side) + cell.dot(m_corner * cell);
    }
    return 0.5 * sum;
}

} // namespace knittsim::physics
