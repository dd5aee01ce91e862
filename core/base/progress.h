#pragma once

#include <functional>

namespace knittsim {

/// How far long work has come, 0 to 1; the caller answers false to end it. May be empty. Called at least
/// every few hundredths of a second, on the thread that works.
using Progress = std::function<bool(double share)>;

} // namespace knittsim
