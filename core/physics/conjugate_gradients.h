#pragma once

#include "core/physics/energy_term.h"
#include "core/physics/interrupt.h"

#include <cmath>

namespace knittsim::physics {

struct CgResult {
    int iterations = 0;
    double relativeResidual = 1;
};

/// Preconditioned conjugate gradients for H x = b from x = 0, with multiply(v, y): y = H v and
/// precondition(r, z): z = M^-1 r, both symmetric and positive definite. Stops below `tolerance` (relative to
/// b), after `limit` iterations, or where rounding makes a direction of no use; x is the best so far.
template<class Multiply, class Precondition>
CgResult conjugateGradients(Multiply multiply, Precondition precondition, const Vector& b, Vector& x,
                            double tolerance, int limit, const Interrupt& interrupt) {
    x.setZero(b.size());
    CgResult result;
    const double start = b.norm();
    if (start == 0) {
        result.relativeResidual = 0;
        return result;
    }
    Vector r = b;
    Vector z;
    Vector hp(b.size());
    precondition(r, z);
    Vector p = z;
    double rz = r.dot(z);
    while (result.iterations < limit && result.relativeResidual > tolerance) {
        interrupt.check();
        multiply(p, hp);
        const double curvature = p.dot(hp);
        if (!(curvature > 0) || !std::isfinite(curvature)) {
            break;
        }
        const double step = rz / curvature;
        x += step * p;
        r -= step * hp;
        ++result.iterations;
        result.relativeResidual = r.norm() / start;
        precondition(r, z);
        const double next = r.dot(z);
        p = z + (next / rz) * p;
        rz = next;
    }
    return result;
}

} // namespace knittsim::physics
