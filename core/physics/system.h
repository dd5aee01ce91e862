#pragma once

#include "core/physics/energy_term.h"
#include "core/physics/interrupt.h"

#include <memory>

namespace knittsim::physics {

class Metric;
class Preconditioner;

/// What integrators bring to rest: an energy of entries of 3 numbers each, with its gradient and a positive
/// definite Hessian. Pinned entries have gradient 0, and the Hessian leaves them where they are. Units are
/// the system's own. One thread at a time.
class System {
public:
    virtual ~System() = default;

    virtual Entry entryCount() const = 0;
    Eigen::Index size() const { return Eigen::Index{3} * entryCount(); }

    /// By entry, all > 0.
    virtual const Vector& mass() const = 0;

    /// Mean stiffness and rest length of the parts of a yarn: the scales of force and shape.
    virtual double stiffnessScale() const = 0;
    virtual double lengthScale() const = 0;

    /// Asked between pieces of work of some 10 ms; throws Interrupted out of the functions below.
    virtual void setInterrupt(const Interrupt& interrupt) = 0;

    /// Potential energy. `gradient` may be null; it is overwritten.
    virtual double evaluate(const Vector& x, Vector* gradient) const = 0;

    /// Remembers the Hessian at x.
    virtual void linearise(const Vector& x) = 0;

    /// y = H v
    virtual void multiply(const Vector& v, Vector& y) const = 0;

    /// Sets the parts of pinned entries to 0.
    virtual void mask(Vector& v) const = 0;

    /// Largest factor in [0, 1] by which the move may be made. `distortion`: what a person can follow in one
    /// step, as share of the length of a piece of yarn.
    virtual double allowedStep(const Vector& x, const Vector& move, double distortion) const = 0;

    /// Shortens the move until it may be made; where only some places are in the way, perhaps only there.
    virtual void shorten(const Vector& x, Vector& move, double distortion) const {
        move *= allowedStep(x, move, distortion);
    }

    /// The metric in which first-order methods descend, and the best approximate inverse of H for conjugate
    /// gradients. Both must not outlive the system.
    virtual std::unique_ptr<Metric> makeMetric() const = 0;
    virtual std::unique_ptr<Preconditioner> makePreconditioner() const = 0;
};

} // namespace knittsim::physics
