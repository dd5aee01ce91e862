#include "core/physics/kinsol_newton.h"

#include <kinsol/kinsol.h>
#include <sunlinsol/sunlinsol_pcg.h>

#include <algorithm>
#include <new>

namespace knittsim::physics {

namespace {

constexpr int kKrylov = 200;
constexpr double kUnreachable = 1e-300; // the stop rule decides, not KINSOL

KinsolNewton& self(void* data) {
    return *static_cast<KinsolNewton*>(data);
}

int gradient(N_Vector x, N_Vector result, void* data) {
    return self(data).gradient(x, result);
}

int product(N_Vector v, N_Vector result, N_Vector, booleantype* renewed, void* data) {
    *renewed = SUNFALSE;
    return self(data).product(v, result);
}

int setUp(N_Vector x, N_Vector, N_Vector, N_Vector, void* data) {
    return self(data).setUp(x);
}

int precondition(N_Vector, N_Vector, N_Vector, N_Vector, N_Vector v, void* data) {
    return self(data).precondition(v);
}

} // namespace

KinsolNewton::~KinsolNewton() {
    release();
}

void KinsolNewton::release() {
    KINFree(&m_memory);
    if (m_linear != nullptr) {
        SUNLinSolFree(m_linear);
        m_linear = nullptr;
    }
}

void KinsolNewton::initialise(System& model, const Motion& /*motion*/) {
    m_model = &model;
    release();
}

void KinsolNewton::create() {
    m_preconditioner = m_model->makePreconditioner();
    m_x = std::make_unique<sundials::StateVector>(m_model->size(), m_context);
    m_ones = std::make_unique<sundials::StateVector>(m_model->size(), m_context);
    m_ones->map().setOnes();
    m_memory = KINCreate(m_context.get());
    if (m_memory == nullptr || KINInit(m_memory, physics::gradient, m_x->get()) != KIN_SUCCESS) {
        throw std::bad_alloc();
    }
    m_linear = SUNLinSol_PCG(m_x->get(), SUN_PREC_RIGHT, kKrylov, m_context.get());
    if (m_linear == nullptr) {
        throw std::bad_alloc();
    }
    KINSetUserData(m_memory, this);
    KINSetErrFile(m_memory, nullptr);
    KINSetLinearSolver(m_memory, m_linear, nullptr);
    KINSetJacTimesVecFn(m_memory, physics::product);
    KINSetPreconditioner(m_memory, physics::setUp, physics::precondition);
    KINSetNumMaxIters(m_memory, 1);
    KINSetMaxSetupCalls(m_memory, 1);
    KINSetFuncNormTol(m_memory, kUnreachable);
    KINSetScaledStepTol(m_memory, kUnreachable);
    KINSetEtaForm(m_memory, KIN_ETACONSTANT);
    KINSetEtaConstValue(m_memory, 0.05);
}

template<class Work> int KinsolNewton::guarded(Work work) {
    try {
        m_interrupt.check();
        work();
        ++m_evaluations;
        return 0;
    } catch (...) {
        return -1;
    }
}

int KinsolNewton::gradient(N_Vector x, N_Vector result) {
    return guarded([&] {
        m_in = sundials::view(x);
        m_model->evaluate(m_in, &m_out);
        sundials::view(result) = m_out;
    });
}

int KinsolNewton::product(N_Vector v, N_Vector result) {
    return guarded([&] {
        m_in = sundials::view(v);
        m_model->multiply(m_in, m_out);
        sundials::view(result) = m_out;
    });
}

int KinsolNewton::setUp(N_Vector x) {
    return guarded([&] {
        m_in = sundials::view(x);
        m_model->linearise(m_in);
        m_preconditioner->build();
    });
}

int KinsolNewton::precondition(N_Vector v) {
    return guarded([&] {
        m_in = sundials::view(v);
        m_preconditioner->apply(m_in, m_out);
        sundials::view(v) = m_out;
    });
}

StepReport KinsolNewton::step(Motion& motion, const Interrupt& interrupt) {
    m_interrupt = interrupt;
    StepReport report = interruptible(*m_model, interrupt, [&] {
        if (m_memory == nullptr) {
            create();
        }
        m_evaluations = 0;
        m_x->map() = motion.positions;
        const int flag = KINSol(m_memory, m_x->get(), KIN_LINESEARCH, m_ones->get(), m_ones->get());
        interrupt.check();
        return finish(motion, flag);
    });
    m_interrupt = Interrupt();
    return report;
}

StepReport KinsolNewton::finish(Motion& motion, int flag) {
    StepReport report;
    Vector move = m_x->map() - motion.positions;
    if (sundials::meaningOf(sundials::Package::Kinsol, flag) == sundials::Meaning::GaveUp) {
        report.note = sundials::nameOf(sundials::Package::Kinsol, flag);
        report.outcome = StepReport::Outcome::Stuck;
        move.setZero();
    } else {
        move *= m_model->allowedStep(motion.positions, move, kLargestDistortion);
    }
    const Vector next = motion.positions + move;
    Vector gradient;
    report.potential = m_model->evaluate(next, &gradient);
    motion.positions = next;
    motion.velocities.setZero(move.size());
    report.forceNorm = gradient.norm();
    report.largestMove = move.cwiseAbs().maxCoeff();
    report.evaluations = m_evaluations + 1;
    return report;
}

} // namespace knittsim::physics
