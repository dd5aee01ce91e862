#pragma once

#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/fabric/fabric.h"
#include "core/geometry/yarn_curve.h"
#include "core/simulation/surroundings.h"
#include "core/yarn/yarn.h"
#include "ui/render/camera.h"
#include "ui/render/look.h"
#include "ui/render/section.h"

#include <QString>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace knittsim::ui {

/// What is shown at the moment: what an export writes. Plain value.
struct ExportSource {
    std::shared_ptr<const fabric::Fabric> fabric;       ///< not null
    std::vector<float> places;                          ///< 3 per entry, mm; empty: as the machine leaves it
    std::shared_ptr<const geometry::YarnCurves> curves; ///< of the yarn model; null where there are none
    std::vector<yarn::Yarn> yarns;                      ///< by carrier
    simulation::Surroundings surroundings = simulation::Surroundings::Flat; ///< of the yarn model
    render::DrawStyle style = render::DrawStyle::Yarn;
    render::CameraState camera;
    std::optional<render::Section> section;
    std::vector<bool> keep; ///< by bonding point: what is written; empty: all
    QString parts;          ///< what that is, in words
    bool hair = true;       ///< see render::View
    std::optional<render::DetailLevel> level;
    bool dark = false;
};

struct ExportJob {
    enum class Side : std::uint8_t { AsSeen, Face, Back };

    ExportSource source;
    std::filesystem::path path; ///< its extension chooses the format: .png, .frames or one of core/export
    Side side = Side::AsSeen;   ///< pictures and drawings
    int width = 1920;           ///< of a picture, pixels
    int height = 1200;
    bool transparent = false; ///< picture without background
};

constexpr int kMostExportPixels = 8192;

/// Pictures have this format; all others are core/export's.
bool isPicture(const std::filesystem::path& path);

/// A folder with numbered pictures of the settling, from where the machine leaves the fabric.
bool isSequence(const std::filesystem::path& path);

/// Writes the file or folder; on any thread. Nothing is left of it when it fails or is cancelled.
Result<Written> writeExport(const ExportJob& job, const Progress& progress);

} // namespace knittsim::ui
