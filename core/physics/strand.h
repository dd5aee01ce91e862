#pragma once

#include "core/fabric/fabric.h"

#include <cstdint>
#include <vector>

namespace knittsim::physics {

/// Straight distance over yarn length of the curved pieces of a relaxed plain loop. A bonding point lies
/// where the arcs are curved, so the distance is well below the yarn length. With the shares of fabric.h they
/// give a wale spacing of 2 * 0.445 * 0.281 l = l / 4.0 and a course spacing of 0.866 * 0.219 l = l / 5.27
/// (PHYSICS-REFERENCE 3.7 and 3.1: kw 3.8 to 4.2, kc 5.0 to 5.5).
constexpr double kArcChord = 0.445; ///< heads and sinkers: more than a half circle
constexpr double kLegChord = 0.866;

/// A face changes where a stitch of one bed stands above a stitch of the other. The leg then runs from one
/// face of the fabric to the other and stands out of its plane: its height shrinks. Both ends changed: garter
/// is 0.64 to 0.70 (rods) or 0.76 (swatches) as high as plain (PHYSICS-REFERENCE 3.3, PHYSICS 3). One end:
/// half the turn of an arc whose full turn gives 0.72.
constexpr double kLegOneFaceChange = 0.925;
constexpr double kLegTwoFaceChanges = 0.72;

/// Yarn between two feet or heads that follow each other along a yarn, with any crossings between them.
struct Strand {
    enum class Kind : std::uint8_t {
        Head,   ///< over the heads of one loop
        Leg,    ///< from a foot to the head above it
        Sinker, ///< between the feet of loops on neighbouring needles of one course; pushes too
        Float,  ///< any other way to the next loop; hangs slack when too long
    };
    Kind kind = Kind::Float;
    fabric::PointIndex first = 0; ///< points first .. last, the inner ones are crossings
    fabric::PointIndex last = 0;
    machine::CarrierIndex carrier = 0;
    double length = 0; ///< mm of yarn
    double arc = 0;    ///< mm of it that is bent like a plain loop's arc
    double rest = 0;   ///< mm, straight distance at rest

    bool pushes() const { return kind != Kind::Float; }
};

/// Strands of a fabric, and for every point the strand that ends and that begins there (-1 at the ends of a
/// yarn). Crossings have -1 in both.
struct Strands {
    std::vector<Strand> all;
    std::vector<std::int32_t> endingAt;
    std::vector<std::int32_t> beginningAt;

    /// The strand at a foot or head that is a leg, or that is not; -1 where there is none.
    std::int32_t legAt(fabric::PointIndex point) const;
    std::int32_t otherAt(fabric::PointIndex point) const;

    /// The other end of a strand.
    fabric::PointIndex across(std::int32_t strand, fabric::PointIndex point) const;
};

/// Linear in the number of points.
Strands findStrands(const fabric::Fabric& fabric);

/// The loop above, whose foot shares this head's entry; -1 at a loop that nothing was drawn through.
fabric::LoopIndex loopThrough(const fabric::Fabric& fabric, fabric::PointIndex head);

/// The loop below, whose head shares this foot's entry; -1 where there is none.
fabric::LoopIndex loopUnder(const fabric::Fabric& fabric, fabric::PointIndex foot);

/// +1 for a stitch drawn to the front (made on the front bed), -1 for one drawn to the rear.
int faceOf(const fabric::Fabric& fabric, fabric::LoopIndex loop);

} // namespace knittsim::physics
