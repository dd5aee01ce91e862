#include "app/cli/commands.h"
#include "core/base/file.h"
#include "core/base/message_table.h"
#include "core/base/resources.h"
#include "core/base/sha256.h"
#include "core/export/report.h"
#include "core/fabric/fabric_builder.h"
#include "core/formats/formats.h"
#include "core/machine/checks/report.h"
#include "core/machine/checks/rules.h"
#include "core/machine/profile_library.h"
#include "core/pattern/project.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace knittsim::cli {

namespace {

using machine::CheckedFile;
using machine::Waiver;

struct CheckOptions {
    std::vector<std::string> files;
    std::string machine;
    std::vector<std::string> off; ///< RULE=REASON
    std::string format = "text";
    std::string report; ///< OUT.html or OUT.json
    bool rules = false;
    bool machines = false;
};

void print(const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) {
        fmt::print(stderr, "{}\n", toLine(diagnostic));
    }
}

int listRules() {
    for (const machine::Rule& rule : machine::rules()) {
        const Message* message = findMessage(rule.id);
        fmt::print("{} {:<8} {:<20} {}\n", rule.id, toString(rule.severity), message->name, message->cause);
    }
    return kFine;
}

int listProfiles(const machine::ProfileLibrary& library) {
    for (const machine::MachineProfile& profile : library.profiles()) {
        fmt::print("{:<14} {}: {} needles of gauge {:g} ({:.0f} mm), racking {:g} to {:g}, {} carriers\n",
                   profile.id, profile.name, profile.needlesPerBed, profile.gauge, profile.bedLengthMm(),
                   profile.minRack, profile.maxRack, profile.carriers.size());
    }
    return kFine;
}

struct Outcome {
    CheckedFile checked;
    bool readable = false;
    std::optional<exports::Knitting> knitting; ///< where a report is wanted
};

exports::Knitting describe(const machine::Timeline& timeline) {
    const auto library = yarn::YarnLibrary::read(resourceFolder() / "yarns");
    print(library.diagnostics());
    const yarn::YarnLibrary none({});
    return exports::describe(
        timeline, fabric::buildFabric(timeline),
        machine::carrierYarns(timeline.program(), library ? library.value() : none, yarn::defaultYarn()));
}

/// False, having said why, when it cannot be written.
bool writeReport(const Outcome& outcome, const std::string& path) {
    const Result<std::string> bytes = readFile(outcome.checked.file);
    const auto written = exports::writeReport({.file = outcome.checked.file,
                                               .sha256 = bytes ? sha256(bytes.value()) : "",
                                               .knitting = outcome.knitting,
                                               .checks = outcome.checked.result,
                                               .version = KNITTSIM_VERSION},
                                              path);
    print(written.diagnostics());
    return written.hasValue();
}

/// Nothing when the profile cannot be used.
std::optional<Outcome> checkFile(const std::string& file, const CheckOptions& options,
                                 const machine::ProfileLibrary& library, const std::vector<Waiver>& wanted) {
    Outcome outcome{
        .checked = {.file = file, .profile = {}, .result = {}}, .readable = false, .knitting = std::nullopt};
    auto program = pattern::readAnyProgram(file);
    Diagnostics findings = program.diagnostics();
    std::vector<Waiver> waivers = wanted;
    if (program) {
        auto profile = machine::chooseProfile(program.value(), library, options.machine);
        if (!profile) {
            print(profile.diagnostics());
            return std::nullopt;
        }
        findings.insert(findings.end(), profile.diagnostics().begin(), profile.diagnostics().end());
        const auto off = machine::waiversOf(profile.value());
        if (!off) {
            print(off.diagnostics());
            return std::nullopt;
        }
        waivers.insert(waivers.end(), off.value().begin(), off.value().end());
        outcome.readable = true;
        outcome.checked.profile = profile->id;
        const machine::Timeline timeline(std::move(program).value(), std::move(profile).value());
        const Diagnostics more = machine::check(timeline);
        findings.insert(findings.end(), more.begin(), more.end());
        if (!options.report.empty()) {
            outcome.knitting = describe(timeline);
        }
    }
    outcome.checked.result = machine::applyWaivers(std::move(findings), waivers);
    return outcome;
}

int runCheck(const CheckOptions& options) {
    Diagnostics problems;
    const auto library = machine::ProfileLibrary::read(machine::profileFolders(), problems);
    print(problems);
    if (options.rules) {
        return listRules();
    }
    if (options.machines) {
        return listProfiles(library);
    }
    if (options.files.empty()) {
        fmt::print(stderr, "check: name at least one machine file\n");
        return kUnusable;
    }
    if (!options.report.empty() && options.files.size() != 1) {
        fmt::print(stderr, "check: --report is about one machine file\n");
        return kUnusable;
    }
    std::vector<Waiver> waivers;
    for (const std::string& text : options.off) {
        auto waiver = machine::parseWaiver(text);
        if (!waiver) {
            print(waiver.diagnostics());
            return kUnusable;
        }
        waivers.push_back(std::move(waiver).value());
    }
    std::vector<CheckedFile> checked;
    int code = kFine;
    for (const std::string& file : options.files) {
        auto outcome = checkFile(file, options, library, waivers);
        if (!outcome) {
            return kUnusable;
        }
        const int own = !outcome->readable                            ? kUnusable
                        : hasErrors(outcome->checked.result.findings) ? kProblems
                                                                      : kFine;
        code = std::max(code, own);
        if (!options.report.empty() && !writeReport(*outcome, options.report)) {
            return kUnusable;
        }
        checked.push_back(std::move(outcome->checked));
    }
    if (options.format == "json") {
        fmt::print("{}", machine::toJson(checked));
    } else if (options.format == "sarif") {
        fmt::print("{}", machine::toSarif(checked, KNITTSIM_VERSION));
    } else {
        for (const CheckedFile& file : checked) {
            fmt::print("{}", machine::toText(file));
        }
    }
    return code;
}

} // namespace

void addCheck(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command = app.add_subcommand("check", "Find what will go wrong on the machine");
    command->add_option("files", options->files, "machine files");
    command->add_option("--machine", options->machine,
                        "ID of the machine; else what ';;Machine:' of the file names");
    command
        ->add_option("--off", options->off,
                     "RULE=REASON: this rule (id or name) does not count; the reason is kept in the output")
        ->allow_extra_args(false);
    command->add_option("--format", options->format, "text, json or sarif (2.1.0)")
        ->check(CLI::IsMember({"text", "json", "sarif"}))
        ->capture_default_str();
    command->add_option("--report", options->report, "also write a report of one file: OUT.html or OUT.json");
    command->add_flag("--rules", options->rules, "list the rules");
    command->add_flag("--machines", options->machines, "list the machines");
    command->callback([&chosen, options] { chosen = [options] { return runCheck(*options); }; });
}

} // namespace knittsim::cli
