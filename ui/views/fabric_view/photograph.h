#pragma once

#include "core/geometry/bounds.h"

#include <QByteArray>
#include <QImage>
#include <QPointF>
#include <QString>
#include <QTransform>

#include <array>
#include <optional>

class QPainter;

namespace knittsim::ui {

struct CanvasContent;

/// A photograph of real fabric that lies over the simulated one or beside it, in the plane through its
/// middle.
struct Photograph {
    QImage image; ///< null: there is none
    QString path;
    bool shown = true;
    bool beside = false;  ///< else over it
    double opacity = 0.6; ///< 0 .. 1
    double wipe = 0;      ///< share of the view, from the left, where only the fabric is seen
    QTransform toFabric;  ///< pixels of the image, y downwards, to x and y of the fabric, mm

    bool visible() const { return shown && !image.isNull(); }
};

/// All but the pixels and `shown`, for remembering.
QByteArray toBytes(const Photograph& photograph);
/// Nothing for bytes that toBytes() did not make. Without pixels.
std::optional<Photograph> photographFromBytes(const QByteArray& bytes);

/// Turns, scales and moves an image (pixels) so that its two points come to lie on those of the fabric (mm).
/// `back`: it shows the technical back. Nothing where two points are the same.
std::optional<QTransform> alignTwoPoints(const std::array<QPointF, 2>& image,
                                         const std::array<QPointF, 2>& fabric, bool back);

/// As wide as the fabric and in its middle.
QTransform laidOn(QSize image, const geometry::Bounds& fabric, bool back);

/// `toFabric`, moved beside the fabric where that is wanted.
QTransform placeOf(const Photograph& photograph, const geometry::Bounds& fabric, bool back);

/// Into a view of `size`; nothing where it is seen from its edge.
void paintPhotograph(QPainter& painter, QSize size, const CanvasContent& content,
                     const Photograph& photograph);

} // namespace knittsim::ui
