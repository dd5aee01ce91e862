#include "ui/window/sample_thumbnail.h"

#include "core/pattern/project.h"

#include <QBuffer>
#include <QPainterPath>
#include <QPixmap>

#include <algorithm>

namespace knittsim::ui {

namespace {

constexpr QSize kThumbnail(160, 96);
constexpr double kCellWidth = 11;
constexpr double kCellHeight = 9;

class Thumbnail {
public:
    Thumbnail(QPainter& painter, const QRectF& rect, const pattern::Chart& chart)
        : m_painter(painter), m_chart(chart), m_rect(rect),
          m_wales(std::min(chart.width, static_cast<int>(rect.width() / kCellWidth) + 1)),
          m_courses(std::min(chart.height(), static_cast<int>(rect.height() / kCellHeight) + 1)) {}

    void paint() {
        for (int course = 0; course < m_courses; ++course) {
            for (int wale = 0; wale < m_wales; ++wale) {
                paintCell(wale, course);
            }
        }
        for (int course = 0; course < m_courses; ++course) {
            const auto& moves = m_chart.course(course).moves;
            for (auto move = moves.rbegin(); move != moves.rend(); ++move) {
                if (std::max(move->from, move->to) < m_wales && course > 0) {
                    paintMove(*move, course);
                }
            }
        }
    }

private:
    QRectF cellRect(int wale, int course) const {
        return {m_rect.left() + wale * kCellWidth, m_rect.bottom() - (course + 1) * kCellHeight, kCellWidth,
                kCellHeight};
    }

    QColor colourAt(int wale, int course) const {
        const std::size_t yarn = m_chart.at(wale, course).yarn;
        if (yarn >= m_chart.yarns.size()) {
            return Qt::lightGray;
        }
        const yarn::Colour c = m_chart.yarns[yarn].colour;
        return {c.r, c.g, c.b};
    }

    void stroke(const QPainterPath& path, const QColor& colour, double width) {
        m_painter.setPen(QPen(colour.darker(colour.lightnessF() < 0.3F ? 190 : 165), width + 1.2,
                              Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        m_painter.drawPath(path);
        m_painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        m_painter.drawPath(path);
    }

    void paintCell(int wale, int course) {
        const QRectF cell = cellRect(wale, course);
        const QColor colour = colourAt(wale, course);
        const auto at = [&](double x, double y) {
            return QPointF(cell.left() + x * cell.width(), cell.top() + y * cell.height());
        };
        QPainterPath path;
        switch (m_chart.at(wale, course).stitch) {
        case pattern::Stitch::Knit:
        case pattern::Stitch::Both:
        case pattern::Stitch::KnitTuck:
            path.moveTo(at(0.17, -0.12));
            path.lineTo(at(0.42, 0.72));
            path.moveTo(at(0.83, -0.12));
            path.lineTo(at(0.58, 0.72));
            stroke(path, colour, 2.7);
            break;
        case pattern::Stitch::Purl:
        case pattern::Stitch::TuckKnit:
            path.moveTo(at(0.02, 0.72));
            path.cubicTo(at(0.28, 0.02), at(0.72, 0.02), at(0.98, 0.72));
            stroke(path, colour.darker(118), 2.9);
            break;
        case pattern::Stitch::Tuck:
        case pattern::Stitch::TuckBoth:
        case pattern::Stitch::RearTuck:
            path.moveTo(at(0.2, 1.0));
            path.cubicTo(at(0.2, -0.2), at(0.8, -0.2), at(0.8, 1.0));
            stroke(path, colour, 2.2);
            break;
        case pattern::Stitch::Miss:
        case pattern::Stitch::RearMiss:
            path.moveTo(at(0.0, 0.5));
            path.lineTo(at(1.0, 0.5));
            stroke(path, colour, 1.7);
            break;
        default:
            break;
        }
    }

    void paintMove(const pattern::LoopMove& move, int course) {
        const QPointF from = cellRect(move.from, course - 1).center();
        const QPointF to = cellRect(move.to, course).center();
        QPainterPath path(from + QPointF(0, 1));
        path.cubicTo(from - QPointF(0, 4), to + QPointF(0, 4), to - QPointF(0, 1));
        stroke(path, colourAt(move.to, course), 4.2);
    }

    QPainter& m_painter;
    const pattern::Chart& m_chart;
    QRectF m_rect;
    int m_wales;
    int m_courses;
};

} // namespace

void paintChartThumbnail(QPainter& painter, const QRectF& rect, const pattern::Chart& chart) {
    const yarn::Colour main = chart.yarns.empty() ? yarn::Colour{} : chart.yarns.front().colour;
    const QColor yarn(main.r, main.g, main.b);
    const QColor light(130 + yarn.red() / 4, 136 + yarn.green() / 4, 144 + yarn.blue() / 4);
    const QColor ground = yarn.lightnessF() < 0.42F ? light : yarn.darker(290);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath card;
    card.addRoundedRect(rect, 4, 4);
    painter.setClipPath(card);
    painter.fillRect(rect, ground);
    painter.setBrush(Qt::NoBrush);
    const double width = std::min(rect.width(), chart.width * kCellWidth);
    const double height = std::min(rect.height(), chart.height() * kCellHeight);
    const QRectF middle(rect.left() + (rect.width() - width) / 2,
                        rect.bottom() - (rect.height() - height) / 2 - height, width, height);
    Thumbnail(painter, middle, chart).paint();
    painter.restore();
}

QByteArray chartThumbnail(const pattern::Chart& chart) {
    QImage image(kThumbnail, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    paintChartThumbnail(painter, QRectF(QPointF(0, 0), QSizeF(kThumbnail)), chart);
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes.toBase64();
}

QPixmap thumbnailOf(const QString& path) {
    const std::filesystem::path file(path.toStdString());
    QPixmap picture;
    if (pattern::isProjectFile(file)) {
        picture.loadFromData(
            QByteArray::fromBase64(QByteArray::fromStdString(pattern::readLook(file).thumbnail)), "PNG");
    }
    return picture;
}

} // namespace knittsim::ui
