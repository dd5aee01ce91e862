#pragma once

#include "core/pattern/chart.h"

/// Charts of the samples that are more than a swatch (see swatch.h).
namespace knittsim::pattern {

/// 2 x 2 cables on a purl ground; Front::Right crosses to the left.
Chart cableChart(Front front);
Chart braidChart();
Chart laceChart();
Chart ladderChart();
Chart tuckChart();
Chart slipChart();
Chart floatJacquardChart();
Chart intarsiaChart();
Chart tubeChart();
Chart shortRowsChart();
Chart rackedRibChart();
/// Two strands that wander over a purl ground, then narrowing at both edges.
Chart transferChart();

} // namespace knittsim::pattern
