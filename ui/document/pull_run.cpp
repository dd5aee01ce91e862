#include "ui/document/pull_run.h"

#include "ui/document/mailbox.h"

#include <functional>
#include <limits>
#include <utility>

namespace knittsim::document {

PullRun::PullRun(QObject* parent) : QObject(parent), m_mailbox(std::make_shared<Mailbox>(this)) {
    m_pool.setMaxThreadCount(1);
}

PullRun::~PullRun() {
    if (m_cancelled) {
        m_cancelled->store(true);
    }
    m_mailbox->close();
}

void PullRun::start(std::shared_ptr<const fabric::Fabric> fabric, std::vector<yarn::Yarn> yarns,
                    const PullSettings& settings) {
    stop();
    m_points.clear();
    m_settings = settings;
    m_state = State::Settling;
    m_cancelled = std::make_shared<std::atomic<bool>>(false);
    const auto post = [this, mailbox = m_mailbox, run = m_cancelled](std::function<void()> news) {
        mailbox->post([this, run, news = std::move(news)] {
            if (run == m_cancelled) { // else of a run that was ended meanwhile
                news();
                emit changed();
            }
        });
    };
    m_pool.start(
        [this, fabric = std::move(fabric), yarns = std::move(yarns), settings, run = m_cancelled, post] {
            const std::function<bool()> cancelled = [&run] { return run->load(); };
            const auto found = physics::findFabricRepeat(*fabric);
            if (!found || cancelled()) {
                post([this] { end(State::NoRepeat); });
                return;
            }
            simulation::FabricCellOptions options;
            options.nodesPerLoop = simulation::kPullNodesPerLoop;
            options.relax.cancelled = &cancelled;
            options.relax.mostEvaluations = std::numeric_limits<int>::max(); // a person is the limit
            const simulation::FabricCell settled = simulation::settleCell(*fabric, *found, yarns, options);
            if (!physics::isAtRest(settled.cell.relax.verdict)) {
                post([this] { end(State::NotAtRest); });
                return;
            }
            const physics::KnitPurl& pattern = found->repeat.pattern;
            post([this, units = settled.units, wales = pattern.wales, courses = pattern.courses] {
                m_state = State::Pulling;
                m_units = units;
                m_wales = wales;
                m_courses = courses;
            });
            physics::PullOptions pull;
            pull.side = settings.side;
            pull.strain = settings.strain;
            pull.steps = settings.steps;
            pull.relax = options.relax;
            pull.onPoint = [&](const physics::PullPoint& point) {
                post([this, point] { m_points.push_back(point); });
            };
            const physics::PullResult result = physics::pullCell(pattern, settled.cell, pull);
            const bool good = physics::isAtRest(result.verdict);
            post([this, good] { end(good ? State::Done : State::NotAtRest); });
        });
    emit changed();
}

void PullRun::end(State state) {
    m_state = state;
    m_cancelled.reset();
}

void PullRun::stop() {
    if (m_cancelled) {
        m_cancelled->store(true);
        end(State::Stopped);
        emit changed();
    }
}

QByteArray PullRun::csv() const {
    return QByteArray::fromStdString(simulation::pullCsv(m_points, m_units));
}

} // namespace knittsim::document
