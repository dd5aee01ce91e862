#pragma once

#include "core/base/json_reader.h"
#include "core/pattern/program_course.h"

#include <string>

/// Courses of programs from outside as a project file says them (project.h).
namespace knittsim::pattern {

std::string programText(const ProgramCourse& course);

/// For a chart of these wales and yarns. Errors go to the reader; null then.
std::shared_ptr<const ProgramCourse> readProgramCourse(JsonReader& reader, const Chart& chart);

} // namespace knittsim::pattern
