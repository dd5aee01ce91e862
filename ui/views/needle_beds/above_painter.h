#pragma once

#include "ui/views/needle_beds/bed_layout.h"
#include "ui/views/needle_beds/bed_scene.h"

#include <QPainterPath>

#include <unordered_map>

namespace knittsim::ui {

/// Draws the beds as seen from above.
class AbovePainter {
public:
    AbovePainter(QPainter& painter, const BedLayout& layout, const BedScene& scene);

    void paint();

private:
    /// A loop on a needle: a U around it whose legs hang into the gap.
    struct LoopForm {
        machine::Bed bed = machine::Bed::Front;
        double pitches = 0;
        double crossing = 0; ///< where it crosses its needle, pixels from the verge
        double legs = 0;     ///< where its legs end
        double halfWidth = 0;
        machine::CarrierIndex carrier = 0;
        double drawn = 1;
        bool flies = false; ///< between two needles: a ring around both
    };

    void placeLoops();
    void placeFlight();
    void paintBeds();
    void paintCarriage();
    void paintRails();
    void paintLinks();
    void paintNeedle(const machine::SeenNeedle& needle);
    void paintHook(const machine::SeenNeedle& needle);
    void paintLoop(machine::LoopIndex loop, const LoopForm& form);
    void paintNumbers(machine::Bed bed);
    void paintCounts();
    void paintCarriers();
    void paintCarrier(const machine::SeenCarrier& carrier);
    void paintSlider(const machine::SeenNeedle& slider);
    double tipOf(const machine::SeenNeedle& needle) const;
    double railY(int rail) const;
    QPointF footOf(const machine::YarnEnd& end, bool leaving) const;
    QPainterPath strand(QPointF from, QPointF to) const;

    QPainter& m_painter;
    const BedLayout& m_layout;
    const BedScene& m_scene;
    BedColours m_colours;
    std::vector<int> m_rails; ///< in use, front to rear
    std::unordered_map<machine::LoopIndex, LoopForm> m_loops;
};

} // namespace knittsim::ui
