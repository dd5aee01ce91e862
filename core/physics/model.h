#pragma once

#include "core/physics/drag_term.h"
#include "core/physics/energy_term.h"
#include "core/physics/interrupt.h"
#include "core/physics/spring_term.h"

#include <memory>
#include <vector>

namespace knittsim::physics {

/// A sum of energy terms over the entries of a bonding point table: equation 3 and what else holds a fabric
/// in shape. Knows which entries are pinned: their gradient is 0, and the Hessian leaves them where they are.
/// One thread at a time.
class Model {
public:
    /// `layout`: any shape of the fabric, 3 x entries, mm, from which neighbourhoods are taken (the machine's
    /// positions). `mass`: kg by entry, all > 0.
    Model(std::unique_ptr<SpringTerm> springs, std::vector<std::unique_ptr<EnergyTerm>> others, Vector mass,
          Eigen::Matrix3Xd layout);

    Entry entryCount() const { return static_cast<Entry>(m_mass.size()); }
    Eigen::Index size() const { return 3 * m_mass.size(); }
    const SpringTerm& springs() const { return *m_springs; }
    const Vector& mass() const { return m_mass; }
    const Eigen::Matrix3Xd& layout() const { return m_layout; }

    /// Mean stiffness (mN/mm) and rest length (mm) of the springs: the scales of force and shape.
    double stiffnessScale() const { return m_stiffnessScale; }
    double lengthScale() const { return m_lengthScale; }

    /// Pulls `entry` towards `target`; only one pull at a time.
    void pull(Entry entry, const Eigen::Vector3d& target);
    void release();
    void setPinned(Entry entry, bool pinned);
    bool isPinned(Entry entry) const { return m_pinned[static_cast<std::size_t>(entry)] != 0; }

    /// Asked between terms, in a large fabric some 10 ms each; throws Interrupted out of the functions below.
    void setInterrupt(const Interrupt& interrupt) { m_interrupt = interrupt; }

    /// Potential energy V, uJ. `gradient` may be null; it is overwritten.
    double evaluate(const Vector& x, Vector* gradient) const;

    /// Remembers the positive semi-definite Hessian at x, with a trace of stiffness to the ground so that it
    /// is definite.
    void linearise(const Vector& x);

    /// y = H v
    void multiply(const Vector& v, Vector& y) const;

    /// 3 x 3n: the diagonal blocks of H.
    Eigen::Matrix3Xd diagonal() const;

    /// All blocks of the terms, without ground and pins.
    void addBlocks(BlockSink& sink) const;

    /// Sets the parts of pinned entries to 0.
    void mask(Vector& v) const;

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
