#include "core/physics/runge_kutta.h"

#include <arkode/arkode_erkstep.h>

#include <algorithm>
#include <new>

namespace knittsim::physics {

namespace {

constexpr double kFar = 1e9;        // scaled time that is never reached: steps are taken one by one
constexpr double kFirstStep = 0.05; // of a period of the quickest motion

int slope(double /*time*/, N_Vector y, N_Vector derivative, void* self) {
    return static_cast<RungeKutta*>(self)->guarded(
        [&](DampedDynamics& dynamics) { dynamics.slope(sundials::view(y), sundials::view(derivative)); });
}

} // namespace

RungeKutta::~RungeKutta() {
    ERKStepFree(&m_memory);
}

void RungeKutta::create(N_Vector y) {
    ERKStepFree(&m_memory);
    m_memory = ERKStepCreate(slope, 0, y, context());
    if (m_memory == nullptr) {
        throw std::bad_alloc();
    }
    const ARKODE_ERKTableID table =
        m_table == Table::CashKarp ? ARKODE_CASH_KARP_6_4_5 : ARKODE_DORMAND_PRINCE_7_4_5;
    ERKStepSetUserData(m_memory, this);
    ERKStepSetTableNum(m_memory, table);
    ERKStepSStolerances(m_memory, kRelativeTolerance, absoluteTolerance());
    ERKStepSetInitStep(m_memory, kFirstStep);
    ERKStepSetMaxStep(m_memory, dynamics().stableStep());
    ERKStepSetErrFile(m_memory, nullptr);
}

int RungeKutta::reset(double scaledTime, N_Vector y) {
    const double step = lastStep();
    const int flag = ERKStepReset(m_memory, scaledTime, y);
    ERKStepSetInitStep(m_memory, std::min(step, dynamics().stableStep()));
    ERKStepSetMaxStep(m_memory, dynamics().stableStep());
    return flag;
}

int RungeKutta::advance(N_Vector y, double& scaledTime) {
    return ERKStepEvolve(m_memory, kFar, y, &scaledTime, ARK_ONE_STEP);
}

double RungeKutta::lastStep() const {
    double step = 0;
    ERKStepGetLastStep(m_memory, &step);
    return step;
}

} // namespace knittsim::physics
