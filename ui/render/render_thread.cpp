#include "ui/render/render_thread.h"

#include "ui/render/egl_context.h"
#include "ui/render/frame_target.h"

#include <chrono>
#include <utility>

namespace knittsim::render {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kBestSamples = 4;
constexpr double kQuickMs = 150; ///< the best picture takes about four times as long as a fast one
constexpr std::chrono::milliseconds kPause(150); ///< without news before the best picture is drawn

/// Draws requests with one renderer; keeps framebuffers between pictures of one size.
class Painter {
public:
    explicit Painter(FabricRenderer& renderer) : m_renderer(renderer) {}

    RenderThread::Picture paint(const RenderThread::Request& request, Quality quality) {
        const auto start = Clock::now();
        FrameTarget* target = targetFor(request.view, quality);
        RenderThread::Picture picture{.image = {}, .milliseconds = 0, .quality = quality};
        if (target == nullptr) {
            return picture;
        }
        if (request.scene != m_shown) {
            m_shown = request.scene;
            if (!m_shown || !m_renderer.upload(m_shown)) {
                m_renderer.clear();
            }
        }
        m_renderer.setLooks(request.looks);
        m_renderer.setSelection(request.selection);
        m_renderer.setHovered(request.hovered);
        View view = request.view;
        view.quality = quality;
        target->bind();
        m_renderer.draw(view);
        picture.image = target->read();
        picture.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        return picture;
    }

private:
    FrameTarget* targetFor(const View& view, Quality quality) {
        std::unique_ptr<FrameTarget>& target = quality == Quality::Best ? m_best : m_fast;
        if (!target || target->width() != view.width || target->height() != view.height) {
            target.reset();
            auto created =
                FrameTarget::create(view.width, view.height, quality == Quality::Best ? kBestSamples : 0);
            if (created) {
                target = std::move(created.value());
            }
        }
        return target.get();
    }

    FabricRenderer& m_renderer;
    std::unique_ptr<FrameTarget> m_fast;
    std::unique_ptr<FrameTarget> m_best;
    std::shared_ptr<const SceneFrame> m_shown;
};

} // namespace

Result<std::unique_ptr<RenderThread>> RenderThread::start(std::function<void()> ready) {
    std::unique_ptr<RenderThread> thread(new RenderThread(std::move(ready)));
    thread->m_thread = std::thread([raw = thread.get()] { raw->run(); });
    std::unique_lock lock(thread->m_mutex);
    thread->m_changed.wait(lock, [&] { return thread->m_running || !thread->m_failure.empty(); });
    if (!thread->m_running) {
        const Diagnostics failure = thread->m_failure;
        lock.unlock();
        return Result<std::unique_ptr<RenderThread>>::failure(failure);
    }
    lock.unlock();
    return thread;
}

RenderThread::~RenderThread() {
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_changed.notify_all();
    m_thread.join();
}

void RenderThread::post(Request request) {
    {
        const std::lock_guard lock(m_mutex);
        m_next = std::move(request);
    }
    m_changed.notify_all();
}

std::optional<RenderThread::Picture> RenderThread::take() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_done, std::nullopt);
}

void RenderThread::wait() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return !m_next && !m_busy; });
}

void RenderThread::run() {
    const auto context = EglContext::create();
    Diagnostics failure = context.diagnostics();
    if (context) {
        auto renderer = FabricRenderer::create();
        failure = renderer.diagnostics();
        if (renderer) {
            {
                const std::lock_guard lock(m_mutex);
                m_rendererName = renderer.value()->rendererName();
                m_running = true;
            }
            m_changed.notify_all();
            serve(*renderer.value());
            return;
        }
    }
    {
        const std::lock_guard lock(m_mutex);
        m_failure = failure;
    }
    m_changed.notify_all();
}

void RenderThread::serve(FabricRenderer& renderer) {
    Painter painter(renderer);
    while (std::optional<Request> request = nextRequest()) {
        RenderThread::Picture fast = painter.paint(*request, Quality::Fast);
        const bool quick = fast.milliseconds < kQuickMs;
        publish(std::move(fast));
        if (!quick) {
            continue;
        }
        std::unique_lock lock(m_mutex);
        const bool news = m_changed.wait_for(lock, kPause, [this] { return m_stop || m_next; });
        lock.unlock();
        if (!news) {
            publish(painter.paint(*request, Quality::Best));
        }
    }
}

std::optional<RenderThread::Request> RenderThread::nextRequest() {
    std::unique_lock lock(m_mutex);
    m_busy = false;
    m_changed.notify_all();
    m_changed.wait(lock, [this] { return m_stop || m_next; });
    m_busy = true;
    return m_stop ? std::nullopt : std::exchange(m_next, std::nullopt);
}

void RenderThread::publish(Picture picture) {
    {
        const std::lock_guard lock(m_mutex);
        m_done = std::move(picture);
    }
    m_ready();
}

} // namespace knittsim::render
