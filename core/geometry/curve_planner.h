#pragma once

#include "core/fabric/wale_places.h"
#include "core/geometry/curve_plan.h"

namespace knittsim::geometry {

/// Fills a CurvePlan: walks along every yarn and decides which control points it gets.
class CurvePlanner {
public:
    CurvePlanner(const fabric::Fabric& fabric, std::span<const double> diameterMm, CurvePlan& plan);

    void run();

private:
    using Anchor = CurvePlan::Anchor;

    /// What a yarn runs through: bonding points, and the bases of legs that have no foot.
    struct Station {
        fabric::PointIndex point = -1; ///< at or before it
        fabric::PointIndex self = -1;  ///< the same, but for a base the one next to it on its leg
        machine::LoopIndex loop = -1;
        fabric::Side side = fabric::Side::Left;
        enum class Kind : std::uint8_t { Foot, Base, Head, OnLeg, OnFloat } kind = Kind::Foot;
        Anchor anchor;
        bool incoming = true; ///< before the middle of its loop
        float lower = 0;      ///< depth of the strand, see StrandDepth
        float upper = 0;

        bool isCrossing() const { return kind == Kind::OnLeg || kind == Kind::OnFloat; }
        bool beginsLeg() const { return kind == Kind::Foot || kind == Kind::Base; }
    };

    static std::vector<double> roomFor(const fabric::Fabric& fabric, std::span<const double> diameterMm);
    void collectStations(const fabric::Yarn& yarn);
    Station stationAt(fabric::PointIndex p) const;
    Station baseOf(const Station& onLeg, fabric::PointIndex owner) const;
    fabric::EntryIndex footBeside(machine::LoopIndex of, bool before) const;

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
    bool isFarAcross(const Station& a, const Station& b) const;
    bool isSteep(const Station& a, const Station& b) const;
    bool isTall(const Station& a, const Station& b) const;
    static bool isTurn(const Station& a, const Station& b);
    bool isInside(const Station& leg, const Station& from) const;
    bool isKink(const Station& a, const Station& b) const;
    bool isWrap(const Station& a, const Station& b) const;
    const fabric::BondingPoint& other(const Station& at) const;
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
    bool isBesideFloat(const Station& foot, const Station& crossing) const;
    void addReach(const Station& near, const Station& far, const Station& owner, float out);

    const fabric::Fabric& m_fabric;
    std::vector<double> m_diameterMm; ///< by carrier, see roomFor()
    CurvePlan& m_plan;
    std::vector<StrandDepth> m_depths;
    std::vector<float> m_levels;            ///< by loop, see passLevels()
    std::vector<fabric::WalePlace> m_wales; ///< by loop, where the yarn was laid
    std::vector<Station> m_stations;
    fabric::PointIndex m_yarnFirst = 0; ///< of the yarn at hand
    fabric::PointIndex m_yarnEnd = 0;
    float m_diameter = 0.3F; ///< of the yarn at hand
};

} // namespace knittsim::geometry
