#include "ui/views/simulation_panel/energy_plot.h"

#include "ui/views/simulation_panel/energy_scale.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/numbers.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <limits>

namespace knittsim::ui {

namespace {

constexpr int kAxisWidth = 50;
constexpr double kResidualLimit = 1e-3;
/// The energy axis reaches from the largest value to a little below the smallest V, within these bounds.
constexpr double kLeastDecades = 3;
constexpr double kMostDecades = 12;

QString powerText(double value) {
    const int power = static_cast<int>(std::lround(std::log10(std::abs(value))));
    return value < 0 ? QChar(0x2212) + energyText(std::pow(10.0, power)) : energyText(std::pow(10.0, power));
}

} // namespace

struct EnergyPlot::Curve {
    QString name;
    QString value;
    QColor colour;
    Qt::PenStyle style;
    std::function<double(const EnergySample&)> of;
};

EnergyPlot::EnergyPlot(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("energyPlot"));
    setAccessibleName(tr("Energies and residual"));
    setToolTip(tr("Kinetic energy Ekin, spring energy V, Lagrangian L = Ekin \u2212 V, and the residual: the "
                  "norm of the "
                  "forces relative to the start"));
    QFont small = font();
    small.setPointSizeF(std::max(7.0, small.pointSizeF() * 0.85));
    setFont(small);
}

void EnergyPlot::clear() {
    m_history.clear();
    update();
}

void EnergyPlot::add(const EnergySample& sample) {
    m_history.add(sample);
    update();
}

double EnergyPlot::stepShare(std::int64_t step) const {
    const double first = static_cast<double>(m_history.samples().front().step);
    const double last = static_cast<double>(m_history.samples().back().step);
    return last > first ? (static_cast<double>(step) - first) / (last - first) : 0;
}

void EnergyPlot::paintAxis(QPainter& painter, const QRect& rect, double share, const QString& text) const {
    const int y = rect.bottom() - static_cast<int>(std::lround(share * rect.height()));
    const Accents accents = accentsOf(palette());
    painter.setPen(accents.line);
    painter.drawLine(rect.left(), y, rect.right(), y);
    if (!text.isEmpty()) {
        painter.setPen(accents.faintText);
        painter.drawText(QRect(rect.left() - kAxisWidth, y - 8, kAxisWidth - 5, 16),
                         Qt::AlignRight | Qt::AlignVCenter, text);
    }
}

void EnergyPlot::paintCurve(QPainter& painter, const QRect& rect, const Curve& curve,
                            const std::function<double(double)>& map) const {
    QPolygonF line;
    for (const EnergySample& sample : m_history.samples()) {
        const double value = curve.of(sample);
        if (std::isfinite(value)) {
            line << QPointF(rect.left() + stepShare(sample.step) * rect.width(),
                            rect.bottom() - map(value) * rect.height());
        }
    }
    painter.setPen(QPen(curve.colour, 1.6, curve.style, Qt::RoundCap, Qt::RoundJoin));
    if (line.size() == 1) {
        painter.drawEllipse(line.front(), 1.5, 1.5);
    } else {
        painter.drawPolyline(line);
    }
}

void EnergyPlot::paintLegend(QPainter& painter, const QRect& rect, const std::vector<Curve>& curves) const {
    int x = rect.left();
    for (const Curve& curve : curves) {
        painter.setPen(QPen(curve.colour, 2, curve.style));
        painter.drawLine(x, rect.center().y(), x + 12, rect.center().y());
        const QString text = curve.name + u' ' + curve.value;
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QRect(x + 16, rect.top(), rect.right() - x, rect.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, text);
        x += 16 + painter.fontMetrics().horizontalAdvance(text) + 9;
    }
}

void EnergyPlot::paintEnergies(QPainter& painter, const QRect& rect) const {
    const simulation::Energies& now = m_history.samples().back().energies;
    const Accents accents = accentsOf(palette());
    const std::vector<Curve> curves{{tr("Ekin"), energyText(now.kinetic), accents.warning, Qt::SolidLine,
                                     [](const EnergySample& s) { return s.energies.kinetic; }},
                                    {tr("V"), energyText(now.potential), accents.busy, Qt::SolidLine,
                                     [](const EnergySample& s) { return s.energies.potential; }},
                                    {tr("L"), energyText(now.lagrangian()), accents.error, Qt::DashLine,
                                     [](const EnergySample& s) { return s.energies.lagrangian(); }}};
    double low = 0;
    double high = 0;
    double least = std::numeric_limits<double>::max();
    for (const EnergySample& sample : m_history.samples()) {
        for (const Curve& curve : curves) {
            low = std::min(low, curve.of(sample));
            high = std::max(high, curve.of(sample));
        }
        if (sample.energies.potential > 0) {
            least = std::min(least, sample.energies.potential);
        }
    }
    const double decades = high > 0 && least < high ? std::log10(high / least) + 0.7 : kLeastDecades;
    const SymmetricLogScale scale(low, high, std::clamp(decades, kLeastDecades, kMostDecades));
    const int legend = painter.fontMetrics().height() + 4;
    paintLegend(painter, {rect.left() - kAxisWidth + 4, rect.top(), rect.width() + kAxisWidth, legend},
                curves);
    const QRect area = rect.adjusted(0, legend + 3, 0, 0);
    std::vector<double> ticks = scale.ticks();
    std::sort(ticks.begin(), ticks.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    std::vector<double> named;
    for (const double tick : ticks) {
        const double share = scale.map(tick);
        const bool room = std::all_of(named.begin(), named.end(), [&](double other) {
            return std::abs(share - other) * area.height() >= painter.fontMetrics().height() * 1.2;
        });
        paintAxis(painter, area, share,
                  !room       ? QString()
                  : tick == 0 ? QStringLiteral("0")
                              : powerText(tick));
        if (room) {
            named.push_back(share);
        }
    }
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Curve& curve : curves) {
        paintCurve(painter, area, curve, [&](double value) { return scale.map(value); });
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void EnergyPlot::paintResidual(QPainter& painter, const QRect& rect) const {
    const Accents accents = accentsOf(palette());
    const double now = m_history.samples().back().residual;
    const Curve curve{tr("Residual"), shortNumber(now), accents.good, Qt::SolidLine,
                      [](const EnergySample& s) { return s.residual; }};
    double low = kResidualLimit;
    double high = 1;
    for (const EnergySample& sample : m_history.samples()) {
        if (sample.residual > 0 && std::isfinite(sample.residual)) {
            low = std::min(low, sample.residual);
            high = std::max(high, sample.residual);
        }
    }
    const LogScale scale(low, high);
    const int legend = painter.fontMetrics().height() + 4;
    paintLegend(painter, {rect.left() - kAxisWidth + 4, rect.top(), rect.width() + kAxisWidth, legend},
                {curve});
    const QRect area = rect.adjusted(0, legend + 3, 0, 0);
    const int powers = scale.lastPower() - scale.firstPower();
    const int every = std::max(1, powers * painter.fontMetrics().height() / std::max(1, area.height()) + 1);
    for (int power = scale.firstPower(); power <= scale.lastPower(); ++power) {
        const double value = std::pow(10.0, power);
        const bool named = (power - scale.firstPower()) % every == 0;
        paintAxis(painter, area, scale.map(value),
                  named ? (power == 0 ? QStringLiteral("1") : powerOfTen(power)) : QString());
    }
    painter.setRenderHint(QPainter::Antialiasing);
    paintCurve(painter, area, curve, [&](double value) { return scale.map(value); });
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void EnergyPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setFont(font());
    if (m_history.empty()) {
        painter.setPen(accentsOf(palette()).faintText);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Energies appear when the fabric settles."));
        return;
    }
    const QRect inner = rect().adjusted(kAxisWidth, 2, -6, -4);
    const int split = inner.top() + inner.height() * 11 / 20;
    paintEnergies(painter, {inner.left(), inner.top(), inner.width(), split - inner.top() - 6});
    paintResidual(painter, {inner.left(), split + 4, inner.width(), inner.bottom() - split - 10});
}

} // namespace knittsim::ui
