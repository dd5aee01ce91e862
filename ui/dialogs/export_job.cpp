#include "ui/dialogs/export_job.h"

#include "core/base/file.h"
#include "core/export/write_shape.h"
#include "ui/render/offscreen.h"
#include "ui/render/picture_sequence.h"

#include <cmath>

namespace knittsim::ui {

namespace {

/// The part of the whole from `from` to `to`.
Progress partOf(const Progress& progress, double from, double to) {
    return [&progress, from, to](double share) { return !progress || progress(from + share * (to - from)); };
}

/// All but the shape.
render::RenderRequest requestFor(const ExportJob& job) {
    render::RenderRequest request;
    request.fabric = job.source.fabric.get();
    request.style = job.source.style;
    for (const yarn::Yarn& yarn : job.source.yarns) {
        request.looks.push_back(render::lookOf(yarn));
    }
    switch (job.side) {
    case ExportJob::Side::AsSeen:
        request.camera = job.source.camera;
        break;
    case ExportJob::Side::Face:
        request.side = render::ViewSide::Front;
        break;
    case ExportJob::Side::Back:
        request.side = render::ViewSide::Back;
        break;
    }
    request.section = job.source.section;
    request.keep = job.source.keep;
    request.width = job.width;
    request.height = job.height;
    request.hair = job.source.hair;
    request.level = job.source.level;
    request.dark = job.source.dark;
    request.transparent = job.transparent;
    return request;
}

Result<Written> writePicture(const ExportJob& job, const Progress& progress) {
    constexpr double kDrawn = 0.6;
    render::RenderRequest request = requestFor(job);
    request.positions = job.source.places;
    request.curves = request.style != render::DrawStyle::Mesh ? job.source.curves.get() : nullptr;
    request.progress = partOf(progress, 0, kDrawn);
    const auto image = render::renderFabric(request);
    if (!image) {
        return Result<Written>::failure(image.diagnostics());
    }
    return render::writePng(job.path, image.value(), partOf(progress, kDrawn, 1));
}

Result<Written> writeFrames(const ExportJob& job, const Progress& progress) {
    constexpr double kSettled = 0.3;
    constexpr double kMostSeconds = 120;
    const simulation::RecordOptions options{.yarn = job.source.curves != nullptr,
                                            .surroundings = job.source.surroundings,
                                            .maxSeconds = kMostSeconds};
    const auto shapes = simulation::recordSettling(job.source.fabric, job.source.yarns, options,
                                                   partOf(progress, 0, kSettled));
    if (!shapes) {
        return Result<Written>::failure(shapes.diagnostics());
    }
    return render::writeSequence(job.path, requestFor(job), shapes.value(), partOf(progress, kSettled, 1));
}

Result<Written> writeGeometry(const ExportJob& job, const Progress& progress) {
    constexpr double kShaped = 0.2;
    const ExportSource& source = job.source;
    std::optional<exports::Shape> shape;
    if (source.curves) {
        shape = exports::shapeOf(source.fabric, source.yarns, *source.curves, source.places);
    } else {
        shape = exports::shapeAt(source.fabric, source.yarns, source.places, partOf(progress, 0, kShaped));
    }
    if (!shape) {
        return Diagnostic{.id = "KS0009", .place = {.file = job.path.string()}, .arguments = {}};
    }
    shape = exports::partOf(std::move(*shape), source.keep);
    const bool seenFromBehind = std::cos(source.camera.yaw) < 0;
    const bool back =
        job.side == ExportJob::Side::Back || (job.side == ExportJob::Side::AsSeen && seenFromBehind);
    return exports::writeShape(job.path, *shape, {.back = back}, partOf(progress, kShaped, 1));
}

} // namespace

bool isPicture(const std::filesystem::path& path) {
    return lowerExtension(path) == ".png";
}

bool isSequence(const std::filesystem::path& path) {
    return lowerExtension(path) == ".frames";
}

Result<Written> writeExport(const ExportJob& job, const Progress& progress) {
    return isPicture(job.path)    ? writePicture(job, progress)
           : isSequence(job.path) ? writeFrames(job, progress)
                                  : writeGeometry(job, progress);
}

} // namespace knittsim::ui
