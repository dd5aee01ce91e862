#include "ui/render/render_thread.h"
#include "ui/views/fabric_view/canvas.h"
#include "ui/views/fabric_view/reason_text.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPointer>
#include <QTimer>
#include <QWidget>

namespace knittsim::ui {

namespace {

/// Shares the pixels, which stay with the picture.
QImage toQt(const std::shared_ptr<const render::Image>& image, qreal ratio) {
    auto* keep = new std::shared_ptr<const render::Image>(image);
    QImage shared(
        image->pixels.data(), image->width, image->height, QImage::Format_RGBX8888,
        [](void* owner) { delete static_cast<std::shared_ptr<const render::Image>*>(owner); }, keep);
    shared.setDevicePixelRatio(ratio);
    return shared;
}

} // namespace

class ThreadedCanvas final : public QWidget, public Canvas {
public:
    ThreadedCanvas(QWidget* parent, CanvasContent& content, std::function<void(QString)> failed)
        : QWidget(parent), m_content(content), m_failed(std::move(failed)) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_OpaquePaintEvent);
    }

    /// Empty when the thread runs.
    QString start() {
        // The widget may be gone when a picture arrives; then the event is dropped.
        auto started = render::RenderThread::start([guard = QPointer<ThreadedCanvas>(this), this] {
            QMetaObject::invokeMethod(
                this,
                [guard] {
                    if (guard)
                        guard->takePicture();
                },
                Qt::QueuedConnection);
        });
        if (!started) {
            return reasonText(started.diagnostics());
        }
        m_thread = std::move(started.value());
        return {};
    }

    QWidget* widget() override { return this; }
    QString rendererName() const override { return QString::fromStdString(m_thread->rendererName()); }

    void refresh() override {
        const QSize pixels = size() * devicePixelRatioF();
        if (pixels.isEmpty()) {
            return;
        }
        render::RenderThread::Request request;
        request.scene = m_content.scene;
        request.looks = m_content.looks;
        if (m_content.selected >= 0) {
            request.selection = {m_content.selected};
        }
        request.hovered = m_content.hovered;
        request.view.camera = m_content.camera;
        request.view.width = pixels.width();
        request.view.height = pixels.height();
        request.view.section = m_content.section;
        request.view.hair = m_content.hair;
        request.view.level = m_content.level;
        request.view.dark = m_content.dark;
        m_thread->post(std::move(request));
    }

    QImage picture() override {
        refresh();
        m_thread->wait();
        takePicture();
        return m_picture.copy();
    }

protected:
    void resizeEvent(QResizeEvent*) override { refresh(); }

    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        if (m_picture.isNull()) {
            painter.fillRect(rect(), m_content.dark ? QColor(37, 40, 44) : QColor(229, 231, 232));
        } else {
            // A picture of another size is stretched until the right one is ready.
            painter.drawImage(rect(), m_picture);
        }
    }

private:
    void takePicture() {
        if (const Diagnostics failure = m_thread->failure(); !failure.empty()) {
            giveUp(reasonText(failure));
            return;
        }
        auto picture = m_thread->take();
        if (picture && !picture->image.pixels.empty()) {
            m_content.paintMs = picture->milliseconds;
            m_content.levelDrawn = picture->level;
            m_content.painted();
            if (picture->tooLarge) {
                giveUp(tr("The fabric is too large for this graphics driver."));
            }
            m_picture = toQt(std::make_shared<render::Image>(std::move(picture->image)), devicePixelRatioF());
            update();
        }
    }

    void giveUp(const QString& reason) {
        // Not from inside a call of this canvas: the answer is to delete it.
        QTimer::singleShot(0, this, [this, reason] { m_failed(reason); });
    }

    static QString tr(const char* text) {
        return QCoreApplication::translate("knittsim::ui::FabricView", text);
    }

    CanvasContent& m_content;
    std::function<void(QString)> m_failed;
    QImage m_picture;
    std::unique_ptr<render::RenderThread> m_thread; // last: it calls back until it is gone
};

std::unique_ptr<Canvas> makeThreadedCanvas(QWidget* parent, CanvasContent& content,
                                           std::function<void(QString)> failed, QString& reason) {
    auto canvas = std::make_unique<ThreadedCanvas>(parent, content, std::move(failed));
    reason = canvas->start();
    if (!reason.isEmpty()) {
        return nullptr;
    }
    return canvas;
}

} // namespace knittsim::ui
