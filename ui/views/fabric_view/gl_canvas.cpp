#include "ui/render/level_of_detail.h"
#include "ui/views/fabric_view/canvas.h"
#include "ui/views/fabric_view/reason_text.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QTimer>

#include <algorithm>

namespace knittsim::ui {

namespace {

QSurfaceFormat wantedFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(4);
    format.setOption(QSurfaceFormat::ResetNotification);
    return format;
}

QString tr(const char* text) {
    return QCoreApplication::translate("knittsim::ui", text);
}

bool isSoftware(const QString& renderer) {
    static const QStringList kNames{QStringLiteral("llvmpipe"), QStringLiteral("softpipe"),
                                    QStringLiteral("swrast"), QStringLiteral("SwiftShader"),
                                    QStringLiteral("Software")};
    return std::ranges::any_of(kNames, [&](const QString& name) { return renderer.contains(name); });
}

/// Empty when a quick OpenGL 3.3 context can be made and used. QOpenGLWidget itself crashes where there is
/// none.
QString whyNoContext(bool mayBeSoftware) {
    QOpenGLContext context;
    context.setFormat(wantedFormat());
    if (!context.create()) {
        return tr("This display offers no OpenGL.");
    }
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface)) {
        return tr("OpenGL cannot be used on this display.");
    }
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const bool software = isSoftware(QString::fromLatin1(name));
    context.doneCurrent();
    if (software && !mayBeSoftware) {
        return tr("This display has software OpenGL only.");
    }
    if (context.format().version() < qMakePair(3, 3)) {
        return tr("OpenGL 3.3 is needed; this display has %1.%2.")
            .arg(context.format().majorVersion())
            .arg(context.format().minorVersion());
    }
    return {};
}

} // namespace

class GlCanvas final : public QOpenGLWidget, public Canvas {
    Q_DECLARE_TR_FUNCTIONS(knittsim::ui::GlCanvas)

public:
    GlCanvas(QWidget* parent, CanvasContent& content, std::function<void(QString)> failed)
        : QOpenGLWidget(parent), m_content(content), m_failed(std::move(failed)) {
        setFormat(wantedFormat());
        setAttribute(Qt::WA_TransparentForMouseEvents);
    }

    ~GlCanvas() override { release(); }

    QWidget* widget() override { return this; }
    QString rendererName() const override { return m_rendererName; }
    QImage picture() override { return width() > 0 && height() > 0 ? grabFramebuffer() : QImage(); }

protected:
    bool event(QEvent* event) override {
        if (event->type() != QEvent::WindowChangeInternal) {
            return QOpenGLWidget::event(event);
        }
        // In another window Qt makes everything anew, of a format that has lost its samples; a hidden widget
        // waits, so that the format can be asked for once more.
        hide();
        const bool known = QOpenGLWidget::event(event);
        setFormat(wantedFormat());
        show();
        return known;
    }

    void initializeGL() override {
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
        auto created = render::FabricRenderer::create();
        if (!created) {
            giveUp(reasonText(created.diagnostics()));
            return;
        }
        m_renderer = std::move(created.value());
        m_rendererName = QString::fromStdString(m_renderer->rendererName());
        m_uploaded.reset();
    }

    void paintGL() override {
        if (!m_renderer) {
            return;
        }
        QElapsedTimer timer;
        timer.start();
        if (m_content.scene && m_uploaded != m_content.scene) {
            m_uploaded = m_content.scene;
            if (!m_renderer->upload(m_uploaded)) {
                giveUp(tr("The fabric is too large for this graphics driver."));
                return;
            }
        }
        if (!m_content.scene) {
            m_renderer->clear();
            m_uploaded.reset();
        }
        m_renderer->setLooks(m_content.looks);
        const machine::LoopIndex selected = m_content.selected;
        m_renderer->setSelection({&selected, selected >= 0 ? std::size_t{1} : std::size_t{0}});
        m_renderer->setHovered(m_content.hovered);
        render::View view;
        view.camera = m_content.camera;
        view.width = qRound(width() * devicePixelRatioF());
        view.height = qRound(height() * devicePixelRatioF());
        view.section = m_content.section;
        view.hair = m_content.hair;
        view.level = m_content.level;
        view.dark = m_content.dark;
        m_renderer->draw(view);
        if (render::FabricRenderer::contextIsLost()) {
            giveUp(tr("The graphics driver was reset."));
            return;
        }
        m_content.paintMs = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
        m_content.levelDrawn = m_content.scene
                                   ? std::optional(levelDrawn(*m_content.scene, m_content.looks, view))
                                   : std::nullopt;
        m_content.painted();
    }

private:
    void release() {
        if (m_renderer) {
            makeCurrent();
            m_renderer.reset();
            doneCurrent();
        }
    }

    void giveUp(const QString& reason) {
        // Not from inside a paint: the answer is to delete this canvas.
        QTimer::singleShot(0, this, [this, reason] { m_failed(reason); });
    }

    CanvasContent& m_content;
    std::function<void(QString)> m_failed;
    std::unique_ptr<render::FabricRenderer> m_renderer;
    std::shared_ptr<const render::SceneFrame> m_uploaded;
    QString m_rendererName;
};

std::unique_ptr<Canvas> makeGlCanvas(QWidget* parent, CanvasContent& content,
                                     std::function<void(QString)> failed, QString& reason, bool software) {
    reason = whyNoContext(software);
    if (!reason.isEmpty()) {
        return nullptr;
    }
    return std::make_unique<GlCanvas>(parent, content, std::move(failed));
}

} // namespace knittsim::ui
