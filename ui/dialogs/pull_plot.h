#pragma once

#include <QPointF>
#include <QWidget>

#include <vector>

namespace knittsim::ui {

/// Force against strain, up as a full line and back as a dashed one.
class PullPlot : public QWidget {
    Q_OBJECT

public:
    explicit PullPlot(QWidget* parent = nullptr);

    /// x: strain in per cent, y: force by width in N/mm. `mostStrain` per cent: where the axis ends.
    void setCurves(std::vector<QPointF> up, std::vector<QPointF> back, double mostStrain);

    QSize sizeHint() const override { return {460, 260}; }
    QSize minimumSizeHint() const override { return {300, 180}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<QPointF> m_up;
    std::vector<QPointF> m_back;
    double m_mostStrain = 60;
};

} // namespace knittsim::ui
