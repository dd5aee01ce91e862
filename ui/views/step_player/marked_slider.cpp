#include "ui/views/step_player/marked_slider.h"

#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>

#include <algorithm>

namespace knittsim::ui {

MarkedSlider::MarkedSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {}

void MarkedSlider::setMarks(std::vector<int> values, int from, int to) {
    m_marks = std::move(values);
    m_from = from;
    m_to = to;
    update();
}

int MarkedSlider::xOf(int value) const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
    return handle / 2 + QStyle::sliderPositionFromValue(minimum(), maximum(), value, width() - handle);
}

void MarkedSlider::paintEvent(QPaintEvent* event) {
    QSlider::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const QColor colour = palette().color(QPalette::Highlight);
    const int from = std::max(m_from, minimum());
    const int to = std::min(m_to, maximum());
    if (from < to) {
        painter.setBrush(colour);
        painter.drawRect(QRect(QPoint(xOf(from), 0), QPoint(xOf(to), 2)));
    }
    painter.setBrush(palette().color(QPalette::WindowText));
    for (const int value : m_marks) {
        if (value >= minimum() && value <= maximum()) {
            const double x = xOf(value);
            painter.drawPolygon(
                QPolygonF{{x, height() - 5.0}, {x + 3.5, height() - 0.5}, {x - 3.5, height() - 0.5}});
        }
    }
}

} // namespace knittsim::ui
