#include "tests/gui/window/chart_fixture.h"

namespace knittsim::ui {

void ChartFixture::newChart(int wales, int courses) {
    auto project = std::make_shared<pattern::Project>();
    project->chart = pattern::Chart(wales, courses);
    project->chart.yarns = {{"1", {}, "merino-2-30"}};
    open([&] { document().openProject("new", project); });
    canvas()->setTool(ChartTool::Pencil);
}

QPoint ChartFixture::place(pattern::CellPlace cell) {
    return canvas()->geometryOfChart().cellRect(cell.course, cell.wale).center();
}

void ChartFixture::stroke(pattern::CellPlace from, pattern::CellPlace to) {
    QTest::mousePress(canvas()->viewport(), Qt::LeftButton, {}, place(from));
    QTest::mouseMove(canvas()->viewport(), place(to));
    QTest::mouseRelease(canvas()->viewport(), Qt::LeftButton, {}, place(to));
}

} // namespace knittsim::ui
