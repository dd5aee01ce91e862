#pragma once

#include "ui/render/fabric_renderer.h"
#include "ui/render/image.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace knittsim::render {

/// Draws on a thread of its own with a context of its own (EGL, no display): for software OpenGL, whose
/// frames take longer than a window may wait. Of several requests that wait, the latest wins. When no other
/// one follows, the last picture is drawn once more in best quality. All functions return at once unless they
/// say otherwise.
class RenderThread {
public:
    struct Request {
        std::shared_ptr<const SceneFrame> scene; ///< null: background only
        std::vector<YarnLook> looks;
        std::vector<machine::LoopIndex> selection;
        machine::LoopIndex hovered = -1;
        View view;
    };
    struct Picture {
        Image image;
        double milliseconds = 0;
        Quality quality = Quality::Fast;
        std::optional<DetailLevel> level{}; ///< drawn; nothing without a scene
        bool tooLarge = false;              ///< for the graphics driver: only the background is drawn
    };

    /// `ready` is called on the thread when a picture or a failure waits; it must be quick and thread-safe.
    /// Waits until the context is made. When the driver resets it, which `lost` finds out after each picture,
    /// the thread begins anew with another one and draws the last request again. Errors: KS0401, KS0402,
    /// KS0403.
    static Result<std::unique_ptr<RenderThread>>
    start(std::function<void()> ready, std::function<bool()> lost = FabricRenderer::contextIsLost);

    ~RenderThread();
    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    void post(Request request);

    /// The latest picture if there is one that was not taken yet.
    std::optional<Picture> take();

    /// Why nothing more will be drawn; empty while all is well.
    Diagnostics failure() const;

    /// Waits until nothing is left to draw.
    void wait();

    std::string rendererName() const;

private:
    RenderThread(std::function<void()> ready, std::function<bool()> lost)
        : m_ready(std::move(ready)), m_lost(std::move(lost)) {}

    void run();
    /// How serving requests ended.
    enum class End : std::uint8_t { Stopped, LostAtOnce, Lost };
    End serve(FabricRenderer& renderer);
    void begin(const std::string& rendererName);
    void fail(Diagnostics failure);
    void putBack(Request request);
    std::optional<Request> nextRequest();
    void publish(Picture picture);

    std::function<void()> m_ready;
    std::function<bool()> m_lost;
    std::string m_rendererName;
    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::optional<Request> m_next;
    std::optional<Picture> m_done;
    Diagnostics m_failure;
    bool m_running = false; ///< the context is there
    bool m_busy = false;
    bool m_stop = false;
    std::thread m_thread;
};

} // namespace knittsim::render
