#pragma once

#include "core/machine/program.h"
#include "core/pattern/chart.h"

#include <string>
#include <string_view>
#include <vector>

/// Our own sample programs. resources/patterns/ID.k holds the text that sampleText(ID) gives.
namespace knittsim::pattern {

struct Sample {
    std::string id;          ///< file name without ".k"
    std::string title;       ///< English; the window translates it
    std::string description; ///< one English sentence
};

/// In the order in which a menu shows them.
const std::vector<Sample>& samples();

/// Chart and machine program of a sample; empty ones for an unknown id.
Chart sampleChart(std::string_view id);
machine::Program makeSample(std::string_view id);

/// The program as a knitout file with title and description as comments.
std::string sampleText(std::string_view id);

} // namespace knittsim::pattern
