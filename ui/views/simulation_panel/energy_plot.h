#pragma once

#include "ui/views/simulation_panel/energy_history.h"

#include <QWidget>

#include <functional>

namespace knittsim::ui {

/// E_kin, V and L above, the relative residual below, both over the steps of the run.
class EnergyPlot : public QWidget {
    Q_OBJECT

public:
    explicit EnergyPlot(QWidget* parent = nullptr);

    void clear();
    void add(const EnergySample& sample);
    const EnergyHistory& history() const { return m_history; }

    QSize sizeHint() const override { return {260, 190}; }
    QSize minimumSizeHint() const override { return {180, 120}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Curve;

    void paintEnergies(QPainter& painter, const QRect& rect) const;
    void paintResidual(QPainter& painter, const QRect& rect) const;
    void paintCurve(QPainter& painter, const QRect& rect, const Curve& curve,
                    const std::function<double(double)>& map) const;
    void paintLegend(QPainter& painter, const QRect& rect, const std::vector<Curve>& curves) const;
    void paintAxis(QPainter& painter, const QRect& rect, double share, const QString& text) const;
    double stepShare(std::int64_t step) const;

    EnergyHistory m_history;
};

} // namespace knittsim::ui
