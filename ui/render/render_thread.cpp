#include "ui/render/render_thread.h"

#include "ui/render/egl_context.h"
#include "ui/render/frame_target.h"
#include "ui/render/level_of_detail.h"

#include <chrono>
#include <utility>

namespace knittsim::render {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kBestSamples = 4;
constexpr double kQuickMs = 150; ///< the best picture takes about four times as long as a fast one
constexpr int kMostLost = 3;     ///< contexts, one after the other without a picture
constexpr std::chrono::milliseconds kPause(150); ///< without news before the best picture is drawn

/// Draws requests with one renderer; keeps framebuffers between pictures of one size.
class Painter {
public:
    explicit Painter(FabricRenderer& renderer) : m_renderer(renderer) {}

    RenderThread::Picture paint(const RenderThread::Request& request, Quality quality) {
        const auto start = Clock::now();
        FrameTarget* target = targetFor(request.view, quality);
        RenderThread::Picture picture{.image = {}, .quality = quality};
        if (target == nullptr) {
            return picture;
        }
        if (request.scene != m_shown) {
            m_shown = request.scene;
            m_tooLarge = m_shown && !m_renderer.upload(m_shown);
            if (!m_shown) {
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
        if (m_shown) {
            picture.level = levelDrawn(*m_shown, request.looks, view);
        }
        picture.tooLarge = m_tooLarge;
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
    bool m_tooLarge = false;
};

} // namespace

Result<std::unique_ptr<RenderThread>> RenderThread::start(std::function<void()> ready,
                                                          std::function<bool()> lost) {
    std::unique_ptr<RenderThread> thread(new RenderThread(std::move(ready), std::move(lost)));
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
    m_changed.wait(lock, [this] { return !m_failure.empty() || (!m_next && !m_busy); });
}

std::string RenderThread::rendererName() const {
    const std::lock_guard lock(m_mutex);
    return m_rendererName;
}

Diagnostics RenderThread::failure() const {
    const std::lock_guard lock(m_mutex);
    return m_failure;
}

void RenderThread::run() {
    for (int lost = 0; lost < kMostLost;) {
        const auto context = EglContext::create();
        if (!context) {
            fail(context.diagnostics());
            return;
        }
        const auto renderer = FabricRenderer::create();
        if (!renderer) {
            fail(renderer.diagnostics());
            return;
        }
        begin(renderer.value()->rendererName());
        const End end = serve(*renderer.value());
        if (end == End::Stopped) {
            return;
        }
        lost = end == End::LostAtOnce ? lost + 1 : 0;
    }
    fail({{.id = "KS0401", .place = {}, .arguments = {"the graphics driver is reset again and again"}}});
}

void RenderThread::begin(const std::string& rendererName) {
    {
        const std::lock_guard lock(m_mutex);
        m_rendererName = rendererName;
        m_running = true;
    }
    m_changed.notify_all();
}

void RenderThread::fail(Diagnostics failure) {
    bool hasRun = false;
    {
        const std::lock_guard lock(m_mutex);
        m_failure = std::move(failure);
        hasRun = std::exchange(m_running, false);
        m_busy = false;
    }
    m_changed.notify_all();
    if (hasRun) {
        m_ready();
    }
}

RenderThread::End RenderThread::serve(FabricRenderer& renderer) {
    Painter painter(renderer);
    End lost = End::LostAtOnce; // unless a picture comes before
    while (std::optional<Request> request = nextRequest()) {
        RenderThread::Picture fast = painter.paint(*request, Quality::Fast);
        if (m_lost()) {
            putBack(std::move(*request));
            return lost;
        }
        lost = End::Lost;
        const bool quick = fast.milliseconds < kQuickMs;
        publish(std::move(fast));
        if (!quick) {
            continue;
        }
        std::unique_lock lock(m_mutex);
        const bool news = m_changed.wait_for(lock, kPause, [this] { return m_stop || m_next; });
        lock.unlock();
        if (!news) {
            RenderThread::Picture best = painter.paint(*request, Quality::Best);
            if (m_lost()) {
                putBack(std::move(*request));
                return lost;
            }
            publish(std::move(best));
        }
    }
    return End::Stopped;
}

/// To be drawn once more, unless another one waits.
void RenderThread::putBack(Request request) {
    const std::lock_guard lock(m_mutex);
    if (!m_next) {
        m_next = std::move(request);
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
