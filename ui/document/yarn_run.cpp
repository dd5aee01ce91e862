#include "ui/document/yarn_run.h"

#include "ui/document/mailbox.h"
#include "ui/document/yarn_job.h"

#include <QElapsedTimer>

#include <optional>
#include <utility>

namespace knittsim::document {

namespace {

constexpr qint64 kShapeIntervalMs = 100;

using Settling = simulation::YarnSettling;

struct Task {
    std::uint64_t generation = 0;
    std::shared_ptr<const fabric::Fabric> fabric;
    std::vector<yarn::Yarn> yarns;
    simulation::Surroundings surroundings = simulation::Surroundings::Flat;
    std::function<void(std::shared_ptr<const YarnShape>)> tell;
    std::function<void(const QString&)> fail;
};

std::shared_ptr<YarnShape> shapeOf(const Task& task, int edits, const Settling& settling) {
    auto shape = std::make_shared<YarnShape>();
    shape->generation = task.generation;
    shape->edits = edits;
    shape->fabric = task.fabric;
    shape->picture = std::make_shared<simulation::YarnPicture>(settling.picture());
    shape->steps = settling.report().steps;
    shape->growing = settling.phase() == Settling::Phase::Growing;
    shape->verdict = settling.report().verdict;
    return shape;
}

/// Before anything is worked out, which takes a while. Null without yarn.
std::shared_ptr<const YarnShape> firstShapeOf(const Task& task) {
    const simulation::FabricYarns yarns = simulation::guessYarns(*task.fabric, task.yarns);
    if (yarns.chains.nodeCount() == 0) {
        return nullptr;
    }
    const physics::Vector x = yarns.chains.start();
    auto shape = std::make_shared<YarnShape>();
    shape->generation = task.generation;
    shape->fabric = task.fabric;
    shape->picture =
        std::make_shared<simulation::YarnPicture>(curvesOf(yarns, x), entryPositions(*task.fabric, yarns, x),
                                                  std::vector<float>(), std::vector<float>());
    shape->growing = true;
    return shape;
}

std::shared_ptr<const YarnShape> lastShapeOf(const Task& task, int edits, const Settling& settling) {
    auto shape = shapeOf(task, edits, settling);
    shape->audit = settling.audit();
    shape->measured = geometry::measure(*task.fabric, shape->picture->positions);
    shape->finished = true;
    return shape;
}

/// Until the job is ended.
void settle(YarnJob& job, const Task& task) {
    if (job.ended()()) {
        return;
    }
    if (const auto first = firstShapeOf(task)) {
        task.tell(first);
    }
    Settling::Options options;
    options.layout.cancelled = &job.ended();
    options.surroundings = task.surroundings;
    Settling settling(*task.fabric, task.yarns, options);
    if (*settling.problem() != '\0') {
        task.fail(QString::fromUtf8(settling.problem()));
        return;
    }
    QElapsedTimer sinceShape;
    sinceShape.start();
    bool atRest = false;
    for (;;) {
        const YarnJob::Orders orders = job.next(atRest);
        if (orders.ended) {
            return;
        }
        for (const YarnJob::Edit& edit : orders.edits) {
            edit(settling);
        }
        settling.step(physics::Interrupt(&job.disturbed()));
        atRest = settling.phase() == Settling::Phase::Done;
        if (atRest) {
            task.tell(lastShapeOf(task, orders.taken, settling));
        } else if (sinceShape.elapsed() >= kShapeIntervalMs) {
            task.tell(shapeOf(task, orders.taken, settling));
            sinceShape.restart();
        }
    }
}

} // namespace

YarnRun::YarnRun(QObject* parent) : QObject(parent), m_mailbox(std::make_shared<Mailbox>(this)) {
    m_pool.setMaxThreadCount(1);
}

YarnRun::~YarnRun() {
    end();
    m_mailbox->close();
}

void YarnRun::start(std::shared_ptr<const fabric::Fabric> fabric, std::vector<yarn::Yarn> yarns) {
    end();
    m_problem.clear();
    m_job = std::make_shared<YarnJob>();
    m_running = true;
    m_edits = 0;
    Task task{.generation = ++m_generation,
              .fabric = std::move(fabric),
              .yarns = std::move(yarns),
              .surroundings = m_surroundings,
              .tell = {},
              .fail = {}};
    task.tell = [this, mailbox = m_mailbox](std::shared_ptr<const YarnShape> shape) {
        mailbox->post([this, shape = std::move(shape)] { take(shape); });
    };
    task.fail = [this, mailbox = m_mailbox, generation = m_generation](const QString& problem) {
        mailbox->post([this, generation, problem] { fail(generation, problem); });
    };
    m_pool.start([job = m_job, task = std::move(task)] { settle(*job, task); });
    emit changed();
}

void YarnRun::take(std::shared_ptr<const YarnShape> shape) {
    const bool late = shape->generation != m_generation || (!m_running && !shape->finished);
    if (late) {
        return; // of a run that was ended or paused meanwhile; the last shape of one comes once
    }
    m_running = m_running && (!shape->finished || shape->edits != m_edits);
    m_shape = std::move(shape);
    emit changed();
}

void YarnRun::fail(std::uint64_t generation, const QString& problem) {
    if (generation == m_generation && m_job) {
        end();
        m_problem = problem;
        emit changed();
    }
}

void YarnRun::end() {
    if (m_job) {
        m_job->end();
        m_job.reset();
    }
    m_running = false;
    m_dragging = false;
}

void YarnRun::pause() {
    if (m_running) {
        m_job->pause(true);
        m_running = false;
        emit changed();
    }
}

void YarnRun::resume() {
    if (m_job && !m_running) {
        m_job->pause(false);
        m_running = !m_shape || !m_shape->finished || m_shape->edits != m_edits;
        emit changed();
    }
}

void YarnRun::clear() {
    const bool had = m_shape || m_job || !m_problem.isEmpty();
    end();
    m_shape.reset();
    m_problem.clear();
    if (had) {
        emit changed();
    }
}

void YarnRun::edit(Edit change, bool replacesLast) {
    if (m_job) {
        m_job->add(std::move(change), replacesLast);
        ++m_edits;
        m_running = true;
        emit changed();
    }
}

void YarnRun::setYarn(machine::CarrierIndex carrier, const yarn::Yarn& yarn) {
    edit([carrier, yarn](Settling& s) { s.setYarn(carrier, yarn); });
}

void YarnRun::setSurroundings(simulation::Surroundings surroundings) {
    if (surroundings != m_surroundings) {
        m_surroundings = surroundings;
        edit([surroundings](Settling& s) { s.setSurroundings(surroundings); });
        emit changed();
    }
}

void YarnRun::drag(fabric::PointIndex point, const Vec3& place) {
    m_dragging = m_job != nullptr;
    edit([point, place](Settling& s) { s.drag(point, place); }, true);
}

void YarnRun::release() {
    if (std::exchange(m_dragging, false)) {
        edit([](Settling& s) { s.release(); });
    }
}

void YarnRun::setPinned(fabric::PointIndex point, bool pinned) {
    edit([point, pinned](Settling& s) { s.setPinned(point, pinned); });
}

} // namespace knittsim::document
