#include "ui/views/pattern_editor/chart_geometry.h"

#include <algorithm>
#include <array>

namespace knittsim::ui {

QRect ChartGeometry::chartArea() const {
    return {header.width(), 0, std::max(0, view.width() - header.width()),
            std::max(0, view.height() - header.height())};
}

QPoint ChartGeometry::origin() const {
    const QRect area = chartArea();
    const QSize size = content();
    const int x = size.width() < area.width() ? (area.width() - size.width()) / 2 : -scroll.x();
    const int y = size.height() < area.height() ? (area.height() - size.height()) / 2 : -scroll.y();
    return area.topLeft() + QPoint(x, y);
}

QRect ChartGeometry::cellRect(std::int32_t course, std::int32_t column) const {
    const QPoint corner = origin();
    return {corner.x() + column * cellWidth, corner.y() + (courses - 1 - course) * cellHeight(), cellWidth,
            cellHeight()};
}

ChartGeometry::Cell ChartGeometry::cellAt(QPoint position) const {
    const QPoint inside = position - origin();
    const QSize size = content();
    if (!chartArea().contains(position) || inside.x() < 0 || inside.y() < 0 || inside.x() >= size.width() ||
        inside.y() >= size.height()) {
        return {};
    }
    const int row = inside.y() / cellHeight();
    return {courses - 1 - row, inside.x() / cellWidth, inside.y() % cellHeight() < cellHeight() / 2};
}

ChartGeometry::Range ChartGeometry::visibleColumns() const {
    const int left = chartArea().left() - origin().x();
    const int right = left + chartArea().width();
    return {std::clamp(left / cellWidth, 0, columns), std::clamp(right / cellWidth + 1, 0, columns)};
}

ChartGeometry::Range ChartGeometry::visibleCourses() const {
    const int top = chartArea().top() - origin().y();
    const int bottom = top + chartArea().height();
    const int firstRow = std::clamp(top / cellHeight(), 0, courses);
    const int endRow = std::clamp(bottom / cellHeight() + 1, 0, courses);
    return {courses - endRow, courses - firstRow};
}

int ChartGeometry::fittingCell(int least, int limit) const {
    const QRect area = chartArea();
    int width = limit;
    while (width > least &&
           (columns * width > area.width() || courses * cellHeightOf(width) > area.height())) {
        --width;
    }
    return width;
}

int nextCellWidth(int width, int direction) {
    constexpr std::array kLevels{2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 17, 20, 24, 28, 34, 40, 48, 56, 64};
    if (direction > 0) {
        const auto* found = std::upper_bound(kLevels.begin(), kLevels.end(), width);
        return found == kLevels.end() ? kLevels.back() : *found;
    }
    const auto* found = std::lower_bound(kLevels.begin(), kLevels.end(), width);
    return found == kLevels.begin() ? kLevels.front() : *(found - 1);
}

} // namespace knittsim::ui
