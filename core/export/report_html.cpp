#include "core/base/message_table.h"
#include "core/export/report.h"
#include "core/formats/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace knittsim::exports {

namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --ink: #1f2328; --soft: #5a626c; --line: #d5d9de; --paper: #ffffff;
  --error: #b3261e; --warning: #8a5a00; --note: #2c5c9e; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e7ea; --soft: #a2a9b2; --line: #3c4249;
  --paper: #1c1f23; --error: #ff8a80; --warning: #f0b95a; --note: #8fb8f0; } }
@media print { :root { --ink: #000; --soft: #444; --line: #bbb; --paper: #fff; --error: #a00;
  --warning: #640; --note: #036; } body { margin: 0; max-width: none; } tr, section { break-inside: avoid; }
  thead { display: table-header-group; } }
body { font: 15px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 60rem; margin: 2rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.5rem; margin: 0; overflow-wrap: anywhere; } h2 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
p { margin: .3rem 0; } .soft { color: var(--soft); } code { overflow-wrap: anywhere; font-size: .9em; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: .3rem .8rem .3rem 0;
  border-bottom: 1px solid var(--line); overflow-wrap: anywhere; }
th { color: var(--soft); font-weight: 600; } td.n, th.n { text-align: right; white-space: nowrap; }
table.facts th { width: 14rem; } .nowrap { white-space: nowrap; }
.error { color: var(--error); } .warning { color: var(--warning); } .note { color: var(--note); }
.error, .warning, .note { font-weight: 600; white-space: nowrap; }
)";

std::string escaped(std::string_view text) {
    const std::string good = formats::isUtf8(text) ? std::string(text) : formats::replaceBadUtf8(text);
    std::string html;
    html.reserve(good.size());
    for (const char c : good) {
        switch (c) {
        case '&':
            html += "&amp;";
            break;
        case '<':
            html += "&lt;";
            break;
        case '>':
            html += "&gt;";
            break;
        case '"':
            html += "&quot;";
            break;
        case '\'':
            html += "&#39;";
            break;
        default:
            html += c;
        }
    }
    return html;
}

/// A row of facts; `value` is HTML.
std::string fact(std::string_view name, const std::string& value) {
    return fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", name, value);
}

std::string durationText(double seconds) {
    const auto whole = std::llround(seconds);
    return whole >= 3600 ? fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60)
           : whole >= 60 ? fmt::format("{} min {:02} s", whole / 60, whole % 60)
                         : fmt::format("{:.1f} s", seconds);
}

std::string placeText(const Place& place) {
    std::string text = place.line > 0 ? fmt::format("line {}", place.line) : "";
    if (place.course >= 0) {
        text += (text.empty() ? "course " : ", course ") + std::to_string(place.course + 1);
    }
    if (!place.needle.empty()) {
        text += (text.empty() ? "" : ", ") + place.needle;
    }
    return text;
}

const char* severityWord(Severity severity) {
    return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "note";
}

std::string countText(const Diagnostics& findings, Severity severity) {
    const auto count = std::ranges::count(findings, severity, &Diagnostic::severity);
    return fmt::format("{} {}{}", count, severityWord(severity), count == 1 ? "" : "s");
}

std::string timeText(const KnittingTime& time) {
    const machine::ProfileSpeed& speed = time.speed;
    return fmt::format(
        "<strong>{}</strong>, {}<br><span class=\"soft\">{:.1f} m at {:g} m/s + {:.1f} m of transfers at "
        "{:g} m/s + {} strokes of {:g} s to turn ({} with yarn, {} transfers, {} empty). One knitting "
        "system; "
        "speeds {}.</span>",
        durationText(time.seconds()), speed.assumed ? "estimated with assumed speeds" : "estimated",
        time.knitMetres, speed.knitMetresPerSecond, time.transferMetres, speed.transferMetresPerSecond,
        time.strokes(), speed.turnSeconds, time.knitStrokes, time.transferStrokes, time.emptyStrokes,
        speed.assumed ? "assumed: the machine profile names none" : "of the machine profile");
}

std::string factsHtml(const Knitting& knitting) {
    const Totals& totals = knitting.totals;
    std::string html = "<section><h2>Machine and size</h2>\n<table class=\"facts\">\n";
    html += fact("Machine", fmt::format("{} <span class=\"soft\">({})</span>", escaped(knitting.profileName),
                                        escaped(knitting.profileId)));
    html += fact("Needles", fmt::format("{} (front {}, rear {})", totals.needles, totals.frontNeedles,
                                        totals.rearNeedles));
    html += fact("Courses", std::to_string(totals.courses));
    html += fact("Passes", std::to_string(totals.passes));
    html += fact("Operations", std::to_string(totals.operations));
    html += fact("Loops", std::to_string(totals.loops));
    html += fact("Knitting time", timeText(knitting.time));
    const auto& longest = knitting.longestFloat;
    html +=
        fact("Longest float", longest ? fmt::format("{:.1f} mm over {:g} needles, carrier {}, {}",
                                                    longest->mm, longest->needles, escaped(longest->carrier),
                                                    escaped(placeText(longest->place)))
                                      : "none");
    const auto& racking = knitting.largestRacking;
    html +=
        fact("Largest racking",
             racking ? fmt::format("{:g} pitches, {}", racking->pitches, placeText(racking->place)) : "none");
    return html + "</table></section>\n";
}

std::string yarnHtml(const std::vector<YarnUse>& yarns) {
    std::string html = "<section><h2>Yarn</h2>\n<table>\n<thead><tr><th>Carrier</th><th>Yarn</th>"
                       "<th class=\"n\">tex</th><th class=\"n\">m</th><th class=\"n\">g</th></tr></thead>\n";
    double metres = 0;
    double grams = 0;
    for (const YarnUse& use : yarns) {
        html += fmt::format("<tr><td>{}</td><td>{}</td><td class=\"n\">{:.1f}</td><td class=\"n\">{:.2f}</td>"
                            "<td class=\"n\">{:.2f}</td></tr>\n",
                            escaped(use.carrier), escaped(use.yarn), use.tex, use.metres, use.grams());
        metres += use.metres;
        grams += use.grams();
    }
    return html + fmt::format("<tr><th>All</th><th></th><th></th><th class=\"n\">{:.2f}</th>"
                              "<th class=\"n\">{:.2f}</th></tr>\n</table></section>\n",
                              metres, grams);
}

std::string findingHtml(const Diagnostic& finding, const std::string& offReason) {
    const char* word = severityWord(finding.severity);
    std::string what = escaped(causeText(finding));
    if (const std::string cure = cureText(finding); !cure.empty()) {
        what += fmt::format("<br><span class=\"soft\">{}</span>", escaped(cure));
    }
    if (!offReason.empty()) {
        what += fmt::format("<br>Turned off: {}", escaped(offReason));
    }
    return fmt::format(
        "<tr><td class=\"{0}\">{0}</td><td class=\"nowrap\">{1}</td><td>{2}</td><td>{3}</td></tr>\n", word,
        escaped(finding.id), escaped(placeText(finding.place)), what);
}

std::string tableOf(const std::string& rows) {
    return "<table>\n<thead><tr><th>Severity</th><th>Rule</th><th>Place</th><th>Cause and cure</th></tr>"
           "</thead>\n" +
           rows + "</table></section>\n";
}

std::string findingsHtml(const machine::CheckResult& checks) {
    std::string rows;
    for (const Diagnostic& finding : checks.findings) {
        rows += findingHtml(finding, {});
    }
    std::string html = "<section><h2>Findings</h2>\n";
    html += rows.empty() ? "<p>Nothing was found.</p></section>\n" : tableOf(rows);
    rows.clear();
    for (const machine::Waived& waived : checks.waived) {
        rows += findingHtml(waived.finding, waived.reason);
    }
    return rows.empty() ? html : html + "<section><h2>Turned off</h2>\n" + tableOf(rows);
}

} // namespace

std::string toHtml(const Report& report) {
    const std::string name = escaped(std::filesystem::path(report.file).filename().string());
    const Diagnostics& findings = report.checks.findings;
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    html +=
        fmt::format("<title>{} - check report</title>\n<style>{}</style>\n</head>\n<body>\n", name, kStyle);
    html += fmt::format(
        "<h1>{}</h1>\n<p>{}, {}, {}{}</p>\n", name, countText(findings, Severity::Error),
        countText(findings, Severity::Warning), countText(findings, Severity::Info),
        report.checks.waived.empty() ? "" : fmt::format(", {} turned off", report.checks.waived.size()));
    html += fmt::format("<p class=\"soft\">{}<br>SHA-256 <code>{}</code></p>\n", escaped(report.file),
                        report.sha256.empty() ? "not known" : report.sha256);
    if (report.knitting) {
        html += factsHtml(*report.knitting) + yarnHtml(report.knitting->yarns);
    }
    html += findingsHtml(report.checks);
    return html +
           fmt::format("<p class=\"soft\">KnittSim {}</p>\n</body>\n</html>\n", escaped(report.version));
}

} // namespace knittsim::exports
