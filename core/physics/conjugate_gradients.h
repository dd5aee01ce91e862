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

/// The norm in which a residual is compared with b.
enum class CgNorm {
    Plain,          ///< its length
    Preconditioner, ///< of M^-1, in which soft motions count as much as stiff ones
};

/// Preconditioned conjugate gradients for H x = b from x = 0, with multiply(v, y): y = H v and
/// precondition(r, z): z = M^-1 r, both symmetric and positive definite. Stops when the residual relative to
/// b is below `tolerance`, after `limit` iterations, or where rounding makes a direction of no use; x is the
/// best so far.
template<class Multiply, class Precondition>
CgResult conjugateGradients(Multiply multiply, Precondition precondition, const Vector& b, Vector& x,
                            double tolerance, int limit, const Interrupt& interrupt,
                            CgNorm norm = CgNorm::Plain) {
    x.setZero(b.size());
    CgResult result;
    Vector r = b;
    Vector z;
    Vector hp(b.size());
    precondition(r, z);
    Vector p = z;
    double rz = r.dot(z);
    const auto length = [&] { return norm == CgNorm::Plain ? r.norm() : std::sqrt(std::max(0.0, rz)); };
    const double start = length();
    if (start == 0) {
        result.relativeResidual = r.isZero(0) ? 0 : 1;
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
        p = z + (next / rz) * p;
        rz = next;
        result.relativeResidual = length() / start;
    }
    return result;
}

} // namespace knittsim::physics
