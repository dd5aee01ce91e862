#pragma once

#include "ui/document/course_facts.h"
#include "ui/views/pattern_editor/chart_look.h"

#include <QColor>
#include <QString>

#include <optional>
#include <vector>

namespace knittsim::ui {

/// What stands beside one course of a chart.
struct CourseNote {
    struct Yarn {
        QString carrier;
        QColor colour;
        int direction = 0; ///< of the carriage: -1 left, +1 right, 0 not known
    };
    std::vector<Yarn> yarns;
    std::optional<double> stitchSize;
    bool ownStitchSize = true; ///< else as in the courses before
    double racking = 0;        ///< pitches
};

/// Some course says something there that is not the same in all of them anyway.
bool tells(const std::vector<CourseNote>& notes, SideColumn column);

/// One course in words, for tooltips.
QString noteText(const CourseNote& note, int course);

} // namespace knittsim::ui
