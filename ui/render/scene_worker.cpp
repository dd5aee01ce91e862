#include "ui/render/scene_worker.h"

#include "ui/render/movement.h"

#include <utility>

namespace knittsim::render {

SceneWorker::SceneWorker(std::function<void()> ready)
    : m_ready(std::move(ready)), m_thread([this] { run(); }) {}

SceneWorker::~SceneWorker() {
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_wake.notify_one();
    m_thread.join();
}

void SceneWorker::post(Job job) {
    {
        const std::lock_guard lock(m_mutex);
        m_next = std::move(job);
    }
    m_wake.notify_one();
}

std::optional<SceneWorker::Picture> SceneWorker::take() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_done, std::nullopt);
}

void SceneWorker::run() {
    for (;;) {
        Job job;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, [this] { return m_stop || m_next; });
            if (m_stop) {
                return;
            }
            job = std::move(*m_next);
            m_next.reset();
        }
        deliver(job);
        if (improve(job)) {
            deliver(job);
        }
    }
}

void SceneWorker::deliver(const Job& job) {
    Picture picture{job.fabric, prepare(job)};
    {
        const std::lock_guard lock(m_mutex);
        m_done = std::move(picture);
    }
    m_ready();
}

/// As long as nothing waits. Returns whether the picture differs and nothing waits.
bool SceneWorker::improve(const Job& job) {
    if (job.yarn) {
        return false;
    }
    const auto idle = [this] {
        const std::lock_guard lock(m_mutex);
        return !m_stop && !m_next;
    };
    bool improved = false;
    while (idle() && m_scene->improve()) {
        improved = true;
    }
    return improved && idle();
}

std::shared_ptr<const SceneFrame> SceneWorker::prepare(const Job& job) {
    std::vector<double> diameters;
    for (const YarnLook& look : job.looks) {
        diameters.push_back(look.diameterMm);
    }
    if (!m_scene || m_sceneFabric != job.fabric || m_sceneStyle != job.style ||
        m_sceneDiameters != diameters) {
        m_scene = std::make_unique<FabricScene>(job.fabric, job.looks, job.style);
        m_sceneFabric = job.fabric;
        m_sceneStyle = job.style;
        m_sceneDiameters = std::move(diameters);
    }
    rememberShape(job);
    const std::vector<float> moved = job.colourBy == ColourBy::Speed ? movement(job) : std::vector<float>();
    using Values = std::span<const float>;
    if (job.yarn && job.style != DrawStyle::Mesh) {
        const simulation::YarnPicture& yarn = *job.yarn;
        return m_scene->prepareCurves(yarn.curves, job.colourBy == ColourBy::Tension   ? Values(yarn.tension)
                                                   : job.colourBy == ColourBy::Contact ? Values(yarn.contact)
                                                                                       : Values(moved));
    }
    const std::size_t expected = 3 * static_cast<std::size_t>(job.fabric->entryCount);
    if (!job.shape || job.shape->positions.size() != expected) {
        return m_scene->prepare({});
    }
    return m_scene->prepare(job.shape->positions,
                            job.colourBy == ColourBy::Tension ? Values(job.shape->tension) : Values(moved));
}

/// A picture may be made again of the same shape, in another style.
void SceneWorker::rememberShape(const Job& job) {
    if (job.shape != m_shape) {
        m_shapeBefore = std::exchange(m_shape, job.shape);
    }
    if (job.yarn != m_yarn) {
        m_yarnBefore = std::exchange(m_yarn, job.yarn);
    }
}

std::vector<float> SceneWorker::movement(const Job& job) const {
    if (job.yarn) {
        return m_yarnBefore ? movementOfNodes(job.yarn->curves, m_yarnBefore->curves) : std::vector<float>();
    }
    return job.shape && m_shapeBefore
               ? movementOfPoints(*job.fabric, job.shape->positions, m_shapeBefore->positions)
               : std::vector<float>();
}

} // namespace knittsim::render
