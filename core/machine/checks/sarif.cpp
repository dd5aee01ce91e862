#include "core/base/message_table.h"
#include "core/machine/checks/report.h"
#include "core/machine/checks/rules.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <map>
#include <set>

namespace knittsim::machine {

namespace {

using Json = nlohmann::ordered_json;

const char* levelOf(Severity severity) {
    switch (severity) {
    case Severity::Info:
        return "note";
    case Severity::Warning:
        return "warning";
    case Severity::Error:
        break;
    }
    return "error";
}

/// A path as a URI reference (RFC 3986): relative paths stay relative.
std::string uriOf(const std::string& path) {
    std::string uri = path.starts_with('/') ? "file://" : "";
    for (const char c : path) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '/' || c == '-' || c == '.' || c == '_' || c == '~';
        uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return uri;
}

/// The rules that appear, in the order of their ids, with their place in the list.
class RuleList {
public:
    explicit RuleList(std::span<const CheckedFile> files) {
        std::map<std::string, Severity> used;
        for (const CheckedFile& file : files) {
            for (const Diagnostic& finding : file.result.findings) {
                used.emplace(finding.id, finding.severity);
            }
            for (const Waived& waived : file.result.waived) {
                used.emplace(waived.finding.id, waived.finding.severity);
            }
        }
        for (const auto& [id, severity] : used) {
            const Rule* rule = findRule(id);
            const Message* message = findMessage(id);
            Json entry{{"id", id}};
            if (message != nullptr) {
                entry["name"] = message->name;
                entry["shortDescription"]["text"] = message->cause;
                if (!message->cure.empty()) {
                    entry["help"]["text"] = message->cure;
                }
            }
            entry["defaultConfiguration"]["level"] = levelOf(rule != nullptr ? rule->severity : severity);
            m_places.emplace(id, m_rules.size());
            m_rules.push_back(std::move(entry));
        }
    }

    const Json& rules() const { return m_rules; }
    std::size_t placeOf(const std::string& id) const { return m_places.at(id); }

private:
    Json m_rules = Json::array();
    std::map<std::string, std::size_t> m_places;
};

Json locationOf(const std::string& file, const Place& place) {
    Json location{{"physicalLocation", {{"artifactLocation", {{"uri", uriOf(file)}}}}}};
    if (place.line > 0) {
        location["physicalLocation"]["region"]["startLine"] = place.line;
        if (place.column > 0) {
            location["physicalLocation"]["region"]["startColumn"] = place.column;
        }
    }
    if (!place.needle.empty()) {
        location["logicalLocations"] = Json::array({{{"name", place.needle}, {"kind", "needle"}}});
    }
    return location;
}

Json resultOf(const std::string& file, const Diagnostic& finding, const RuleList& rules) {
    const std::string cure = cureText(finding);
    Json result{{"ruleId", finding.id},
                {"ruleIndex", rules.placeOf(finding.id)},
                {"level", levelOf(finding.severity)},
                {"message", {{"text", causeText(finding) + (cure.empty() ? "" : ' ' + cure)}}},
                {"locations", Json::array({locationOf(file, finding.place)})}};
    if (finding.place.operation >= 0) {
        result["properties"]["operation"] = finding.place.operation;
    }
    return result;
}

} // namespace

std::string toSarif(std::span<const CheckedFile> files, const std::string& version) {
    const RuleList rules(files);
    Json results = Json::array();
    Json artifacts = Json::array();
    std::set<std::string> named;
    for (const CheckedFile& file : files) {
        if (named.insert(file.file).second) {
            artifacts.push_back({{"location", {{"uri", uriOf(file.file)}}}});
        }
        for (const Diagnostic& finding : file.result.findings) {
            results.push_back(resultOf(file.file, finding, rules));
        }
        for (const Waived& waived : file.result.waived) {
            results.push_back(resultOf(file.file, waived.finding, rules));
            results.back()["suppressions"] =
                Json::array({{{"kind", "external"}, {"justification", waived.reason}}});
        }
    }
    const Json driver{{"name", "knittsim-cli"}, {"version", version}, {"rules", rules.rules()}};
    const Json run{{"tool", {{"driver", driver}}}, {"artifacts", artifacts}, {"results", results}};
    const Json log{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                   {"version", "2.1.0"},
                   {"runs", Json::array({run})}};
    return log.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace knittsim::machine
