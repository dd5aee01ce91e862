#pragma once

#include "core/base/progress.h"
#include "core/pattern/chart.h"

#include <optional>
#include <string>
#include <vector>

/// Pictures to colour patterns.
namespace knittsim::pattern {

struct Picture {
    int width = 0; ///< pixels; at least 1, as the height
    int height = 0;
    std::vector<std::uint8_t> rgb; ///< three bytes (sRGB) a pixel, row after row from the top
};

struct PictureOptions {
    int wales = 1;
    int courses = 1;
    std::vector<yarn::Colour> colours =
        {}; ///< of the yarns to use; empty: the `count` that fit the picture best
    int count = 2;
    /// Spreads the error of each cell over its neighbours (Floyd and Steinberg, 1976), so that areas have the
    /// right brightness from afar; else each cell gets the nearest colour.
    bool dither = false;

    bool operator==(const PictureOptions&) const = default;
};

/// A yarn for each stitch.
struct PictureCells {
    int wales = 0;
    int courses = 0;
    std::vector<yarn::Colour> colours;
    std::vector<std::uint8_t> yarns; ///< into colours, course after course from the bottom
};

/// Courses for a picture so that circles stay round: a stitch is `stitchAspect` times as high as wide.
/// 1..kMaxCourses.
int coursesFor(const Picture& picture, int wales, double stitchAspect);

/// Each cell has the mean light of its part of the picture; colours are compared in OKLab (Ottosson, 2020),
/// where distances are as people see them, and found by k-means from a split along the widest axis. The same
/// picture gives the same cells; colours that are found stand by rising rareness. Nothing when cancelled.
std::optional<PictureCells> reducePicture(const Picture& picture, const PictureOptions& options,
                                          const Progress& progress = {});

/// All plain, a yarn for each colour on the carriers in turn; there must be as many.
Chart chartOf(const PictureCells& cells, const std::vector<std::string>& carriers, ColourMethod method);

} // namespace knittsim::pattern
