#include "ui/views/fabric_view/fabric_view.h"

#include "ui/views/fabric_view/camera_bytes.h"
#include "ui/views/fabric_view/fabric_view_implementation.h"

#include <QCursor>

#include <algorithm>
#include <utility>

namespace knittsim::ui {

namespace {

constexpr double kClassLetters = 1.7;

} // namespace

FabricView::FabricView(QWidget* parent) : QWidget(parent), m(std::make_unique<Implementation>(*this)) {
    setObjectName(QStringLiteral("fabricView"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Fabric"));
    setAccessibleDescription(
        tr("The knitted fabric in three dimensions. Drag to turn it, drag with Shift to move "
           "it, turn the wheel to come nearer, click a stitch to select it."));
    m->content.painted = [this] { m->takeDetail(); };
    m->content.camera.setViewport(width(), height());
    m->makeCanvas();
    m->overlay = new Overlay(this, m->content, m->annotations);
    m->overlay->onPaint([this] {
        const bool fits = m->shownFabric == m->fabric; // else it is the picture before
        if (fits && (m->annotations.dimensions || m->annotations.guides)) {
            m->measure();
        }
    });
    m->overlay->setMessage(m->glReason.isEmpty() ? tr("No fabric yet") : m->glReason);
    m->placeChildren();
}

FabricView::~FabricView() = default;

void FabricView::setFabric(std::shared_ptr<const fabric::Fabric> fabric,
                           std::vector<render::YarnLook> looks) {
    m->fitPending = m->fitPending || !m->fabric;
    m->fabric = std::move(fabric);
    m->content.looks = std::move(looks);
    m->frame.reset();
    m->yarn.reset();
    m->selectedPoint = -1; // its number means another point now
    m->pins.clear();
    m->gesture = Implementation::Gesture::None;
    m->problems.clear();
    m->annotations.tape.clear();
    m->takePlaces({});
    if (m->fabric) {
        m->request();
        return;
    }
    m->alone = Alone::Nothing;
    m->content.section.reset();
    m->wholeScene.reset();
    m->showParts();
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
        m->yarn.reset();
        m->takePlaces(m->frame->positions);
        m->request();
    }
}

void FabricView::setYarn(std::shared_ptr<const simulation::YarnPicture> yarn) {
    if (m->fabric && yarn != m->yarn) {
        m->yarn = std::move(yarn);
        m->takePlaces(m->yarn    ? std::span<const float>(m->yarn->positions)
                      : m->frame ? std::span<const float>(m->frame->positions)
                                 : std::span<const float>());
        m->request();
    }
}

void FabricView::setColourBy(render::ColourBy what) {
    if (what != m->content.colourBy) {
        m->content.colourBy = what;
        m->headChanged();
        m->request();
        emit displayChanged();
    }
}

render::ColourBy FabricView::colourBy() const {
    return m->content.colourBy;
}

void FabricView::setPins(std::vector<int> points) {
    m->pins = std::move(points);
    m->placeMarks();
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
        emit displayChanged();
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
        m->placeMarks();
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
        m->fitCamera();
        m->overlay->update();
        m->canvas->refresh();
    }
    m->followFit = true;
}

void FabricView::setFollowing(bool on) {
    m->following = on;
}

void FabricView::setForClass(bool on) {
    if (on == m->forClass) {
        return;
    }
    m->forClass = on;
    m->annotations.measures = !on;
    QFont letters = font();
    letters.setPointSizeF((on ? kClassLetters : 1) * letters.pointSizeF());
    m->overlay->setFont(letters);
    if (m->followFit) {
        fit();
    }
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
    emit cameraMoved();
}

bool FabricView::isOrthographic() const {
    return m->content.camera.state().orthographic;
}

void FabricView::setDark(bool on) {
    m->content.dark = on;
    m->overlay->update();
    m->canvas->refresh();
    emit displayChanged();
}

void FabricView::setHair(bool on) {
    m->content.hair = on;
    m->canvas->refresh();
    emit displayChanged();
}

bool FabricView::hasHair() const {
    return m->content.hair;
}

void FabricView::setDetail(std::optional<render::DetailLevel> level) {
    m->content.level = level;
    m->canvas->refresh();
    emit displayChanged();
}

std::optional<render::DetailLevel> FabricView::detail() const {
    return m->content.level;
}

std::optional<render::DetailLevel> FabricView::detailDrawn() const {
    return m->shownDetail;
}

void FabricView::setLegend(bool on) {
    m->content.legend = on;
    m->headChanged();
}

bool FabricView::hasLegend() const {
    return m->content.legend;
}

void FabricView::setDragMode(bool on) {
    m->dragMode = on;
    setCursor(on ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

render::CameraState FabricView::cameraState() const {
    return m->content.camera.state();
}

void FabricView::setCameraState(const render::CameraState& state) {
    m->fitPending = false;
    m->moveCamera([&](render::Camera& camera) { camera.setState(state); });
}

geometry::Bounds FabricView::bounds() const {
    return m->content.scene ? m->content.scene->bounds : geometry::Bounds();
}

void FabricView::setFitRoom(const Vec3f& size) {
    m->fitRoom = size;
    if (m->followFit && m->content.scene) {
        m->fitCamera();
        m->overlay->update();
        m->canvas->refresh();
    }
}

void FabricView::takeDisplay(const FabricView& other) {
    setStyle(other.style());
    setColourBy(other.colourBy());
    setDark(other.m->content.dark);
    setHair(other.hasHair());
    setDetail(other.detail());
    setDimensions(other.hasDimensions());
    setGuides(other.hasGuides());
    setProblemMarks(other.hasProblemMarks());
    setLegend(other.hasLegend());
}

QByteArray FabricView::saveCamera() const {
    return toBytes(m->content.camera.state());
}

bool FabricView::restoreCamera(const QByteArray& bytes) {
    const auto state = cameraFromBytes(bytes);
    if (state) {
        setCameraState(*state);
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
bool FabricView::isUpToDate() const {
    return m->shownFabric == m->fabric;
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

} // namespace knittsim::ui
