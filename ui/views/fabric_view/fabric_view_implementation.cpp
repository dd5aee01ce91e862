#include "ui/views/fabric_view/fabric_view_implementation.h"

#include "core/machine/needle.h"
#include "ui/render/scene_picking.h"

#include <QTimer>

#include <utility>

namespace knittsim::ui {

namespace {

constexpr float kPickPixels = 3;    ///< how far beside the yarn a click still counts
constexpr float kAbove = 32;        ///< pixels that a fitted fabric leaves free at least for the badge ...
constexpr float kBelow = 52;        ///< ... and for dimensions
constexpr float kMostAbove = 0.35F; ///< share of the view that words and legends may take from it
constexpr int kHeadMargin = 12;     ///< a fitted fabric has so much room anyway

QVector3D toQt(const Vec3f& v) {
    return {v.x(), v.y(), v.z()};
}

} // namespace

FabricView::Implementation::Implementation(FabricView& owner)
    : view(owner), worker([&owner] {
          QMetaObject::invokeMethod(
              &owner, [&owner] { owner.m->takePicture(); }, Qt::QueuedConnection);
      }) {}

void FabricView::Implementation::makeCanvas() {
    // For comparing and for machines whose driver misbehaves: window, thread or none.
    const QByteArray wanted = qgetenv("KNITTSIM_OPENGL");
    if (wanted.isEmpty() || wanted == "window") {
        canvas = makeGlCanvas(
            &view, content, [this](const QString& reason) { useAnotherCanvas(reason); }, glReason,
            wanted == "window");
    }
    if (!canvas && wanted != "none") {
        canvas = threadedCanvas(glReason);
    }
    if (wanted == "none") {
        glReason = tr("OpenGL is switched off.");
    }
    if (!canvas) {
        const QString reason = glReason;
        useFlatCanvas(reason);
    }
}

std::unique_ptr<Canvas> FabricView::Implementation::threadedCanvas(QString& reason) {
    return makeThreadedCanvas(
        &view, content, [this](const QString& why) { useFlatCanvas(why); }, reason);
}

/// After the window system's OpenGL has failed: a context of its own may still work.
void FabricView::Implementation::useAnotherCanvas(const QString& reason) {
    QString none;
    auto next = threadedCanvas(none);
    if (!next) {
        useFlatCanvas(reason);
        return;
    }
    canvas = std::move(next);
    placeChildren();
    canvas->refresh();
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
    canvas->widget()->lower(); // a new one as well; cards stay above the overlay
    overlay->setGeometry(view.rect());
}

void FabricView::Implementation::request() {
    if (fabric) {
        worker.post({fabric, content.looks, style, frame, yarn, content.colourBy});
    }
}

void FabricView::Implementation::takePicture() {
    auto picture = worker.take();
    // A picture of a fabric that was replaced meanwhile is of no use: its successor is under way.
    if (!picture || picture->fabric != fabric) {
        return;
    }
    wholeScene = std::move(picture->scene);
    shownFabric = std::move(picture->fabric);
    showParts();
    content.camera.setScene(content.scene->bounds);
    placeMarks();
    if (!content.scene->bounds.empty()) {
        if (fitPending) {
            fitCamera();
        } else if (following && followFit && gesture != Gesture::Pull) {
            followScene(); // while it is pulled the picture stands still: the mouse says where to
        }
        fitPending = false;
        headChanged();
    }
    changed();
    emit view.sceneChanged();
}

void FabricView::Implementation::changed() {
    const bool allHasRun = shownFabric && shownFabric->points.empty() && !shownFabric->loops.empty();
    overlay->setMessage(allHasRun                  ? tr("All of the fabric has run")
                        : !hasGl                   ? glReason
                        : content.scene == nullptr ? tr("No fabric yet")
                                                   : QString());
    canvas->refresh();
}

geometry::Bounds FabricView::Implementation::fitBox() const {
    geometry::Bounds box = content.scene->bounds;
    const Vec3f centre = box.centre();
    box.low = box.low.cwiseMin(centre - 0.5F * fitRoom);
    box.high = box.high.cwiseMax(centre + 0.5F * fitRoom);
    return forClass && !annotations.needles.empty() ? needleBox() : box;
}

/// The needles with loops, and as many courses below them as the shape of the view has room for.
geometry::Bounds FabricView::Implementation::needleBox() const {
    constexpr float kLeastWidth = 12; // mm
    constexpr float kTall = 1.5F;     // courses matter more than a full width
    geometry::Bounds box;
    for (const fabric::NeedleHook& hook : annotations.needles) {
        box.add(hook.place);
        box.add(hook.place + hook.shaft);
    }
    const float wider = 0.5F * std::max(0.0F, kLeastWidth - box.size().x());
    box.low.x() -= wider;
    box.high.x() += wider;
    const float shape = static_cast<float>(view.height()) / static_cast<float>(std::max(1, view.width()));
    const float room = box.high.y() - kTall * box.size().x() * shape;
    box.low.y() = std::min(box.low.y(), std::max(room, content.scene->bounds.low.y()));
    return box;
}

/// Pixels above a fitted fabric: for badge, words and legends, or the names of needles.
float FabricView::Implementation::above() const {
    const int head = annotations.measures ? overlay->headHeight() - kHeadMargin : 0;
    return std::min(std::max(kAbove, static_cast<float>(head)),
                    kMostAbove * static_cast<float>(view.height()));
}

/// Words and legends have come or gone: a fabric that is fitted keeps clear of them.
void FabricView::Implementation::headChanged() {
    if (content.scene && !content.scene->bounds.empty() && followFit && gesture == Gesture::None &&
        above() != fittedAbove) {
        fitCamera();
        canvas->refresh();
    }
    overlay->update();
}

void FabricView::Implementation::fit(render::Camera& camera) const {
    // The badge has its place above the fabric, dimensions and scale below it.
    constexpr int kLeastHeight = 300;
    const bool room = view.height() >= kLeastHeight;
    camera.fit(fitBox(), room ? above() : 0, room && annotations.dimensions ? kBelow : 0);
}

void FabricView::Implementation::fitCamera() {
    fittedAbove = above();
    fit(content.camera);
    emit view.cameraMoved();
}

/// In class the picture stays where it is while what is worked at stays in it.
void FabricView::Implementation::followScene() {
    render::Camera fitted = content.camera;
    fit(fitted);
    const render::CameraState& now = content.camera.state();
    const render::CameraState& then = fitted.state();
    const float nearer = now.halfHeight / then.halfHeight;
    const bool same =
        (now.target - then.target).norm() < 0.2F * then.halfHeight && nearer > 0.95F && nearer < 1.4F;
    if (!(forClass && same)) {
        fitCamera();
    }
}

void FabricView::Implementation::moveCamera(const std::function<void(render::Camera&)>& move) {
    followFit = false;
    move(content.camera);
    overlay->update();
    canvas->refresh();
    emit view.cameraMoved();
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
                             kPickPixels * camera.millimetresPerPixel(), content.section);
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
    if (fabric == shownFabric && i + 2 < places.size()) {
        return {places[i], places[i + 1], places[i + 2]};
    }
    return shownFabric->machinePositions[static_cast<std::size_t>(entry)].cast<float>();
}

void FabricView::Implementation::placeMarks() {
    const bool known = shownFabric && shownFabric == fabric;
    const auto placeOfPoint = [&](int point) -> std::optional<Vec3f> {
        const bool there = known && point >= 0 && static_cast<std::size_t>(point) < fabric->points.size();
        return there ? std::optional(placeOf(fabric->points[static_cast<std::size_t>(point)].entry))
                     : std::nullopt;
    };
    content.mark = placeOfPoint(selectedPoint);
    content.pins.clear();
    for (const int point : pins) {
        if (const auto place = placeOfPoint(point)) {
            content.pins.push_back(*place);
        }
    }
    const auto held = gesture == Gesture::Pull && pullTarget ? placeOfPoint(pulled.point) : std::nullopt;
    content.pull = held ? std::optional(std::pair(*held, *pullTarget)) : std::nullopt;
    overlay->update();
}

/// The pulled point moves in the plane through where it was caught, parallel to the picture.
void FabricView::Implementation::pullTo(QPointF where) {
    const render::Camera& camera = content.camera;
    const auto ray = camera.rayAt(static_cast<float>(where.x()), static_cast<float>(where.y()));
    if (const auto place = geometry::meetPlane(ray, pulled.place, camera.towardsViewer())) {
        pullTarget = *place;
        placeMarks();
        emit view.dragMoved(pulled.point, toQt(*place));
    }
}

void FabricView::Implementation::takeDetail() {
    const auto drawn =
        content.scene && content.scene->style != render::DrawStyle::Mesh ? content.levelDrawn : std::nullopt;
    if (drawn != shownDetail) {
        shownDetail = drawn;
        emit view.detailDrawnChanged();
    }
}

QString FabricView::Implementation::describe(int loop) const {
    if (describer) {
        return describer(loop);
    }
    const auto i = static_cast<std::size_t>(loop);
    const QString needle = QString::fromStdString(machine::toString(shownFabric->made.loops[i].needle));
    return tr("Stitch on needle %1, course %2").arg(needle).arg(shownFabric->loops[i].course + 1);
}

} // namespace knittsim::ui
