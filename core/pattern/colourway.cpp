#include "core/pattern/colourway.h"

#include "core/base/json_reader.h"
#include "core/yarn/colour_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace knittsim::pattern {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxColourways = 200;
constexpr std::size_t kMaxYarns = 64;

/// The entry in use gets what the chart has.
void keepUsed(Colourways& colourways, const Chart& chart) {
    if (!colourways.all.empty()) {
        colourways.all[static_cast<std::size_t>(colourways.used)].yarns = chart.yarns;
    }
}

void show(const Colourway& colourway, Chart& chart) {
    for (ChartYarn& yarn : chart.yarns) {
        const auto found = std::ranges::find(colourway.yarns, yarn.carrier, &ChartYarn::carrier);
        if (found != colourway.yarns.end()) {
            yarn = *found;
        }
    }
}

} // namespace

void useColourway(Colourways& colourways, Chart& chart, int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= colourways.all.size()) {
        return;
    }
    keepUsed(colourways, chart);
    colourways.used = index;
    show(colourways.all[static_cast<std::size_t>(index)], chart);
}

void addColourway(Colourways& colourways, const Chart& chart, const std::string& name,
                  const std::string& nameOfPresent) {
    if (colourways.all.empty()) {
        colourways.all.push_back({nameOfPresent, chart.yarns});
    }
    keepUsed(colourways, chart);
    colourways.all.push_back({name, chart.yarns});
    colourways.used = static_cast<int>(colourways.all.size()) - 1;
}

void removeColourway(Colourways& colourways, Chart& chart, int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= colourways.all.size() || colourways.all.size() == 1) {
        return;
    }
    keepUsed(colourways, chart);
    colourways.all.erase(colourways.all.begin() + index);
    if (index == colourways.used) {
        colourways.used = std::min(index, static_cast<int>(colourways.all.size()) - 1);
        show(colourways.all[static_cast<std::size_t>(colourways.used)], chart);
    } else if (index < colourways.used) {
        --colourways.used;
    }
}

std::string yarnText(const ChartYarn& yarn) {
    return fmt::format(R"({{"carrier": {}, "colour": "{}", "library_id": {}}})", json(yarn.carrier).dump(),
                       yarn::colourText(yarn.colour), json(yarn.libraryId).dump());
}

ChartYarn readChartYarn(JsonReader& reader) {
    ChartYarn yarn{reader.text("carrier"), {}, reader.optionalText("library_id")};
    yarn.colour = yarn::readColour(reader);
    reader.rejectUnknownKeys();
    return yarn;
}

std::string colourwaysText(const Colourways& colourways, const Chart& chart) {
    if (colourways.all.empty()) {
        return {};
    }
    Colourways present = colourways;
    keepUsed(present, chart);
    std::string text = fmt::format("\"colourway\": {},\n\"colourways\": [", present.used);
    for (std::size_t i = 0; i < present.all.size(); ++i) {
        const Colourway& colourway = present.all[i];
        text += fmt::format("{}\n{{\"name\": {}, \"yarns\": [", i > 0 ? "," : "",
                            json(colourway.name).dump(-1, ' ', false, json::error_handler_t::replace));
        for (std::size_t y = 0; y < colourway.yarns.size(); ++y) {
            text += (y > 0 ? ", " : "") + yarnText(colourway.yarns[y]);
        }
        text += "]}";
    }
    return text + "\n],\n";
}

Colourways readColourways(JsonReader& reader, const std::string& file, Diagnostics& problems) {
    Colourways colourways;
    if (!reader.has("colourways")) {
        return colourways;
    }
    const std::vector<json> all = reader.array("colourways", 1, kMaxColourways);
    for (std::size_t i = 0; i < all.size(); ++i) {
        JsonReader entry(all[i], file, problems, fmt::format("colourways[{}]", i));
        Colourway& colourway = colourways.all.emplace_back();
        colourway.name = entry.text("name");
        const std::vector<json> yarns = entry.array("yarns", 1, kMaxYarns);
        for (std::size_t y = 0; y < yarns.size(); ++y) {
            JsonReader yarn(yarns[y], file, problems, fmt::format("colourways[{}].yarns[{}]", i, y));
            colourway.yarns.push_back(readChartYarn(yarn));
        }
        entry.rejectUnknownKeys();
    }
    colourways.used = reader.integer("colourway", 0, std::max(0, static_cast<int>(all.size()) - 1));
    return colourways;
}

} // namespace knittsim::pattern
