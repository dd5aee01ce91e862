#include "core/simulation/simulation.h"

#include "core/physics/bonding_point_model.h"
#include "core/physics/integrator.h"
#include "core/physics/stop_rule.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

namespace knittsim::simulation {

namespace {

using Clock = std::chrono::steady_clock;
using physics::StepReport;
using physics::StopRule;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

StopReason reasonOf(StopRule::Verdict verdict) {
    switch (verdict) {
    case StopRule::Verdict::GoOn:
        return StopReason::None;
    case StopRule::Verdict::ResidualReached:
        return StopReason::ResidualReached;
    case StopRule::Verdict::Stagnation:
        return StopReason::Stagnation;
    case StopRule::Verdict::StepLimit:
        return StopReason::StepLimit;
    case StopRule::Verdict::Diverged:
        return StopReason::Diverged;
    case StopRule::Verdict::SolverFailed:
        return StopReason::SolverFailed;
    }
    return StopReason::None;
}

bool isFailure(StopReason reason) {
    return reason == StopReason::Diverged || reason == StopReason::SolverFailed;
}

} // namespace

std::span<const IntegratorInfo> integrators() {
    static const std::vector<IntegratorInfo> infos = [] {
        std::vector<IntegratorInfo> result;
        for (const physics::IntegratorKind& kind : physics::integratorKinds()) {
            result.push_back({kind.id, kind.name, kind.purpose});
        }
        return result;
    }();
    return infos;
}

struct Simulation::Implementation {
    std::shared_ptr<const fabric::Fabric> fabric;
    std::vector<yarn::Yarn> yarns;
    physics::BondingPointModel net;
    std::unique_ptr<physics::Integrator> integrator =
        physics::makeIntegrator(physics::integratorKinds()[0].id);
    std::string integratorId = physics::integratorKinds()[0].id;
    physics::Motion motion;
    StopRule stopRule;
    StepReport last;
    State state = State::Empty;
    StopReason reason = StopReason::None;
    bool singleStep = false;
    bool initialised = false; ///< the integrator knows model and motion
    std::optional<command::Drag> drag;
    std::vector<fabric::EntryIndex> pins;
    std::uint64_t generation = 0;
    std::int64_t steps = 0;
    double millisecondsPerStep = 0;
    std::string note;

    bool loaded() const { return state != State::Empty; }
    bool isEntry(fabric::EntryIndex e) const { return loaded() && e >= 0 && e < fabric->entryCount; }

    void halt(State next, StopReason why) {
        state = next;
        reason = why;
        singleStep = false;
    }

    void run() {
        state = State::Running;
        reason = StopReason::None;
        note.clear();
        stopRule.restart();
    }

    /// A fabric at rest that something has happened to moves again; one that a person has paused waits.
    void wake() {
        initialised = false;
        if (state == State::AtRest) {
            run();
        }
    }

    /// Energy and force of the present shape, where no step has told them.
    void measure() {
        physics::Vector gradient;
        last = {};
        last.potential = net.model->evaluate(motion.positions, &gradient);
        last.forceNorm = gradient.norm();
    }

    void buildNet() {
        net = physics::buildBondingPointModel(*fabric, yarns);
        for (const fabric::EntryIndex e : pins) {
            net.model->setPinned(e, true);
        }
        if (drag) {
            net.model->pull(drag->entry, {drag->x, drag->y, drag->z});
        }
        stopRule.setReference(*net.model, physics::machinePositions(*fabric));
        initialised = false;
    }

    void begin(physics::Vector positions, std::uint64_t newGeneration) {
        motion.positions = std::move(positions);
        motion.velocities.setZero(motion.positions.size());
        motion.time = 0;
        generation = newGeneration;
        steps = 0;
        millisecondsPerStep = 0;
        note.clear();
        initialised = false;
        halt(State::Ready, StopReason::None);
        measure();
    }

    /// Another fabric; pins and pulls of the one before mean nothing to it.
    void take(std::shared_ptr<const fabric::Fabric> next) {
        fabric = std::move(next);
        pins.clear();
        drag.reset();
        buildNet();
    }

    /// Positions of a command where they fit the fabric, else those of the machine.
    physics::Vector startFrom(const std::vector<float>& given) const {
        physics::Vector positions = physics::machinePositions(*fabric);
        if (static_cast<Eigen::Index>(given.size()) == positions.size()) {
            const physics::Vector wanted =
                Eigen::Map<const Eigen::VectorXf>(given.data(), positions.size()).cast<double>();
            if (wanted.allFinite()) {
                positions = wanted;
            }
        }
        return positions;
    }

    void on(const command::Load& c) {
        yarns = c.yarns;
        if (!c.fabric) {
            fabric.reset();
            generation = c.generation;
            halt(State::Empty, StopReason::None);
            return;
        }
        take(c.fabric);
        begin(startFrom(c.positions), c.generation);
    }

    void on(const command::Replace& c) {
        if (!loaded() || !c.fabric) {
            on(command::Load{c.fabric, yarns, c.positions, c.generation});
            return;
        }
        take(c.fabric);
        motion.positions = startFrom(c.positions);
        motion.velocities.setZero(motion.positions.size());
        generation = c.generation;
        measure();
        if (state == State::Failed) {
            run(); // what failed was another fabric
        }
        wake();
    }

    void on(const command::Start&) {
        if (loaded() && state != State::Running) {
            run();
        }
        singleStep = false;
    }

    void on(const command::Pause&) {
        if (state == State::Running) {
            halt(State::Paused, StopReason::Paused);
        }
    }

    void on(const command::Step&) {
        if (loaded()) {
            run();
            singleStep = true;
        }
    }

    void on(const command::Restart& c) {
        if (loaded()) {
            begin(physics::machinePositions(*fabric), c.generation);
        } else {
            generation = c.generation;
        }
    }

    void on(const command::Stop&) {
        if (!loaded()) {
            return;
        }
        motion.velocities.setZero();
        initialised = false;
        last.kinetic = 0;
        halt(State::Paused, StopReason::Stopped);
    }

    void on(const command::SetIntegrator& c) {
        auto made = physics::makeIntegrator(c.id);
        if (made) {
            integrator = std::move(made);
            integratorId = c.id;
            initialised = false;
            millisecondsPerStep = 0;
            stopRule.restart();
        }
    }

    void on(const command::SetYarn& c) {
        if (c.carrier < 0 || c.carrier >= machine::kMaxCarriers) {
            return;
        }
        const auto carrier = static_cast<std::size_t>(c.carrier);
        if (yarns.size() <= carrier) {
            yarns.resize(carrier + 1);
        }
        yarns[carrier] = c.yarn;
        if (loaded()) {
            buildNet();
            measure();
            wake();
        }
    }

    void on(const command::SetResidual& c) {
        if (c.limit > 0 && std::isfinite(c.limit)) {
            stopRule.setLimit(c.limit);
            wake();
        }
    }

    void on(const command::Drag& c) {
        if (isEntry(c.entry) && std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z)) {
            drag = c;
            net.model->pull(c.entry, {c.x, c.y, c.z});
            wake();
        }
    }

    void on(const command::Release&) {
        if (drag) {
            drag.reset();
            net.model->release();
            wake();
        }
    }

    void on(const command::Pin& c) {
        if (!isEntry(c.entry)) {
            return;
        }
        std::erase(pins, c.entry);
        if (c.pinned) {
            pins.push_back(c.entry);
        }
        net.model->setPinned(c.entry, c.pinned);
        wake();
    }

    /// One integrator step; a shape of useless numbers is thrown away.
    void step(const physics::Interrupt& interrupt) {
        if (motion.positions.size() == 0) {
            halt(State::AtRest, StopReason::ResidualReached); // a fabric of nothing
            return;
        }
        if (!initialised) {
            integrator->initialise(*net.model, motion);
            initialised = true;
        }
        const physics::Motion good = motion;
        const Clock::time_point start = Clock::now();
        const StepReport report = integrator->step(motion, interrupt);
        if (report.outcome == StepReport::Outcome::Cancelled) {
            motion = good;
            initialised = false;
            return;
        }
        ++steps;
        const double spent = millisecondsSince(start);
        millisecondsPerStep = steps == 1 ? spent : millisecondsPerStep + 0.2 * (spent - millisecondsPerStep);
        const StopReason why =
            reasonOf(stopRule.judge(report, motion.positions, integrator->takesLargeSteps()));
        if (isFailure(why)) {
            motion = good;
            initialised = false;
            note = report.note;
            measure();
            halt(State::Failed, why);
            return;
        }
        last = report;
        if (why != StopReason::None) {
            halt(State::AtRest, why);
        } else if (singleStep) {
            halt(State::Paused, StopReason::Paused);
        }
    }

    void fail(const char* what) {
        note = what;
        halt(loaded() ? State::Failed : State::Empty, StopReason::SolverFailed);
    }
};

Simulation::Simulation() : m(std::make_unique<Implementation>()) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::apply(const Command& command) {
    try {
        std::visit([this](const auto& c) { m->on(c); }, command);
    } catch (const std::exception& e) {
        m->fail(e.what());
    }
}

bool Simulation::advance(double milliseconds, const std::function<bool()>* cancelled) {
    const physics::Interrupt interrupt(cancelled);
    const Clock::time_point start = Clock::now();
    bool changed = false;
    try {
        while (m->state == State::Running && !interrupt.wanted()) {
            m->step(interrupt);
            changed = true;
            if (millisecondsSince(start) >= milliseconds) {
                break;
            }
        }
    } catch (const std::exception& e) {
        m->fail(e.what());
        changed = true;
    }
    return changed;
}

void Simulation::runToEnd(double maxSeconds) {
    const Clock::time_point start = Clock::now();
    if (m->state == State::Ready || m->state == State::Paused) {
        apply(command::Start{});
    }
    while (m->state == State::Running && millisecondsSince(start) < 1e3 * maxSeconds) {
        advance(0);
    }
}

State Simulation::state() const {
    return m->state;
}

Simulation::Status Simulation::status() const {
    return {m->generation, m->reason, m->note};
}

bool Simulation::takesLargeSteps() const {
    return m->integrator->takesLargeSteps();
}

Frame Simulation::frame() const {
    Frame frame;
    frame.generation = m->generation;
    frame.step = m->steps;
    frame.state = m->state;
    frame.reason = m->reason;
    frame.integrator = m->integratorId;
    frame.note = m->note;
    if (!m->loaded()) {
        return frame;
    }
    const physics::Vector& x = m->motion.positions;
    frame.positions.resize(static_cast<std::size_t>(x.size()));
    Eigen::Map<Eigen::VectorXf>(frame.positions.data(), x.size()) = x.cast<float>();
    frame.tension.resize(m->fabric->points.size());
    m->net.tensions(x, frame.tension);
    frame.energies = {m->last.kinetic, m->last.potential};
    frame.residual = m->stopRule.residual(m->last.forceNorm);
    frame.stepSize = m->last.stepSize;
    frame.time = m->motion.time;
    frame.millisecondsPerStep = m->millisecondsPerStep;
    return frame;
}

} // namespace knittsim::simulation
