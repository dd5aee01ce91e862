#pragma once

#include "core/physics/drag_term.h"
#include "core/physics/spring_term.h"
#include "core/physics/system.h"

#include <memory>
#include <vector>

namespace knittsim::physics {

/// A sum of energy terms over the entries of a bonding point table: equation 3 and what else holds a fabric
/// in shape. Units: mm, mN, uJ, kg.
class Model final : public System {
public:
    /// `layout`: any shape of the fabric, 3 x entries, mm, from which neighbourhoods are taken (the machine's
    /// positions). `mass`: kg by entry, all > 0.
    Model(std::unique_ptr<SpringTerm> springs, std::vector<std::unique_ptr<EnergyTerm>> others, Vector mass,
          Eigen::Matrix3Xd layout);

    Entry entryCount() const override { return static_cast<Entry>(m_mass.size()); }
    const SpringTerm& springs() const { return *m_springs; }
    const Vector& mass() const override { return m_mass; }
    const Eigen::Matrix3Xd& layout() const { return m_layout; }
    double stiffnessScale() const override { return m_stiffnessScale; }
    double lengthScale() const override { return m_lengthScale; }

    /// Pulls `entry` towards `target`; only one pull at a time.
    void pull(Entry entry, const Eigen::Vector3d& target);
    void release();
    void setPinned(Entry entry, bool pinned);
    bool isPinned(Entry entry) const { return m_pinned[static_cast<std::size_t>(entry)] != 0; }

    void setInterrupt(const Interrupt& interrupt) override { m_interrupt = interrupt; }
    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override; ///< with a trace of stiffness to the ground
    void multiply(const Vector& v, Vector& y) const override;
    void mask(Vector& v) const override;
    double allowedStep(const Vector& x, const Vector& move, double distortion) const override;
    std::unique_ptr<Metric> makeMetric() const override;
    std::unique_ptr<Preconditioner> makePreconditioner() const override;

    /// 3 x 3n: the diagonal blocks of H.
    Eigen::Matrix3Xd diagonal() const;

    /// All blocks of the terms, without ground and pins.
    void addBlocks(BlockSink& sink) const;

    /// Largest change of a spring's vector, relative to the longer of its present and its rest length, that
    /// the move makes.
    double largestDistortion(const Vector& x, const Vector& move) const;

private:
    template<class Visit> void forTerms(Visit visit) const;

    std::unique_ptr<SpringTerm> m_springs;
    std::vector<std::unique_ptr<EnergyTerm>> m_others;
    DragTerm m_drag;
    Interrupt m_interrupt;
    Vector m_mass;
    Eigen::Matrix3Xd m_layout;
    std::vector<char> m_pinned;
    std::vector<Entry> m_pinnedEntries;
    double m_stiffnessScale = 1;
    double m_lengthScale = 1;
    double m_ground = 0;
};

} // namespace knittsim::physics
