#include "core/physics/multistep.h"

#include "core/physics/conjugate_gradients.h"

#include <cvode/cvode.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <new>

namespace knittsim::physics {

namespace {

constexpr double kFar = 1e9;        // scaled time that is never reached: steps are taken one by one
constexpr double kFirstStep = 0.05; // of a period of the quickest motion
constexpr int kKrylov = 20;
constexpr double kInnerTolerance = 0.05;
constexpr int kInnerIterations = 60;

Multistep& self(void* data) {
    return *static_cast<Multistep*>(data);
}

int slope(double /*time*/, N_Vector y, N_Vector derivative, void* data) {
    return self(data).guarded(
        [&](DampedDynamics& d) { d.slope(sundials::view(y), sundials::view(derivative)); });
}

int jacobian(N_Vector v, N_Vector product, double, N_Vector, N_Vector, void* data, N_Vector) {
    return self(data).guarded(
        [&](DampedDynamics& d) { d.jacobian(sundials::view(v), sundials::view(product)); });
}

int setUp(double, N_Vector, N_Vector, booleantype, booleantype* renewed, double gamma, void* data) {
    *renewed = SUNTRUE;
    return self(data).setUp(gamma);
}

int solve(double, N_Vector, N_Vector, N_Vector r, N_Vector z, double gamma, double, int, void* data) {
    return self(data).solve(gamma, sundials::view(r), sundials::view(z));
}

} // namespace

Multistep::~Multistep() {
    release();
}

void Multistep::release() {
    CVodeFree(&m_memory);
    if (m_nonlinear != nullptr) {
        SUNNonlinSolFree(m_nonlinear);
        m_nonlinear = nullptr;
    }
    if (m_linear != nullptr) {
        SUNLinSolFree(m_linear);
        m_linear = nullptr;
    }
}

void Multistep::create(N_Vector y) {
    release();
    m_memory = CVodeCreate(m_method == Method::Adams ? CV_ADAMS : CV_BDF, context());
    if (m_memory == nullptr || CVodeInit(m_memory, physics::slope, 0, y) != CV_SUCCESS) {
        throw std::bad_alloc();
    }
    CVodeSetUserData(m_memory, this);
    CVodeSStolerances(m_memory, kRelativeTolerance, absoluteTolerance());
    CVodeSetInitStep(m_memory, kFirstStep);
    CVodeSetErrFile(m_memory, nullptr);
    if (m_method == Method::Adams) {
        useFixedPoint(y);
    } else {
        useNewtonKrylov(y);
    }
}

void Multistep::useFixedPoint(N_Vector y) {
    m_nonlinear = SUNNonlinSol_FixedPoint(y, 0, context());
    if (m_nonlinear == nullptr) {
        throw std::bad_alloc();
    }
    CVodeSetNonlinearSolver(m_memory, m_nonlinear);
}

void Multistep::useNewtonKrylov(N_Vector y) {
    const System& model = dynamics().model();
    m_preconditioner = model.makePreconditioner();
    m_mass.resize(model.size());
    for (Entry e = 0; e < model.entryCount(); ++e) {
        at(m_mass, e).setConstant(model.mass()[e]);
    }
    m_linear = SUNLinSol_SPGMR(y, SUN_PREC_RIGHT, kKrylov, context());
    if (m_linear == nullptr) {
        throw std::bad_alloc();
    }
    CVodeSetLinearSolver(m_memory, m_linear, nullptr);
    CVodeSetJacTimes(m_memory, nullptr, physics::jacobian);
    CVodeSetPreconditioner(m_memory, physics::setUp, physics::solve);
}

/// (I - g J) z = r with z = (position, velocity) parts: position = r_x + g velocity leaves
/// (H + m M) velocity = (w^2 M r_u - g H r_x) / s,  s = g (b + g),  m = (1 + g a) w^2 / s.
int Multistep::setUp(double gamma) {
    return guarded([&](DampedDynamics& d) {
        const double w2 = d.frequency() * d.frequency();
        m_preconditioner->build((1 + gamma * d.massDamping()) * w2 /
                                (gamma * (d.stiffnessDamping() + gamma)));
    });
}

int Multistep::solve(double gamma, Eigen::Ref<const Vector> r, Eigen::Ref<Vector> z) {
    return guarded([&](DampedDynamics& d) {
        const System& model = d.model();
        const Eigen::Index n = model.size();
        const double w2 = d.frequency() * d.frequency();
        const double s = gamma * (d.stiffnessDamping() + gamma);
        const double massFactor = (1 + gamma * d.massDamping()) * w2 / s;
        const Vector rx = r.head(n);
        Vector right;
        model.multiply(rx, right);
        right = (w2 * m_mass.cwiseProduct(r.tail(n)) - gamma * right) / s;
        model.mask(right);
        Vector velocity;
        const CgResult result = conjugateGradients(
            [&](const Vector& v, Vector& y) {
                model.multiply(v, y);
                y += massFactor * m_mass.cwiseProduct(v);
            },
            [&](const Vector& v, Vector& y) { m_preconditioner->apply(v, y); }, right, velocity,
            kInnerTolerance, kInnerIterations, interrupt());
        d.evaluations += result.iterations;
        z.head(n) = rx + gamma * velocity;
        z.tail(n) = velocity;
    });
}

int Multistep::reset(double scaledTime, N_Vector y) {
    // BDF that forgets its past starts with tiny steps again; a slightly old H does less harm. Adams would be
    // kept swinging for ever by the jumps of the damping.
    if (m_method == Method::Bdf) {
        return CV_SUCCESS;
    }
    const double step = lastStep();
    const int flag = CVodeReInit(m_memory, scaledTime, y);
    return flag == CV_SUCCESS && step > 0 ? CVodeSetInitStep(m_memory, step) : flag;
}

int Multistep::advance(N_Vector y, double& scaledTime) {
    return CVode(m_memory, kFar, y, &scaledTime, CV_ONE_STEP);
}

double Multistep::lastStep() const {
    double step = 0;
    CVodeGetLastStep(m_memory, &step);
    return step;
}

} // namespace knittsim::physics
