#pragma once

#include "core/physics/system.h"
#include "core/physics/yarn_model/contact_term.h"
#include "core/physics/yarn_model/hard_core_term.h"
#include "core/physics/yarn_model/rod_bend_term.h"
#include "core/physics/yarn_model/rod_stretch_term.h"
#include "core/physics/yarn_model/strand_guard.h"

#include <vector>

namespace knittsim::physics {

/// Yarns as elastic rods in contact (PHYSICS 2): stretch, bending, contact and what else is added; units as
/// in chains.h. Works under any integrator; steps are limited so that no strand passes through another.
class YarnModel final : public System {
public:
    /// `chains` must have no problem(). `threads` for the preconditioner; results do not depend on it.
    explicit YarnModel(const YarnChains& chains, int threads = 1);

    Entry entryCount() const override { return static_cast<Entry>(m_mass.size()); }
    Entry nodeCount() const { return m_nodeCount; }
    Entry cellEntry() const { return m_cell; }
    const std::vector<Chain>& chains() const { return m_chains; }
    const Vector& mass() const override { return m_mass; } ///< yarn by node
    double stiffnessScale() const override { return m_stiffnessScale; }
    double lengthScale() const override { return m_lengthScale; }
    double thickestDiameter() const { return m_thickest; } ///< outer, of all yarns

    /// Surroundings: gravity, a table, grips.
    void add(std::unique_ptr<EnergyTerm> term) { m_others.push_back(std::move(term)); }

    void setPinned(Entry entry, bool pinned);
    bool isPinned(Entry entry) const { return m_pinned[static_cast<std::size_t>(entry)] != 0; }

    /// Yarns take set at x (a fabric that is steamed, or has lain long).
    void takeSet(const Vector& x) { m_bend.takeSet(x); }

    /// Share of the true diameters, in (0, 1].
    void setThickness(double share);
    double thickness() const { return m_contact.thickness(); }

    const RodStretchTerm& stretch() const { return m_stretch; }
    const RodBendTerm& bend() const { return m_bend; }
    const ContactTerm& contact() const { return m_contact; }
    const HardCoreTerm& cores() const { return m_cores; }

    /// At the present thickness.
    StrandAudit audit(const Vector& x) const { return m_guard.audit(x, thickness()); }

    /// Of the yarns and what they do to each other, without surroundings and friction.
    double elasticEnergy(const Vector& x) const {
        return m_stretch.evaluate(x, nullptr) + m_bend.evaluate(x, nullptr) + m_contact.evaluate(x, nullptr) +
               m_cores.evaluate(x, nullptr);
    }

    void setInterrupt(const Interrupt& interrupt) override { m_interrupt = interrupt; }
    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override; ///< with a trace of stiffness to the ground
    void multiply(const Vector& v, Vector& y) const override;
    void mask(Vector& v) const override;
    double allowedStep(const Vector& x, const Vector& move, double distortion) const override;
    void shorten(const Vector& x, Vector& move, double distortion) const override;
    std::unique_ptr<Metric> makeMetric() const override;
    std::unique_ptr<Preconditioner> makePreconditioner() const override;

private:
    friend class YarnPreconditioner;

    template<class Visit> void forTerms(Visit visit) const;
    void spread(std::vector<double>& share) const;

    std::vector<Chain> m_chains;
    Entry m_nodeCount;
    Entry m_cell;
    int m_threads;
    RodStretchTerm m_stretch;
    RodBendTerm m_bend;
    ContactTerm m_contact;
    HardCoreTerm m_cores;
    std::vector<std::unique_ptr<EnergyTerm>> m_others;
    mutable StrandGuard m_guard; ///< remembers distances between calls
    std::vector<double> m_restLength;
    Vector m_mass;
    std::vector<char> m_pinned;
    std::vector<Entry> m_pinnedEntries;
    Interrupt m_interrupt;
    double m_stiffnessScale = 1;
    double m_lengthScale = 1;
    double m_thickest = 0;
    double m_ground = 0;
    Vector m_linearisedAt;
};

} // namespace knittsim::physics
