#include "core/physics/sundials_support.h"

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <kinsol/kinsol.h>

#include <cstdlib>
#include <new>

namespace knittsim::physics::sundials {

Context::Context() {
    if (SUNContext_Create(nullptr, &m_context) != 0 || m_context == nullptr) {
        throw std::bad_alloc();
    }
}

Context::~Context() {
    SUNContext_Free(&m_context);
}

StateVector::StateVector(Eigen::Index size, const Context& context)
    : m_vector(N_VNew_Serial(size, context.get())) {
    if (m_vector == nullptr) {
        throw std::bad_alloc();
    }
    N_VConst(0, m_vector);
}

StateVector::~StateVector() {
    N_VDestroy(m_vector);
}

Meaning meaningOf(Package package, int flag) {
    if (flag >= 0) {
        // Positive flags are news: a time or a root reached, a step too small to go on (KINSOL).
        return package == Package::Kinsol && flag == KIN_STEP_LT_STPTOL ? Meaning::GaveUp : Meaning::Fine;
    }
    return package == Package::Kinsol && flag == KIN_MAXITER_REACHED ? Meaning::Unfinished : Meaning::GaveUp;
}

std::string nameOf(Package package, int flag) {
    char* name = nullptr;
    switch (package) {
    case Package::Arkode:
        name = ERKStepGetReturnFlagName(flag);
        break;
    case Package::Cvode:
        name = CVodeGetReturnFlagName(flag);
        break;
    case Package::Kinsol:
        name = KINGetReturnFlagName(flag);
        break;
    }
    const std::string result = name != nullptr ? name : std::to_string(flag);
    std::free(name);
    return result;
}

} // namespace knittsim::physics::sundials
