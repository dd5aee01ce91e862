#include "ui/document/yarn_run.h"

#include "ui/document/mailbox.h"

#include <QElapsedTimer>

#include <functional>
#include <utility>

namespace knittsim::document {

namespace {

constexpr qint64 kShapeIntervalMs = 100;

std::shared_ptr<YarnShape> shapeOf(const std::shared_ptr<const fabric::Fabric>& fabric,
                                   const simulation::YarnSettling& settling) {
    auto shape = std::make_shared<YarnShape>();
    shape->fabric = fabric;
    shape->curves = std::make_shared<geometry::YarnCurves>(settling.curves());
    shape->places = simulation::entryPositions(*fabric, settling.yarns(), settling.shape());
    shape->steps = settling.report().steps;
    shape->growing = settling.phase() == simulation::YarnSettling::Phase::Growing;
    shape->verdict = settling.report().verdict;
    return shape;
}

/// `tell` gets shapes while it goes on and the last one with its audit. Returns what is in the way.
QString settle(const std::shared_ptr<const fabric::Fabric>& fabric, const std::vector<yarn::Yarn>& yarns,
               const std::function<bool()>& cancelled,
               const std::function<void(std::shared_ptr<const YarnShape>)>& tell) {
    simulation::YarnSettling settling(*fabric, yarns, {});
    if (*settling.problem() != '\0') {
        return QString::fromUtf8(settling.problem());
    }
    QElapsedTimer sinceShape;
    sinceShape.start();
    while (settling.step(physics::Interrupt(&cancelled))) {
        if (sinceShape.elapsed() >= kShapeIntervalMs) {
            tell(shapeOf(fabric, settling));
            sinceShape.restart();
        }
    }
    if (!cancelled()) {
        auto last = shapeOf(fabric, settling);
        last->audit = settling.audit();
        last->measured = geometry::measure(*fabric, last->places);
        last->finished = true;
        tell(last);
    }
    return {};
}

} // namespace

YarnRun::YarnRun(QObject* parent) : QObject(parent), m_mailbox(std::make_shared<Mailbox>(this)) {
    m_pool.setMaxThreadCount(1);
}

YarnRun::~YarnRun() {
    if (m_cancelled) {
        m_cancelled->store(true);
    }
    m_mailbox->close();
}

void YarnRun::start(std::shared_ptr<const fabric::Fabric> fabric, std::vector<yarn::Yarn> yarns) {
    stop();
    m_problem.clear();
    m_cancelled = std::make_shared<std::atomic<bool>>(false);
    emit changed();
    m_pool.start([this, fabric = std::move(fabric), yarns = std::move(yarns), run = m_cancelled,
                  mailbox = m_mailbox] {
        const std::function<bool()> cancelled = [&run] { return run->load(); };
        const QString problem = settle(fabric, yarns, cancelled, [&](std::shared_ptr<const YarnShape> shape) {
            mailbox->post([this, run, shape = std::move(shape)] { take(run, shape); });
        });
        if (!problem.isEmpty()) {
            mailbox->post([this, run, problem] { fail(run, problem); });
        }
    });
}

void YarnRun::take(const Flag& run, std::shared_ptr<const YarnShape> shape) {
    if (run != m_cancelled) {
        return; // of a run that was ended meanwhile
    }
    m_shape = std::move(shape);
    if (m_shape->finished) {
        m_cancelled.reset();
    }
    emit changed();
}

void YarnRun::fail(const Flag& run, const QString& problem) {
    if (run == m_cancelled) {
        m_cancelled.reset();
        m_problem = problem;
        emit changed();
    }
}

void YarnRun::stop() {
    if (m_cancelled) {
        m_cancelled->store(true);
        m_cancelled.reset();
        emit changed();
    }
}

void YarnRun::clear() {
    const bool had = m_shape || m_cancelled || !m_problem.isEmpty();
    if (m_cancelled) {
        m_cancelled->store(true);
        m_cancelled.reset();
    }
    m_shape.reset();
    m_problem.clear();
    if (had) {
        emit changed();
    }
}

} // namespace knittsim::document
