#include "ui/views/fabric_view/flat_painter.h"

#include "ui/views/fabric_view/marker_painter.h"

#include <QLinearGradient>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

namespace {

/// A few nodes of yarn that are painted in one go.
struct Piece {
    std::size_t first = 0;
    std::size_t count = 0;
    float depth = 0;
    machine::CarrierIndex carrier = 0;
};

constexpr std::size_t kPieceNodes = 4;
constexpr std::size_t kMostPieces = 60000; ///< larger fabrics are painted in longer pieces

std::vector<Piece> sortedPieces(const render::SceneFrame& scene, const render::Camera& camera,
                                const std::optional<render::Section>& section) {
    const std::size_t step = std::max(kPieceNodes, scene.nodes.size() / kMostPieces + 1);
    const Vec3f towards = camera.towardsViewer();
    std::vector<Piece> pieces;
    pieces.reserve(scene.nodes.size() / step + scene.topology->yarns.size());
    for (const auto& yarn : scene.topology->yarns) {
        const auto end = static_cast<std::size_t>(yarn.first + yarn.count);
        for (auto first = static_cast<std::size_t>(yarn.first); first + 1 < end; first += step) {
            const std::size_t count = std::min(step + 1, end - first);
            const auto& middle = scene.nodes[first + count / 2];
            if (section && section->cuts({middle[0], middle[1], middle[2]})) {
                continue;
            }
            pieces.push_back(
                {first, count, Vec3f(middle[0], middle[1], middle[2]).dot(towards), yarn.carrier});
        }
    }
    std::ranges::sort(pieces, {}, &Piece::depth);
    return pieces;
}

QColor colourOf(const CanvasContent& content, const Piece& piece) {
    const render::SceneFrame& scene = *content.scene;
    const machine::LoopIndex loop = scene.topology->loopOfPoint[scene.topology->owner[piece.first]];
    if (loop >= 0 && loop == content.selected) {
        return content.dark ? QColor(255, 178, 41) : QColor(237, 107, 5);
    }
    if (!scene.range.empty()) {
        const auto value = static_cast<float>(scene.surface[piece.first + piece.count / 2][1] >> 22);
        const yarn::Colour told = render::rampColour(value / 1023);
        return {told.r, told.g, told.b};
    }
    const yarn::Colour colour =
        piece.carrier < content.looks.size() ? content.looks[piece.carrier].colour : yarn::Colour();
    return {colour.r, colour.g, colour.b};
}

void paintMarkers(QPainter& painter, QSize size, const CanvasContent& content) {
    const render::Camera& camera = content.camera;
    const QColor ground = content.dark ? QColor(37, 40, 44) : QColor(229, 231, 233);
    const double pixels = markerPixels(camera.millimetresPerPixel());
    const QRectF seen = QRectF(QPointF(), size).adjusted(-pixels, -pixels, pixels, pixels);
    const auto onScreen = [&](const Vec3f& place) {
        const Vec3f p = camera.project(place);
        return QPointF(p.x(), p.y());
    };
    for (const render::Marker& marker : content.scene->markers) {
        const Vec3f place = Vec3f::Map(marker.place.data());
        const QPointF centre = onScreen(place);
        const bool cut = content.section && content.section->cuts(place);
        if (seen.contains(centre) && !cut) {
            const auto& way = camera.towardsViewer().z() < 0 ? marker.behind : marker.front;
            paintMarker(painter, static_cast<render::Marker::Kind>(marker.kind), centre, pixels,
                        onScreen(place + Vec3f::Map(way.data())) - centre, ground, content.dark);
        }
    }
}

void paintBackground(QPainter& painter, QSize size, bool dark) {
    QLinearGradient gradient(0, 0, 0, size.height());
    gradient.setColorAt(0, dark ? QColor(47, 50, 55) : QColor(244, 245, 246));
    gradient.setColorAt(1, dark ? QColor(27, 29, 32) : QColor(214, 217, 219));
    painter.fillRect(QRect(QPoint(0, 0), size), gradient);
}

} // namespace

void paintFlat(QPainter& painter, QSize size, const CanvasContent& content) {
    paintBackground(painter, size, content.dark);
    if (!content.scene) {
        return;
    }
    const render::SceneFrame& scene = *content.scene;
    painter.setRenderHint(QPainter::Antialiasing);
    const float perMm = 1 / content.camera.millimetresPerPixel();
    QPolygonF line;
    for (const Piece& piece : sortedPieces(scene, content.camera, content.section)) {
        line.clear();
        for (std::size_t n = piece.first; n < piece.first + piece.count; ++n) {
            const auto& node = scene.nodes[n];
            const Vec3f place = content.camera.project({node[0], node[1], node[2]});
            line << QPointF(place.x(), place.y());
        }
        const QColor colour = colourOf(content, piece);
        const bool mesh = scene.style == render::DrawStyle::Mesh;
        const qreal width = mesh ? 1.6 : std::max(1.0F, perMm * scene.diameters[piece.carrier]);
        // Flat ends, else the end of a dark stroke covers the piece before it.
        painter.setPen(QPen(colour.darker(300), width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
        painter.drawPolyline(line);
        if (!mesh && width > 2) {
            painter.setPen(QPen(colour, 0.66 * width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter.drawPolyline(line);
        }
    }
    paintMarkers(painter, size, content);
}

} // namespace knittsim::ui
