// The part of the canvas that stands beside the cells: what each course is made of, and its change.

#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/chart_editor/side_editor.h"
#include "ui/views/style/numbers.h"

#include <QMenu>
#include <QPainter>

#include <algorithm>

namespace knittsim::ui {

using pattern::CellRange;
using pattern::Chart;

namespace {

QIcon colourIcon(const QColor& colour) {
    QPixmap pixmap(16, 16);
    pixmap.fill(colour);
    return pixmap;
}

/// Worked cells of these courses get the yarn `to`; where `from` is given, only those that had it.
void exchangeYarn(Chart& chart, CellRange courses, std::optional<std::uint8_t> from, std::uint8_t to) {
    for (int c = courses.course; c < courses.course + courses.height; ++c) {
        for (int w = 0; w < chart.width; ++w) {
            pattern::Cell& cell = chart.at(w, c);
            if (pattern::isWorked(cell.stitch) && (!from || cell.yarn == *from)) {
                cell.yarn = to;
            }
        }
    }
}

} // namespace

void ChartCanvas::takeFacts() {
    m_facts.clear();
    if (m_document.fabricFollowsChart()) {
        const auto file = m_document.file();
        const auto& ends = file->chartCourseEnds;
        std::size_t course = 0;
        m_facts = document::courseFacts(file->timeline->program(), static_cast<int>(ends.size()),
                                        [&](machine::OperationIndex operation) {
                                            while (course < ends.size() && ends[course] <= operation) {
                                                ++course;
                                            }
                                            return static_cast<int>(course);
                                        });
    }
    takeNotes();
}

/// Yarns that a course works, those that the program knows in its order.
std::vector<CourseNote::Yarn> ChartCanvas::yarnsOf(int course) const {
    const Chart& chart = shown();
    std::vector<char> used(chart.yarns.size());
    for (int w = 0; w < chart.width; ++w) {
        const pattern::Cell& cell = chart.at(w, course);
        if (pattern::isWorked(cell.stitch) && cell.yarn < used.size()) {
            used[cell.yarn] = 1;
        }
    }
    std::vector<CourseNote::Yarn> yarns;
    const auto add = [&](std::size_t yarn, int direction) {
        used[yarn] = 0;
        yarns.push_back({QString::fromStdString(chart.yarns[yarn].carrier),
                         colourOf({pattern::Stitch::Knit, static_cast<std::uint8_t>(yarn)}), direction});
    };
    if (static_cast<std::size_t>(course) < m_facts.size()) {
        for (const auto& feed : m_facts[static_cast<std::size_t>(course)].feeds) {
            for (std::size_t y = 0; y < used.size() && feed.carrier < m_document.carriers().size(); ++y) {
                if (used[y] && chart.yarns[y].carrier == m_document.carriers()[feed.carrier].carrier) {
                    add(y, machine::sign(feed.direction));
                }
            }
        }
    }
    for (std::size_t y = 0; y < used.size(); ++y) {
        if (used[y]) {
            add(y, 0);
        }
    }
    return yarns;
}

void ChartCanvas::takeNotes() {
    std::vector<CourseNote> notes;
    std::optional<double> stitch;
    for (int c = 0; c < shown().height(); ++c) {
        const pattern::Course& course = shown().course(c);
        stitch = course.stitchNumber ? course.stitchNumber : stitch;
        notes.push_back(
            {yarnsOf(c), stitch, course.stitchNumber.has_value(), static_cast<double>(course.rack)});
    }
    setNotes(std::move(notes), shown().yarns.size() > 1);
}

/// The courses of the selection, where it holds this one.
CellRange ChartCanvas::coursesAt(int course) const {
    const bool selected = course >= m_selection.course && course < m_selection.course + m_selection.height;
    return selected ? CellRange{0, m_selection.course, shown().width, m_selection.height}
                    : CellRange{0, course, shown().width, 1};
}

void ChartCanvas::editSide(SidePlace place, QPoint position) {
    m_cursor.course = place.course;
    m_anchor = m_cursor;
    switch (place.column) {
    case SideColumn::Carrier: {
        // The box that was hit tells which of several yarns is meant.
        const std::vector<CourseNote::Yarn> yarns = yarnsOf(place.course);
        const QRect rect = sideRect(place);
        const int box =
            (position.x() - rect.left() - 3) * static_cast<int>(yarns.size()) / std::max(1, rect.width() - 6);
        std::optional<std::uint8_t> from;
        if (yarns.size() > 1 && box >= 0 && static_cast<std::size_t>(box) < yarns.size()) {
            const auto& all = shown().yarns;
            const auto found =
                std::ranges::find(all, yarns[static_cast<std::size_t>(box)].carrier.toStdString(),
                                  &pattern::ChartYarn::carrier);
            from = static_cast<std::uint8_t>(found - all.begin());
        }
        chooseYarn(place.course, from, viewport()->mapToGlobal(position));
        break;
    }
    case SideColumn::StitchSize:
    case SideColumn::Racking:
        editNumber(place);
        break;
    default:
        select({0, place.course, shown().width, 1});
        break;
    }
    viewport()->update();
}

void ChartCanvas::chooseYarn(int course, std::optional<std::uint8_t> from, QPoint globalPosition) {
    const CellRange courses = coursesAt(course);
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("courseYarn"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (std::size_t i = 0; i < shown().yarns.size(); ++i) {
        const auto yarn = static_cast<std::uint8_t>(i);
        menu->addAction(colourIcon(colourOf({pattern::Stitch::Knit, yarn})),
                        tr("Carrier %1").arg(QString::fromStdString(shown().yarns[i].carrier)), this,
                        [this, courses, from, yarn] {
                            m_document.editChart(tr("yarn of the course"), [&](Chart& chart) {
                                exchangeYarn(chart, courses, from, yarn);
                            });
                        });
    }
    menu->popup(globalPosition);
}

void ChartCanvas::editNumber(SidePlace place) {
    const bool racking = place.column == SideColumn::Racking;
    const CellRange courses = coursesAt(place.course);
    const pattern::Course& course = shown().course(place.course);
    if (racking && shown().beds == pattern::BedUse::Single) {
        emit hovered(tr("Only a chart on both beds is racked; on a single bed loops are moved by cables."));
        return;
    }
    const QString text = racking               ? QString::number(course.rack)
                         : course.stitchNumber ? QString::number(*course.stitchNumber)
                                               : QString();
    QRect rect = sideRect(place);
    if (rect.isNull()) { // it comes with the first number
        rect =
            QRect(2, geometryOfChart().cellRect(place.course, 0).top(), 46, geometryOfChart().cellHeight());
    }
    const SideEditor::Range range = racking ? SideEditor::Range{-20, 20, true} : SideEditor::Range{0, 1000};
    auto* editor = new SideEditor(
        rect, text, range,
        [this, courses, racking](std::optional<double> value) {
            m_document.editChart(racking ? tr("racking") : tr("stitch size"), [&](Chart& chart) {
                // The chart may have got shorter while the number was typed.
                const int end = std::min(courses.course + courses.height, chart.height());
                for (int c = courses.course; c < end; ++c) {
                    if (racking) {
                        chart.course(c).rack = static_cast<int>(value.value_or(0));
                    } else {
                        // It holds from here on, so only the first course needs to say it.
                        chart.course(c).stitchNumber = c == courses.course ? value : std::nullopt;
                    }
                }
            });
            setFocus();
        },
        viewport());
    editor->setAccessibleName(racking ? tr("Racking of the course") : tr("Stitch size from this course on"));
}

void ChartCanvas::chooseCourseYarn() {
    chooseYarn(m_cursor.course, std::nullopt,
               viewport()->mapToGlobal(rectOf({m_cursor.wale, m_cursor.course, 1, 1}).bottomLeft()));
}

void ChartCanvas::editStitchSize() {
    editNumber({SideColumn::StitchSize, m_cursor.course});
}

void ChartCanvas::editRacking() {
    editNumber({SideColumn::Racking, m_cursor.course});
}

} // namespace knittsim::ui
