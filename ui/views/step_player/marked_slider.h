#pragma once

#include <QSlider>

#include <vector>

namespace knittsim::ui {

/// A level slider with marks below and a range above its groove.
class MarkedSlider : public QSlider {
public:
    explicit MarkedSlider(QWidget* parent);

    /// Values outside the slider's range are not shown. `from` = `to`: no range.
    void setMarks(std::vector<int> values, int from, int to);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int xOf(int value) const;

    std::vector<int> m_marks;
    int m_from = 0;
    int m_to = 0;
};

} // namespace knittsim::ui
