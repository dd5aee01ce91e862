#include "ui/views/fabric_view/photograph.h"

#include "ui/views/fabric_view/canvas.h"

#include <QDataStream>
#include <QIODevice>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <complex>

namespace knittsim::ui {

namespace {

constexpr quint32 kMagic = 0x4b535031; // "KSP1"
using Complex = std::complex<double>;

Complex toComplex(QPointF point) {
    return {point.x(), point.y()};
}

} // namespace

QByteArray toBytes(const Photograph& photograph) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_6_0);
    stream << kMagic << photograph.path << photograph.beside << photograph.opacity << photograph.wipe
           << photograph.toFabric;
    return bytes;
}

std::optional<Photograph> photographFromBytes(const QByteArray& bytes) {
    QDataStream stream(bytes);
    stream.setVersion(QDataStream::Qt_6_0);
    quint32 magic = 0;
    Photograph photograph;
    stream >> magic >> photograph.path >> photograph.beside >> photograph.opacity >> photograph.wipe >>
        photograph.toFabric;
    if (magic != kMagic || stream.status() != QDataStream::Ok || !photograph.toFabric.isInvertible()) {
        return std::nullopt;
    }
    photograph.opacity = std::clamp(photograph.opacity, 0.0, 1.0);
    photograph.wipe = std::clamp(photograph.wipe, 0.0, 1.0);
    return photograph;
}

std::optional<QTransform> alignTwoPoints(const std::array<QPointF, 2>& image,
                                         const std::array<QPointF, 2>& fabric, bool back) {
    // Pixels count downwards and the fabric upwards: its face is a mirrored plane, and its back, where x runs
    // to the left as well, is not.
    const auto read = [back](QPointF pixel) { return back ? toComplex(pixel) : std::conj(toComplex(pixel)); };
    const Complex from = read(image[1]) - read(image[0]);
    const Complex to = toComplex(fabric[1]) - toComplex(fabric[0]);
    if (std::abs(from) < 1e-9 || std::abs(to) < 1e-9) {
        return std::nullopt;
    }
    const Complex a = to / from;
    const Complex b = toComplex(fabric[0]) - a * read(image[0]);
    return back ? QTransform(a.real(), a.imag(), -a.imag(), a.real(), b.real(), b.imag())
                : QTransform(a.real(), a.imag(), a.imag(), -a.real(), b.real(), b.imag());
}

QTransform laidOn(QSize image, const geometry::Bounds& fabric, bool back) {
    const Vec3f centre = fabric.centre();
    const double halfWidth = std::max(1e-3F, fabric.size().x()) / 2 * (back ? -1.0 : 1.0);
    const double middle = image.height() / 2.0;
    return alignTwoPoints(
               {QPointF(0, middle), QPointF(std::max(1, image.width()), middle)},
               {QPointF(centre.x() - halfWidth, centre.y()), QPointF(centre.x() + halfWidth, centre.y())},
               back)
        .value_or(QTransform());
}

QTransform placeOf(const Photograph& photograph, const geometry::Bounds& fabric, bool back) {
    if (!photograph.beside) {
        return photograph.toFabric;
    }
    constexpr double kGap = 0.06; ///< of the fabric's width
    const QRectF box = photograph.toFabric.mapRect(QRectF(photograph.image.rect()));
    const double gap = kGap * fabric.size().x();
    // On the right as it is seen.
    const double shift = back ? fabric.low.x() - gap - box.right() : fabric.high.x() + gap - box.left();
    return photograph.toFabric * QTransform::fromTranslate(shift, 0);
}

void paintPhotograph(QPainter& painter, QSize size, const CanvasContent& content,
                     const Photograph& photograph) {
    constexpr double kLeastArea = 16; ///< square pixels
    const geometry::Bounds& box = content.scene->bounds;
    if (!photograph.visible() || box.empty()) {
        return;
    }
    const bool back = content.camera.towardsViewer().z() < 0;
    const QTransform place = placeOf(photograph, box, back);
    const QRectF pixels(photograph.image.rect());
    const auto project = [&](QPointF corner) {
        const QPointF there = place.map(corner);
        const Vec3f seen = content.camera.project(
            {static_cast<float>(there.x()), static_cast<float>(there.y()), box.centre().z()});
        return QPointF(seen.x(), seen.y());
    };
    const QPolygonF from{{pixels.topLeft(), pixels.topRight(), pixels.bottomRight(), pixels.bottomLeft()}};
    QPolygonF to;
    for (const QPointF& corner : from) {
        to << project(corner);
    }
    const QPointF a = to[1] - to[0];
    const QPointF b = to[3] - to[0];
    QTransform onScreen;
    if (std::abs(a.x() * b.y() - a.y() * b.x()) < kLeastArea || !QTransform::quadToQuad(from, to, onScreen)) {
        return;
    }
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const double line = photograph.beside ? 0 : photograph.wipe * size.width();
    painter.setClipRect(QRectF(line, 0, size.width() - line, size.height()));
    painter.setOpacity(photograph.beside ? 1 : photograph.opacity);
    painter.setTransform(onScreen, true);
    painter.drawImage(pixels, photograph.image);
    painter.restore();
    if (line > 0) {
        for (const QPen& pen : {QPen(QColor(255, 255, 255, 200), 3), QPen(QColor(20, 22, 25), 1)}) {
            painter.setPen(pen);
            painter.drawLine(QPointF(line, 0), QPointF(line, size.height()));
        }
    }
}

} // namespace knittsim::ui
