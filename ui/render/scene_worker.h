#pragma once

#include "core/simulation/frame.h"
#include "core/simulation/yarn_picture.h"
#include "ui/render/fabric_scene.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace knittsim::render {

/// Prepares frames on a thread of its own, so that a window never waits for curves. Of several jobs that
/// wait, the latest wins; when none waits, the last picture is improved (FabricScene::improve). All functions
/// return at once; the destructor waits for the job at hand.
class SceneWorker {
public:
    struct Job {
        std::shared_ptr<const fabric::Fabric> fabric; ///< not null
        std::vector<YarnLook> looks;
        DrawStyle style = DrawStyle::Yarn;
        std::shared_ptr<const simulation::Frame> shape;        ///< null, or foreign: as the machine leaves it
        std::shared_ptr<const simulation::YarnPicture> yarn{}; ///< if given, instead of `shape`; not for Mesh
        ColourBy colourBy = ColourBy::Yarn;
    };
    struct Picture {
        std::shared_ptr<const fabric::Fabric> fabric;
        std::shared_ptr<const SceneFrame> scene;
    };

    /// `ready` is called on the worker's thread when a picture waits; it must be quick and thread-safe.
    explicit SceneWorker(std::function<void()> ready);
    ~SceneWorker();
    SceneWorker(const SceneWorker&) = delete;
    SceneWorker& operator=(const SceneWorker&) = delete;

    void post(Job job);

    /// The latest picture if there is one that was not taken yet.
    std::optional<Picture> take();

private:
    void run();
    std::shared_ptr<const SceneFrame> prepare(const Job& job);
    void deliver(const Job& job);
    bool improve(const Job& job);
    void rememberShape(const Job& job);
    std::vector<float> movement(const Job& job) const;

    std::function<void()> m_ready;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::optional<Job> m_next;
    std::optional<Picture> m_done;
    bool m_stop = false;

    // Worker's thread only: the scene of the last job, kept while only the shape changes.
    std::unique_ptr<FabricScene> m_scene;
    std::shared_ptr<const fabric::Fabric> m_sceneFabric;
    // The present shape and the one before it, for ColourBy::Speed.
    std::shared_ptr<const simulation::Frame> m_shape, m_shapeBefore;
    std::shared_ptr<const simulation::YarnPicture> m_yarn, m_yarnBefore;
    DrawStyle m_sceneStyle = DrawStyle::Yarn;
    std::vector<double> m_sceneDiameters;

    std::thread m_thread; // last: it uses all the others
};

} // namespace knittsim::render
