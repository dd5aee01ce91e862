#include "ui/views/fabric_view/fabric_view_implementation.h"

#include <utility>

namespace knittsim::ui {

namespace {

constexpr int kAlignClicks = 4; ///< photograph, fabric, photograph, fabric

QPointF flat(const Vec3f& place) {
    return {place.x(), place.y()};
}

} // namespace

void FabricView::setPhotograph(Photograph photograph) {
    m->annotations.photograph = std::move(photograph);
    m->overlay->update();
    emit photographChanged();
}

const Photograph& FabricView::photograph() const {
    return m->annotations.photograph;
}

bool FabricView::seesBack() const {
    return m->content.camera.towardsViewer().z() < 0;
}

bool FabricView::startAlignment() {
    if (!m->annotations.photograph.visible() || !m->content.scene || m->content.scene->bounds.empty()) {
        return false;
    }
    m->annotations.alignClicks = 0;
    setCursor(Qt::CrossCursor);
    m->overlay->update();
    return true;
}

bool FabricView::cancelAlignment() {
    const bool ran = m->annotations.alignClicks >= 0;
    m->annotations.alignClicks = -1;
    setCursor(m->annotations.taping ? Qt::CrossCursor : Qt::ArrowCursor);
    m->overlay->update();
    return ran;
}

bool FabricView::isAligning() const {
    return m->annotations.alignClicks >= 0;
}

/// In turn on the photograph and on the fabric.
void FabricView::Implementation::alignClick(QPointF where) {
    const geometry::Bounds& box = content.scene->bounds;
    const auto ray = content.camera.rayAt(static_cast<float>(where.x()), static_cast<float>(where.y()));
    const auto plane = geometry::meetPlane(ray, box.centre(), Vec3f::UnitZ());
    if (!plane) {
        return;
    }
    const auto turn = static_cast<std::size_t>(annotations.alignClicks / 2);
    if (annotations.alignClicks % 2 == 0) {
        const QTransform place = ui::placeOf(annotations.photograph, box, view.seesBack());
        photoPoints[turn] = place.inverted().map(flat(*plane));
    } else {
        const auto pick = pickAt(where);
        fabricPoints[turn] = flat(pick ? pick->place : *plane);
    }
    if (++annotations.alignClicks == kAlignClicks) {
        if (const auto aligned = alignTwoPoints(photoPoints, fabricPoints, view.seesBack())) {
            annotations.photograph.toFabric = *aligned;
        }
        view.cancelAlignment();
        emit view.photographChanged();
    }
    overlay->update();
}

} // namespace knittsim::ui
