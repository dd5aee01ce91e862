#include "ui/dialogs/pull_plot.h"

#include "core/base/round_numbers.h"
#include "ui/views/style/appearance.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

namespace {
constexpr double kForceTicks = 4; ///< about
constexpr double kStrainTicks = 6;
} // namespace

PullPlot::PullPlot(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("pullPlot"));
    setAccessibleName(tr("Force against strain"));
    setToolTip(tr("Force by width of the fabric against strain: drawn longer (full line) and back (dashed)"));
}

void PullPlot::setCurves(std::vector<QPointF> up, std::vector<QPointF> back, double mostStrain) {
    m_up = std::move(up);
    m_back = std::move(back);
    m_mostStrain = mostStrain;
    update();
}

void PullPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Accents accents = accentsOf(palette());
    const int line = fontMetrics().height();
    double most = 0;
    double least = 0;
    for (const auto* curve : {&m_up, &m_back}) {
        for (const QPointF& p : *curve) {
            most = std::max(most, p.y());
            least = std::min(least, p.y());
        }
    }
    most = most > 0 ? most : 0.1;
    const double step = roundUp((most - least) / kForceTicks);
    const double low = step * std::floor(least / step);
    const double high = step * std::ceil(most / step);
    const int axis = fontMetrics().horizontalAdvance(QStringLiteral("-0.0000")) + 8;
    const QRectF area = QRectF(rect()).adjusted(axis, line + 8, -16, -2 * line - 8);
    const auto place = [&](const QPointF& p) {
        return QPointF(area.left() + p.x() / m_mostStrain * area.width(),
                       area.bottom() - (p.y() - low) / (high - low) * area.height());
    };
    painter.setPen(accents.faintText);
    painter.drawText(QRectF(4, 2, width() - 8, line), Qt::AlignLeft, tr("Force (N/mm)"));
    painter.drawText(QRectF(area.left(), height() - line - 2, area.width(), line), Qt::AlignRight,
                     tr("Strain (%)"));
    const QLocale locale;
    for (int i = 0; i <= static_cast<int>(std::lround((high - low) / step)); ++i) {
        const double value = low + i * step;
        const double y = place({0, value}).y();
        painter.setPen(accents.line);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(accents.faintText);
        painter.drawText(QRectF(0, y - line / 2.0, axis - 6, line), Qt::AlignRight | Qt::AlignVCenter,
                         locale.toString(value, 'g', 4));
    }
    const double across = roundUp(m_mostStrain / kStrainTicks);
    for (double strain = 0; strain <= 1.0001 * m_mostStrain; strain += across) {
        const double x = place({strain, 0}).x();
        painter.setPen(accents.line);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(accents.faintText);
        painter.drawText(QRectF(x - 40, area.bottom() + 3, 80, line), Qt::AlignHCenter,
                         locale.toString(strain, 'g', 4));
    }
    for (const auto* curve : {&m_up, &m_back}) {
        QPolygonF way;
        for (const QPointF& p : *curve) {
            way << place(p);
        }
        painter.setPen(QPen(accents.busy, 2, curve == &m_up ? Qt::SolidLine : Qt::DashLine, Qt::RoundCap,
                            Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(way);
        painter.setPen(Qt::NoPen);
        painter.setBrush(accents.busy);
        for (const QPointF& p : way) {
            painter.drawEllipse(p, 2.5, 2.5);
        }
    }
}

} // namespace knittsim::ui
