#include "core/simulation/settling_record.h"

#include "core/fabric/machine_shape.h"
#include "core/simulation/simulation.h"
#include "core/simulation/yarn_settling.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace knittsim::simulation {

namespace {

constexpr double kStepShare = 0.02; ///< of a loop's yarn, from shape to shape

double meanWay(std::span<const float> a, std::span<const float> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += static_cast<double>(a[i] - b[i]) * (a[i] - b[i]);
    }
    return std::sqrt(3 * sum / static_cast<double>(std::max<std::size_t>(1, a.size())));
}

/// Asks the caller and the clock.
class Watch {
public:
    Watch(const Progress& progress, double maxSeconds) : m_progress(progress), m_maxSeconds(maxSeconds) {}

    /// What is left is not known: the share only rises, and slower and slower.
    bool goesOn() {
        ++m_steps;
        const double share = 1 - 1 / (1 + 0.02 * static_cast<double>(m_steps));
        m_cancelled = m_cancelled || (m_progress && !m_progress(share));
        return !m_cancelled && !late();
    }
    bool late() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count() >
               m_maxSeconds;
    }
    bool cancelled() const { return m_cancelled; }

private:
    const Progress& m_progress;
    double m_maxSeconds;
    long m_steps = 0;
    bool m_cancelled = false;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

void recordPoints(const std::shared_ptr<const fabric::Fabric>& fabric, const std::vector<yarn::Yarn>& yarns,
                  Watch& watch, SettlingRecord& record) {
    Simulation simulation;
    simulation.apply(command::Load{.fabric = fabric, .yarns = yarns, .generation = 1});
    simulation.apply(command::SetIntegrator{"fire"}); // small steps, and quick
    simulation.apply(command::Start{});
    while (watch.goesOn() && simulation.state() == State::Running) {
        simulation.advance(0); // one step
        Frame frame = simulation.frame();
        if (record.wants(frame.positions) || simulation.state() != State::Running) {
            record.add({std::move(frame.positions)});
        }
    }
}

/// False where there is nothing to settle.
Result<bool> recordYarn(const fabric::Fabric& fabric, const std::vector<yarn::Yarn>& yarns,
                        Surroundings surroundings, Watch& watch, SettlingRecord& record) {
    YarnSettling settling(fabric, yarns, {.surroundings = surroundings});
    if (*settling.problem() != '\0') {
        return Diagnostic{.id = "KS0406", .place = {}, .arguments = {settling.problem()}};
    }
    const std::function<bool()> late = [&watch] { return watch.cancelled() || watch.late(); };
    bool more = true;
    while (more && watch.goesOn()) {
        more = settling.step(physics::Interrupt(&late));
        std::vector<float> places = entryPositions(fabric, settling.yarns(), settling.shape());
        if (!more || record.wants(places)) {
            record.add({std::move(places), std::make_shared<const geometry::YarnCurves>(settling.curves())});
        }
    }
    return true;
}

} // namespace

SettlingRecord::SettlingRecord(double stepMm, std::size_t most)
    : m_stepMm(stepMm), m_most(std::max<std::size_t>(1, most)) {}

bool SettlingRecord::wants(std::span<const float> positions) const {
    return m_shapes.empty() || m_shapes.back().positions.size() != positions.size() ||
           meanWay(m_shapes.back().positions, positions) >= m_stepMm;
}

void SettlingRecord::add(SettlingShape shape) {
    if (m_shapes.size() >= 2 * m_most) {
        std::size_t kept = 1;
        for (std::size_t i = 2; i < m_shapes.size(); i += 2) {
            m_shapes[kept++] = std::move(m_shapes[i]);
        }
        m_shapes.resize(kept);
        m_stepMm *= 2;
    }
    m_shapes.push_back(std::move(shape));
}

Result<std::vector<SettlingShape>> recordSettling(const std::shared_ptr<const fabric::Fabric>& fabric,
                                                  const std::vector<yarn::Yarn>& yarns,
                                                  const RecordOptions& options, const Progress& progress) {
    SettlingRecord record(kStepShare * fabric::meanLoopLength(*fabric), options.most);
    Watch watch(progress, options.maxSeconds);
    if (options.yarn) {
        const auto settled = recordYarn(*fabric, yarns, options.surroundings, watch, record);
        if (!settled) {
            return Result<std::vector<SettlingShape>>::failure(settled.diagnostics());
        }
    } else {
        record.add({fabric::machinePlaces(*fabric)});
        recordPoints(fabric, yarns, watch, record);
    }
    if (watch.cancelled()) {
        return Diagnostic{.id = "KS0009", .place = {}, .arguments = {}};
    }
    return record.takeShapes();
}

} // namespace knittsim::simulation
