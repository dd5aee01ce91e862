#include "core/export/report.h"
#include "core/machine/checks/findings_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace knittsim::exports {

namespace {

using Json = nlohmann::ordered_json;

/// To thousandths: finer is noise.
double rounded(double value) {
    return std::round(value * 1000) / 1000;
}

Json known(int number) {
    return number >= 0 ? Json(number) : Json(nullptr);
}

Json known(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

Json timeJson(const KnittingTime& time) {
    return {{"seconds", rounded(time.seconds())},
            {"formula", "knit_way_m / knit_m_per_s + transfer_way_m / transfer_m_per_s + strokes * turn_s"},
            {"assumed", time.speed.assumed},
            {"knit_way_m", rounded(time.knitMetres)},
            {"transfer_way_m", rounded(time.transferMetres)},
            {"strokes", time.strokes()},
            {"knit_strokes", time.knitStrokes},
            {"transfer_strokes", time.transferStrokes},
            {"empty_strokes", time.emptyStrokes},
            {"knit_m_per_s", time.speed.knitMetresPerSecond},
            {"transfer_m_per_s", time.speed.transferMetresPerSecond},
            {"turn_s", time.speed.turnSeconds}};
}

void addKnitting(const Knitting& knitting, Json& json) {
    const Totals& totals = knitting.totals;
    json["machine"] = {{"id", knitting.profileId}, {"name", knitting.profileName}};
    json["sizes"] = {{"needles", totals.needles},
                     {"front_needles", totals.frontNeedles},
                     {"rear_needles", totals.rearNeedles},
                     {"courses", totals.courses},
                     {"passes", totals.passes},
                     {"operations", totals.operations},
                     {"loops", totals.loops}};
    json["yarn"] = Json::array();
    for (const YarnUse& use : knitting.yarns) {
        json["yarn"].push_back({{"carrier", use.carrier},
                                {"yarn", use.yarn},
                                {"tex_g_per_km", use.tex},
                                {"length_m", rounded(use.metres)},
                                {"mass_g", rounded(use.grams())}});
    }
    json["knitting_time"] = timeJson(knitting.time);
    json["longest_float"] = nullptr;
    if (knitting.longestFloat) {
        const LongestFloat& longest = *knitting.longestFloat;
        json["longest_float"] = {{"length_mm", rounded(longest.mm)}, {"needles", longest.needles},
                                 {"carrier", longest.carrier},       {"line", known(longest.place.line)},
                                 {"needle", longest.place.needle},   {"course", longest.place.course + 1}};
    }
    json["largest_racking"] = nullptr;
    if (knitting.largestRacking) {
        json["largest_racking"] = {{"pitches", knitting.largestRacking->pitches},
                                   {"line", known(knitting.largestRacking->place.line)}};
    }
}

} // namespace

std::string toJson(const Report& report) {
    Json json{{"knittsim_version", report.version},
              {"file", report.file},
              {"sha256", known(report.sha256)},
              {"readable", report.knitting.has_value()}};
    if (report.knitting) {
        addKnitting(*report.knitting, json);
    }
    json["findings"] = machine::findingsJson(report.checks);
    // Names of files and carriers may hold bytes that are not UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace knittsim::exports
