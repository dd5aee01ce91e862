#pragma once

#include "core/physics/energy_term.h"

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <memory>
#include <string>

namespace knittsim::physics::sundials {

/// What every SUNDIALS object needs. Throws std::bad_alloc when it cannot be made.
class Context {
public:
    Context();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    SUNContext get() const { return m_context; }

private:
    SUNContext m_context = nullptr;
};

/// A serial N_Vector with memory of its own. Throws std::bad_alloc.
class StateVector {
public:
    StateVector(Eigen::Index size, const Context& context);
    ~StateVector();
    StateVector(const StateVector&) = delete;
    StateVector& operator=(const StateVector&) = delete;

    N_Vector get() const { return m_vector; }
    Eigen::Map<Vector> map() const { return {N_VGetArrayPointer(m_vector), N_VGetLength(m_vector)}; }

private:
    N_Vector m_vector = nullptr;
};

inline Eigen::Map<Vector> view(N_Vector v) {
    return {N_VGetArrayPointer(v), N_VGetLength(v)};
}

enum class Package { Arkode, Cvode, Kinsol };

/// The one place that knows what SUNDIALS' return flags mean.
enum class Meaning {
    Fine,
    Unfinished, ///< an iteration limit that we set ourselves was reached; the vector holds the latest iterate
    GaveUp,
};
Meaning meaningOf(Package package, int flag);

/// SUNDIALS' own name of a flag, for example "CV_CONV_FAILURE".
std::string nameOf(Package package, int flag);

} // namespace knittsim::physics::sundials
