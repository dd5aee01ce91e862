#pragma once

#include "core/physics/energy_term.h"
#include "core/physics/interrupt.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

struct CgResult {
    int iterations = 0;
    double relativeResidual = 1;
};

/// Preconditioned conjugate gradients for H x = b from x = 0, with multiply(v, y): y = H v and
/// precondition(r, z): z = M^-1 r, both symmetric and positive definite. Stops when the residual is below
/// `tolerance` in the norm of M^-1, relative to b's (in which soft motions count as much as stiff ones),
/// after `limit` iterations, or where rounding makes a direction of no use; x is the best so far.
template<class Multiply, class Precondition>
CgResult conjugateGradients(Multiply multiply, Precondition precondition, const Vector& b, Vector& x,
                            double tolerance, int limit, const Interrupt& interrupt) {
    x.setZero(b.size());
    CgResult result;
    Vector r = b;
    Vector z;
    Vector hp(b.size());
    precondition(r, z);
    Vector p = z;
    double rz = r.dot(z);
    const double start = rz;
    if (!(start > 0)) {
        result.relativeResidual = start == 0 ? 0 : 1;
        return result;
    }
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
        precondition(r, z);
        const double next = r.dot(z);
        result.relativeResidual = std::sqrt(std::max(0.0, next) / start);
        p = z + (next / rz) * p;
        rz = next;
    }
    return result;
}

} // namespace knittsim::physics
