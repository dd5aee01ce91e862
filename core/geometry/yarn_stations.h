#pragma once

#include "core/fabric/wale_places.h"
#include "core/geometry/curve_plan.h"
#include "core/geometry/strand_order.h"

#include <vector>

namespace knittsim::geometry {

/// What a yarn runs through: bonding points, and the bases of legs that have no foot.
struct Station {
    fabric::PointIndex point = -1; ///< at or before it
    fabric::PointIndex self = -1;  ///< the same, but for a base the one next to it on its leg
    machine::LoopIndex loop = -1;
    fabric::Side side = fabric::Side::Left;
    enum class Kind : std::uint8_t { Foot, Base, Head, OnLeg, OnFloat } kind = Kind::Foot;
    CurvePlan::Anchor anchor;
    bool incoming = true; ///< before the middle of its loop
    float lower = 0;      ///< depth of the strand, see StrandDepth
    float upper = 0;

    bool isCrossing() const { return kind == Kind::OnLeg || kind == Kind::OnFloat; }
};

/// -1 on the left, +1 on the right.
float sideSign(fabric::Side side);

/// Finds the stations of a yarn, and says how two that follow each other lie on the machine.
class YarnStations {
public:
    /// `diameterMm` by carrier. The fabric must outlive it.
    YarnStations(const fabric::Fabric& fabric, const std::vector<double>& diameterMm);

    /// Of `yarn`, laid as if it were `diameterMm` thick. Valid until the next call.
    const std::vector<Station>& collect(const fabric::Yarn& yarn, float diameterMm);

    /// By loop, see passLevels().
    const std::vector<float>& levels() const { return m_levels; }

    /// Courses from one to the other, upwards or downwards.
    double coursesBetween(const Station& a, const Station& b) const;
    bool isFarAcross(const Station& a, const Station& b) const;
    bool isSteep(const Station& a, const Station& b) const;
    bool isTall(const Station& a, const Station& b) const;
    bool isStraightUp(const Station& a, const Station& b) const;
    bool isInside(const Station& leg, const Station& from) const;
    bool isKink(const Station& a, const Station& b) const;
    bool isWrap(const Station& a, const Station& b) const;
    bool isBesideFloat(const Station& foot, const Station& crossing) const;

private:
    Station stationAt(fabric::PointIndex p) const;
    Station baseOf(const Station& onLeg, fabric::PointIndex owner) const;
    fabric::EntryIndex footBeside(machine::LoopIndex of, bool before) const;
    double outward(const Station& leg, const Station& to) const;
    const fabric::BondingPoint& other(const Station& at) const;

    const fabric::BondingPoint& point(fabric::PointIndex p) const {
        return m_fabric.points[static_cast<std::size_t>(p)];
    }
    const fabric::Loop& loop(machine::LoopIndex l) const {
        return m_fabric.loops[static_cast<std::size_t>(l)];
    }
    const Vec3& placeOf(fabric::EntryIndex entry) const {
        return m_fabric.machinePositions[static_cast<std::size_t>(entry)];
    }
    const Vec3& placeOf(const Station& station) const { return placeOf(station.anchor.entry); }

    const fabric::Fabric& m_fabric;
    std::vector<StrandDepth> m_depths;
    std::vector<float> m_levels;
    std::vector<fabric::WalePlace> m_wales; ///< by loop, where the yarn was laid
    std::vector<Station> m_stations;
    fabric::PointIndex m_yarnFirst = 0; ///< of the yarn at hand
    fabric::PointIndex m_yarnEnd = 0;
    float m_diameter = 0.3F;
};

} // namespace knittsim::geometry
