#pragma once

#include "core/pattern/picture_chart.h"

#include <QString>

#include <functional>
#include <memory>
#include <utility>

namespace knittsim::ui {

/// The pixels of a picture file, on white where one can see through it; or null and the reason. `goesOn`
/// hears how much of the file is read, 0 to 1; once it answers false reading ends. Any thread.
std::pair<std::shared_ptr<const pattern::Picture>, QString>
readPictureFile(const QString& path, const std::function<bool(double)>& goesOn);

} // namespace knittsim::ui
