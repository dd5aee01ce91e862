#pragma once

#include "core/pattern/chart.h"

#include <string>
#include <vector>

namespace knittsim {
class JsonReader;
}

namespace knittsim::pattern {

/// Yarns for the carriers of a chart, under a name.
struct Colourway {
    std::string name;
    std::vector<ChartYarn> yarns;

    bool operator==(const Colourway&) const = default;
};

/// The colourways of a project, and which of them its chart shows. None: the yarns of the chart are all there
/// are. The entry of the one in use is brought up to date when it is left or written; until then the chart
/// tells what it has.
struct Colourways {
    std::vector<Colourway> all;
    int used = 0;

    bool operator==(const Colourways&) const = default;
};

/// Carriers that the colourway does not name keep their yarn; those that the chart does not have are left
/// out.
void useColourway(Colourways& colourways, Chart& chart, int index);
/// A copy of what the chart has, in use then. The first call makes an entry for the present yarns, too.
void addColourway(Colourways& colourways, const Chart& chart, const std::string& name,
                  const std::string& nameOfPresent);
/// What is shown stays, but for the one in use: then its neighbour is shown. The last one stays.
void removeColourway(Colourways& colourways, Chart& chart, int index);

/// Their part of a project file, with a comma at the end; empty where there are none.
std::string colourwaysText(const Colourways& colourways, const Chart& chart);
/// The keys `colourways` and `colourway`, which may be missing. Errors go to the reader: KS0004, KS0005.
Colourways readColourways(JsonReader& reader, const std::string& file, Diagnostics& problems);

/// One yarn as an object of a project file.
std::string yarnText(const ChartYarn& yarn);
ChartYarn readChartYarn(JsonReader& reader);

} // namespace knittsim::pattern
