#pragma once

#include <CLI/App.hpp>

#include <functional>

namespace knittsim::cli {

/// Exit codes of all commands.
constexpr int kFine = 0;
constexpr int kProblems = 1; ///< the work was done and something is wrong
constexpr int kUnusable = 2; ///< cannot read, cannot write, bad usage

/// Each adds its subcommand to `app`; the command, when chosen, is put into `chosen` and returns the exit
/// code.
using Command = std::function<int()>;
void addCheck(CLI::App& app, Command& chosen);
void addConvert(CLI::App& app, Command& chosen);
void addExport(CLI::App& app, Command& chosen);
void addInfo(CLI::App& app, Command& chosen);
void addPull(CLI::App& app, Command& chosen);
void addRelax(CLI::App& app, Command& chosen);
void addRender(CLI::App& app, Command& chosen);

} // namespace knittsim::cli
