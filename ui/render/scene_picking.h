#pragma once

#include "core/geometry/picking.h"
#include "ui/render/fabric_scene.h"
#include "ui/render/section.h"

#include <optional>

namespace knittsim::render {

/// The first yarn of a frame that a ray meets and that no section cuts away, or nothing. `tolerance` mm is
/// added to every radius. Looks only at the pieces of yarn near the ray: quick enough for every move of the
/// mouse.
std::optional<geometry::Pick> pickScene(const SceneFrame& frame, const fabric::Fabric& fabric,
                                        const geometry::Ray& ray, float tolerance,
                                        const std::optional<Section>& section = {});

} // namespace knittsim::render
