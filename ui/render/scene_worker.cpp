#include "ui/render/scene_worker.h"

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
    if (job.curves) {
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
    if (job.curves && job.style != DrawStyle::Mesh) {
        return m_scene->prepareCurves(*job.curves);
    }
    const std::size_t expected = 3 * static_cast<std::size_t>(job.fabric->entryCount);
    const bool fits = job.shape && job.shape->positions.size() == expected;
    return m_scene->prepare(fits ? std::span<const float>(job.shape->positions) : std::span<const float>());
}

} // namespace knittsim::render
