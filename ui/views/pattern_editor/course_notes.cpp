#include "ui/views/pattern_editor/course_notes.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace knittsim::ui {

bool tells(const std::vector<CourseNote>& notes, SideColumn column) {
    using Yarn = CourseNote::Yarn;
    switch (column) {
    case SideColumn::Course:
    case SideColumn::Needle:
        return true;
    case SideColumn::Direction:
        return std::ranges::any_of(notes, [](const CourseNote& note) {
            return std::ranges::any_of(note.yarns, [](const Yarn& yarn) { return yarn.direction != 0; });
        });
    case SideColumn::Carrier:
        return std::ranges::any_of(notes, [&](const CourseNote& note) {
            return note.yarns.size() > 1 || (!note.yarns.empty() && !notes.front().yarns.empty() &&
                                             note.yarns[0].carrier != notes.front().yarns[0].carrier);
        });
    case SideColumn::StitchSize:
        return std::ranges::any_of(notes, [](const CourseNote& note) { return note.stitchSize.has_value(); });
    case SideColumn::Racking:
        break;
    }
    return std::ranges::any_of(notes, [](const CourseNote& note) { return note.racking != 0; });
}

QString noteText(const CourseNote& note, int course) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("knittsim::ui", text); };
    QStringList parts{tr("Course %1").arg(course + 1)};
    for (const CourseNote::Yarn& yarn : note.yarns) {
        parts << (yarn.direction < 0   ? tr("carrier %1 to the left").arg(yarn.carrier)
                  : yarn.direction > 0 ? tr("carrier %1 to the right").arg(yarn.carrier)
                                       : tr("carrier %1").arg(yarn.carrier));
    }
    if (note.stitchSize) {
        parts << tr("stitch size %1").arg(QString::number(*note.stitchSize, 'g', 4));
    }
    if (note.racking != 0) {
        parts << tr("racking %1").arg(QString::number(note.racking, 'g', 4));
    }
    return parts.join(QStringLiteral(", "));
}

} // namespace knittsim::ui
