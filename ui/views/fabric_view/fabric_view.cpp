#include "ui/views/fabric_view/fabric_view.h"

#include "core/machine/needle.h"
#include "ui/render/scene_picking.h"
#include "ui/render/scene_worker.h"
#include "ui/views/fabric_view/camera_bytes.h"
#include "ui/views/fabric_view/canvas.h"
#include "ui/views/fabric_view/overlay.h"

#include <QCursor>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace knittsim::ui {

namespace {

constexpr float kPickPixels = 3;   ///< how far beside the yarn a click still counts
constexpr int kClickPixels = 4;    ///< a press that moves farther is a drag
constexpr double kWheelStep = 1.2; ///< zoom of one notch

QVector3D toQt(const Vec3f& v) {
    return {v.x(), v.y(), v.z()};
}

} // namespace

struct FabricView::Implementation {
    explicit Implementation(FabricView& owner)
        : view(owner), worker([&owner] {
              QMetaObject::invokeMethod(
                  &owner, [&owner] { owner.m->takePicture(); }, Qt::QueuedConnection);
          }) {}

    FabricView& view;
    CanvasContent content;
    std::shared_ptr<const fabric::Fabric> fabric;      ///< wanted
    std::shared_ptr<const fabric::Fabric> shownFabric; ///< of content.scene
    std::shared_ptr<const simulation::Frame> frame;
    std::shared_ptr<const geometry::YarnCurves> curves; ///< see setCurves()
    render::DrawStyle style = render::DrawStyle::Yarn;
    std::unique_ptr<Canvas> canvas;
    Overlay* overlay = nullptr;
    bool hasGl = true;
    QString glReason;
    bool fitPending = true; ///< fit as soon as there is a picture
    bool following = false; ///< see setFollowing()
    bool followFit = true;  ///< the person has not moved the camera since the last fit
    bool dragMode = false;
    int selectedPoint = -1; ///< of `fabric`

    enum class Gesture { None, Press, Orbit, Pan, Pull } gesture = Gesture::None;
    QPointF pressed;
    QPointF last;
    geometry::Pick pulled;

    void makeCanvas();
    void useFlatCanvas(const QString& reason);
    void placeChildren();
    void request();
    void takePicture();
    void changed();
    void moveCamera(const std::function<void(render::Camera&)>& move);
    void look(render::ViewSide side);
    std::optional<geometry::Pick> pickAt(QPointF where) const;
    void hover(int loop);
    void placeMark();
    void pullTo(QPointF where);
    Vec3f placeOf(fabric::EntryIndex entry) const;
    QString describe(int loop) const;

    render::SceneWorker worker; // last: it may call back until it is gone
};

FabricView::FabricView(QWidget* parent) : QWidget(parent), m(std::make_unique<Implementation>(*this)) {
    setObjectName(QStringLiteral("fabricView"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Fabric"));
    setAccessibleDescription(
        tr("The knitted fabric in three dimensions. Drag to turn it, drag with Shift to move "
           "it, turn the wheel to come nearer, click a stitch to select it."));
    m->content.camera.setViewport(width(), height());
    m->makeCanvas();
    m->overlay = new Overlay(this, m->content);
    m->overlay->setMessage(m->glReason.isEmpty() ? tr("No fabric yet") : m->glReason);
    m->placeChildren();
}

FabricView::~FabricView() = default;

void FabricView::Implementation::makeCanvas() {
    // For comparing and for machines whose driver misbehaves: window, thread or none.
    const QByteArray wanted = qgetenv("KNITTSIM_OPENGL");
    if (wanted.isEmpty() || wanted == "window") {
        canvas = makeGlCanvas(
            &view, content, [this](const QString& reason) { useFlatCanvas(reason); }, glReason);
    }
    if (!canvas && wanted != "none") {
        canvas = makeThreadedCanvas(&view, content, glReason);
    }
    if (wanted == "none") {
        glReason = tr("OpenGL is switched off.");
    }
    if (!canvas) {
        const QString reason = glReason;
        useFlatCanvas(reason);
    }
}

void FabricView::Implementation::useFlatCanvas(const QString& reason) {
    hasGl = false;
    glReason = tr("%1 The fabric is drawn flat.").arg(reason);
    canvas = makeFlatCanvas(&view, content);
    if (overlay != nullptr) {
        overlay->setMessage(glReason);
        placeChildren();
    }
    // Also when this happens in the constructor: then somebody has connected by now.
    QTimer::singleShot(0, &view, [this] { emit view.glFailed(glReason); });
}

void FabricView::Implementation::placeChildren() {
    content.camera.setViewport(view.width(), view.height());
    canvas->widget()->setGeometry(view.rect());
    canvas->widget()->show();
    overlay->setGeometry(view.rect());
    overlay->raise();
}

void FabricView::Implementation::request() {
    if (fabric) {
        worker.post({fabric, content.looks, style, frame, curves});
    }
}

void FabricView::Implementation::takePicture() {
    auto picture = worker.take();
    // A picture of a fabric that was replaced meanwhile is of no use: its successor is under way.
    if (!picture || picture->fabric != fabric) {
        return;
    }
    content.scene = std::move(picture->scene);
    shownFabric = std::move(picture->fabric);
    content.camera.setScene(content.scene->bounds);
    placeMark();
    if ((fitPending || (following && followFit)) && !content.scene->bounds.empty()) {
        fitPending = false;
        content.camera.fit(content.scene->bounds);
    }
    changed();
}

void FabricView::Implementation::changed() {
    const bool allHasRun = shownFabric && shownFabric->points.empty() && !shownFabric->loops.empty();
    overlay->setMessage(allHasRun                  ? tr("All of the fabric has run")
                        : !hasGl                   ? glReason
                        : content.scene == nullptr ? tr("No fabric yet")
                                                   : QString());
    canvas->refresh();
}

void FabricView::Implementation::moveCamera(const std::function<void(render::Camera&)>& move) {
    followFit = false;
    move(content.camera);
    overlay->update();
    canvas->refresh();
}

void FabricView::Implementation::look(render::ViewSide side) {
    moveCamera([side](render::Camera& camera) { camera.look(side); });
}

std::optional<geometry::Pick> FabricView::Implementation::pickAt(QPointF where) const {
    if (!content.scene || !shownFabric) {
        return std::nullopt;
    }
    const render::Camera& camera = content.camera;
    return render::pickScene(*content.scene, *shownFabric,
                             camera.rayAt(static_cast<float>(where.x()), static_cast<float>(where.y())),
                             kPickPixels * camera.millimetresPerPixel());
}

void FabricView::Implementation::hover(int loop) {
    if (loop != content.hovered) {
        content.hovered = loop;
        canvas->refresh();
        emit view.loopHovered(loop);
    }
}

Vec3f FabricView::Implementation::placeOf(fabric::EntryIndex entry) const {
    const std::size_t i = 3 * static_cast<std::size_t>(entry);
    if (frame && frame->positions.size() == 3 * static_cast<std::size_t>(shownFabric->entryCount)) {
        return {frame->positions[i], frame->positions[i + 1], frame->positions[i + 2]};
    }
    return shownFabric->machinePositions[static_cast<std::size_t>(entry)].cast<float>();
}

void FabricView::Implementation::placeMark() {
    const bool known = shownFabric && shownFabric == fabric && selectedPoint >= 0 &&
                       static_cast<std::size_t>(selectedPoint) < fabric->points.size();
    content.mark = known
                       ? std::optional(placeOf(fabric->points[static_cast<std::size_t>(selectedPoint)].entry))
                       : std::nullopt;
    overlay->update();
}

/// The pulled point moves in the plane through where it was caught, parallel to the picture.
void FabricView::Implementation::pullTo(QPointF where) {
    const render::Camera& camera = content.camera;
    const auto ray = camera.rayAt(static_cast<float>(where.x()), static_cast<float>(where.y()));
    if (const auto place = geometry::meetPlane(ray, pulled.place, camera.towardsViewer())) {
        emit view.dragMoved(pulled.entry, toQt(*place));
    }
}

QString FabricView::Implementation::describe(int loop) const {
    const auto i = static_cast<std::size_t>(loop);
    const QString needle = QString::fromStdString(machine::toString(shownFabric->made.loops[i].needle));
    return tr("Stitch on needle %1, course %2").arg(needle).arg(shownFabric->loops[i].course + 1);
}

void FabricView::setFabric(std::shared_ptr<const fabric::Fabric> fabric,
                           std::vector<render::YarnLook> looks) {
    m->fitPending = m->fitPending || !m->fabric;
    m->fabric = std::move(fabric);
    m->content.looks = std::move(looks);
    m->frame.reset();
    m->curves.reset();
    m->selectedPoint = -1; // its number means another point now
    m->gesture = Implementation::Gesture::None;
    if (m->fabric) {
        m->request();
        return;
    }
    m->content.scene.reset();
    m->shownFabric.reset();
    m->content.selected = -1;
    m->hover(-1);
    m->fitPending = true;
    m->changed();
}

void FabricView::setFrame(std::shared_ptr<const simulation::Frame> frame) {
    const bool fits =
        m->fabric && frame && frame->positions.size() == 3 * static_cast<std::size_t>(m->fabric->entryCount);
    if (fits) {
        m->frame = std::move(frame);
        m->curves.reset();
        m->request();
    }
}

void FabricView::setCurves(std::shared_ptr<const geometry::YarnCurves> curves) {
    if (m->fabric && curves != m->curves) {
        m->curves = std::move(curves);
        m->request();
    }
}

void FabricView::setLooks(std::vector<render::YarnLook> looks) {
    const bool sameCurves = std::ranges::equal(looks, m->content.looks, {}, &render::YarnLook::diameterMm,
                                               &render::YarnLook::diameterMm);
    m->content.looks = std::move(looks);
    if (!sameCurves) {
        m->request();
    }
    m->canvas->refresh();
}

void FabricView::setStyle(render::DrawStyle style) {
    if (style != m->style) {
        m->style = style;
        m->request();
    }
}

render::DrawStyle FabricView::style() const {
    return m->style;
}

void FabricView::setSelection(int loop) {
    if (loop != m->content.selected) {
        m->content.selected = loop;
        m->canvas->refresh();
    }
}

int FabricView::selection() const {
    return m->content.selected;
}

void FabricView::setSelectedPoint(int point) {
    if (point != m->selectedPoint) {
        m->selectedPoint = point;
        m->placeMark();
    }
}

void FabricView::centreOn(int loop) {
    if (!m->shownFabric || loop < 0 || static_cast<std::size_t>(loop) >= m->shownFabric->loops.size()) {
        return;
    }
    const fabric::PointIndex head = m->shownFabric->loops[static_cast<std::size_t>(loop)].headLeft;
    if (head < 0) {
        return;
    }
    const Vec3f place = m->placeOf(m->shownFabric->points[static_cast<std::size_t>(head)].entry);
    m->moveCamera([&](render::Camera& camera) {
        render::CameraState state = camera.state();
        state.target = place;
        camera.setState(state);
    });
}

void FabricView::fit() {
    m->fitPending = !m->content.scene;
    if (m->content.scene) {
        m->moveCamera([&](render::Camera& camera) { camera.fit(m->content.scene->bounds); });
    }
    m->followFit = true;
}

void FabricView::setFollowing(bool on) {
    m->following = on;
}

void FabricView::lookFront() {
    m->look(render::ViewSide::Front);
}
void FabricView::lookBack() {
    m->look(render::ViewSide::Back);
}
void FabricView::lookTop() {
    m->look(render::ViewSide::Top);
}
void FabricView::lookBottom() {
    m->look(render::ViewSide::Bottom);
}
void FabricView::lookLeft() {
    m->look(render::ViewSide::Left);
}
void FabricView::lookRight() {
    m->look(render::ViewSide::Right);
}

void FabricView::zoomBy(double factor) {
    m->moveCamera([&](render::Camera& camera) {
        camera.zoomAt(0.5F * static_cast<float>(width()), 0.5F * static_cast<float>(height()),
                      static_cast<float>(factor));
    });
}

void FabricView::setOrthographic(bool on) {
    m->content.camera.setOrthographic(on);
    m->overlay->update();
    m->canvas->refresh();
}

bool FabricView::isOrthographic() const {
    return m->content.camera.state().orthographic;
}

void FabricView::setDark(bool on) {
    m->content.dark = on;
    m->overlay->update();
    m->canvas->refresh();
}

void FabricView::setLegend(bool on) {
    m->content.legend = on;
    m->overlay->update();
}

bool FabricView::hasLegend() const {
    return m->content.legend;
}

void FabricView::setDragMode(bool on) {
    m->dragMode = on;
    setCursor(on ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

QByteArray FabricView::saveCamera() const {
    return toBytes(m->content.camera.state());
}

bool FabricView::restoreCamera(const QByteArray& bytes) {
    const auto state = cameraFromBytes(bytes);
    if (state) {
        m->fitPending = false;
        m->moveCamera([&](render::Camera& camera) { camera.setState(*state); });
    }
    return state.has_value();
}

bool FabricView::hasOpenGl() const {
    return m->hasGl;
}
QString FabricView::rendererName() const {
    return m->canvas->rendererName();
}
double FabricView::lastPaintMs() const {
    return m->content.paintMs;
}
QImage FabricView::picture() {
    return m->canvas->picture();
}

QSize FabricView::sizeHint() const {
    return {900, 640};
}
QSize FabricView::minimumSizeHint() const {
    return {160, 120};
}

void FabricView::resizeEvent(QResizeEvent*) {
    m->placeChildren();
    if (m->followFit && m->content.scene) {
        m->content.camera.fit(m->content.scene->bounds);
    }
}

void FabricView::mousePressEvent(QMouseEvent* event) {
    using Gesture = Implementation::Gesture;
    m->pressed = m->last = event->position();
    const bool pan = event->button() == Qt::MiddleButton || event->modifiers().testFlag(Qt::ShiftModifier);
    const bool pull = m->dragMode || event->modifiers().testFlag(Qt::ControlModifier);
    if (pan) {
        m->gesture = Gesture::Pan;
    } else if (event->button() != Qt::LeftButton) {
        QWidget::mousePressEvent(event);
    } else if (const auto pick = pull ? m->pickAt(event->position()) : std::nullopt) {
        m->gesture = Gesture::Pull;
        m->pulled = *pick;
        setCursor(Qt::ClosedHandCursor);
    } else {
        m->gesture = Gesture::Press;
    }
}

void FabricView::mouseMoveEvent(QMouseEvent* event) {
    using Gesture = Implementation::Gesture;
    const QPointF moved = event->position() - m->last;
    const auto right = static_cast<float>(moved.x());
    const auto down = static_cast<float>(moved.y());
    if (m->gesture == Gesture::Press && (event->position() - m->pressed).manhattanLength() > kClickPixels) {
        m->gesture = Gesture::Orbit;
    }
    switch (m->gesture) {
    case Gesture::None: {
        const auto pick = m->pickAt(event->position());
        m->hover(pick ? pick->loop : -1);
        break;
    }
    case Gesture::Press:
        return; // keeps `last`, so that nothing is lost when it becomes a drag
    case Gesture::Orbit:
        m->moveCamera([&](render::Camera& camera) { camera.orbit(right, down); });
        break;
    case Gesture::Pan:
        m->moveCamera([&](render::Camera& camera) { camera.pan(right, down); });
        break;
    case Gesture::Pull:
        m->pullTo(event->position());
        break;
    }
    m->last = event->position();
}

void FabricView::mouseReleaseEvent(QMouseEvent* event) {
    using Gesture = Implementation::Gesture;
    const Gesture gesture = std::exchange(m->gesture, Gesture::None);
    if (gesture == Gesture::Pull) {
        setDragMode(m->dragMode);
        emit dragEnded();
    } else if (gesture == Gesture::Press) {
        const auto pick = m->pickAt(event->position());
        emit loopClicked(pick ? pick->loop : -1);
        emit pointClicked(pick ? pick->point : -1);
    } else if (gesture == Gesture::None) {
        QWidget::mouseReleaseEvent(event);
    }
}

void FabricView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    const QPointF where = event->position();
    m->moveCamera([&](render::Camera& camera) {
        camera.zoomAt(static_cast<float>(where.x()), static_cast<float>(where.y()),
                      static_cast<float>(std::pow(kWheelStep, notches)));
    });
    event->accept();
}

void FabricView::leaveEvent(QEvent*) {
    m->hover(-1);
}

bool FabricView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto pick = m->pickAt(help->pos());
        QToolTip::showText(help->globalPos(), pick && pick->loop >= 0 ? m->describe(pick->loop) : QString(),
                           this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace knittsim::ui
