#pragma once

#include "core/geometry/curve_plan.h"

namespace knittsim::geometry {

/// Fills a CurvePlan: walks along every yarn and decides which control points it gets.
class CurvePlanner {
public:
    CurvePlanner(const fabric::Fabric& fabric, std::span<const double> diameterMm, CurvePlan& plan);

    void run();

private:
    const fabric::BondingPoint& point(fabric::PointIndex p) const {
        return m_fabric.points[static_cast<std::size_t>(p)];
    }
    float sideSign(fabric::PointIndex p) const { return point(p).side == fabric::Side::Right ? 1.0F : -1.0F; }
    bool isRising(fabric::PointIndex p) const;
    bool isOnLeg(fabric::PointIndex p) const;
    bool isFarAcross(fabric::PointIndex p, fabric::PointIndex q) const;
    bool isTurn(fabric::PointIndex p, fabric::PointIndex q) const;
    float lower(fabric::PointIndex p) const { return m_depths[static_cast<std::size_t>(p)].lower; }
    float upper(fabric::PointIndex p) const { return m_depths[static_cast<std::size_t>(p)].upper; }

    float stored(fabric::PointIndex p) const {
        return static_cast<float>(m_fabric.lengths[static_cast<std::size_t>(p)]);
    }

    std::int32_t newControl(fabric::PointIndex p);
    void addYarn(const fabric::Yarn& yarn);
    void addTail(fabric::PointIndex p);
    void addPoint(fabric::PointIndex p);
    void addCorner(fabric::PointIndex p, bool atUpper);
    void connect(fabric::PointIndex p, fabric::PointIndex q);
    void addHeadArc(fabric::PointIndex p, fabric::PointIndex q);
    void addLeg(fabric::PointIndex p, fabric::PointIndex q);
    void addSinker(fabric::PointIndex p, fabric::PointIndex q);
    void addTurn(fabric::PointIndex p, fabric::PointIndex q);
    void addFloat(fabric::PointIndex p, fabric::PointIndex q);
    void addReach(fabric::PointIndex near, fabric::PointIndex far, fabric::PointIndex owner, float out);

    const fabric::Fabric& m_fabric;
    std::span<const double> m_diameterMm;
    CurvePlan& m_plan;
    std::vector<StrandDepth> m_depths;
    float m_diameter = 0.3F; ///< of the yarn at hand
};

} // namespace knittsim::geometry
