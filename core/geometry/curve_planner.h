#pragma once

#include "core/geometry/yarn_stations.h"

namespace knittsim::geometry {

/// Fills a CurvePlan: walks along every yarn and decides which control points it gets.
class CurvePlanner {
public:
    CurvePlanner(const fabric::Fabric& fabric, std::span<const double> diameterMm, CurvePlan& plan);

    void run();

private:
    static std::vector<double> roomFor(const fabric::Fabric& fabric, std::span<const double> diameterMm);
    const fabric::BondingPoint& point(fabric::PointIndex p) const {
        return m_fabric.points[static_cast<std::size_t>(p)];
    }
    float stored(const Station& a) const {
        return static_cast<float>(m_fabric.lengths[static_cast<std::size_t>(a.point)]);
    }

    std::int32_t newControl(const Station& owner, const Station& piece);
    void addEnd();
    void addYarn(const fabric::Yarn& yarn);
    void addTail(const Station& at);
    void addStation(const Station& at);
    void addCorner(const Station& at, bool atUpper);
    void connect(const Station& a, const Station& b);
    void addHeadArc(const Station& a, const Station& b);
    void addLeg(const Station& a, const Station& b);
    void addSinker(const Station& a, const Station& b);
    void addTurn(const Station& a, const Station& b);
    void fitTurn(const Station& owner);
    float waitOut(const Station& a, const Station& b) const;
    void addTurnControl(const Station& near, const Station& owner, float across, float down);
    void addFloat(const Station& a, const Station& b);
    void addWrap(const Station& a, const Station& b);
    void addReach(const Station& near, const Station& far, const Station& owner, float out);

    const fabric::Fabric& m_fabric;
    std::vector<double> m_diameterMm; ///< by carrier, see roomFor()
    CurvePlan& m_plan;
    YarnStations m_stations;
    float m_diameter = 0.3F; ///< of the yarn at hand
};

} // namespace knittsim::geometry
