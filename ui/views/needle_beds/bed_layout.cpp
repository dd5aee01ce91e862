#include "ui/views/needle_beds/bed_layout.h"

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

using machine::Bed;

namespace {

constexpr double kBedShare = 0.27; ///< of the height without the lines of text

double bare(const BedLayout& layout) {
    return std::max(20.0, layout.area.height() - 3.9 * layout.textHeight);
}

} // namespace

double BedLayout::xOf(double pitches) const {
    return area.center().x() + (pitches - centre) * pitch;
}

double BedLayout::pitchesAt(double x) const {
    return centre + (x - area.center().x()) / pitch;
}

machine::BedWindow BedLayout::window() const {
    return {pitchesAt(area.left()) - 1, pitchesAt(area.right()) + 1};
}

double BedLayout::bedHeight() const {
    return kBedShare * bare(*this);
}

double BedLayout::gap() const {
    return (1 - 2 * kBedShare) * bare(*this);
}

double BedLayout::rearNumbersY() const {
    return area.top() + 1.4 * textHeight;
}

double BedLayout::frontNumbersY() const {
    return area.bottom() - 1.2 * textHeight;
}

double BedLayout::vergeY(Bed bed) const {
    return machine::isFront(bed) ? frontNumbersY() - bedHeight() : frontNumbersY() - bedHeight() - gap();
}

double BedLayout::gapCentreY() const {
    return 0.5 * (vergeY(Bed::Front) + vergeY(Bed::Rear));
}

QPointF BedLayout::at(Bed bed, double pitches, double u) const {
    return {xOf(pitches), vergeY(bed) + (machine::isFront(bed) ? -u : u)};
}

double BedLayout::yarnWidth() const {
    return std::clamp(std::min(0.16 * pitch, 0.045 * gap()), 1.6, 12.0);
}

machine::Needle BedLayout::needleAt(QPointF point, double rack) const {
    const bool rear = point.y() < gapCentreY();
    const double at = pitchesAt(point.x()) - (rear ? rack : 0);
    return {rear ? Bed::Rear : Bed::Front, static_cast<std::int32_t>(std::lround(at))};
}

} // namespace knittsim::ui
