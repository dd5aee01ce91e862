#pragma once

#include "ui/render/camera.h"

#include <QByteArray>

#include <optional>

namespace knittsim::ui {

QByteArray toBytes(const render::CameraState& state);

/// Nothing for bytes that toBytes() did not make.
std::optional<render::CameraState> cameraFromBytes(const QByteArray& bytes);

} // namespace knittsim::ui
