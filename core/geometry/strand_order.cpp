#include "core/geometry/strand_order.h"

#include "core/fabric/depth_order.h"

#include <algorithm>
#include <array>

namespace knittsim::geometry {

using fabric::BondingPoint;
using fabric::EntryIndex;
using fabric::Fabric;
using fabric::PointIndex;
using fabric::Role;

int pullSign(const Fabric& fabric, machine::LoopIndex loop) {
    return machine::isFront(fabric.made.loops[static_cast<std::size_t>(loop)].needle.bed) ? 1 : -1;
}

namespace {

/// Stacks are squeezed: their strands give way sideways as well.
float gapFactor(std::size_t strands) {
    constexpr std::array kFactors{1.0F, 1.0F, 1.0F, 0.8F, 0.65F};
    return kFactors[std::min(strands, kFactors.size() - 1)];
}

class Orderer {
public:
    Orderer(const Fabric& fabric, std::span<const double> diameterMm)
        : m_fabric(fabric), m_diameterMm(diameterMm), m_depths(fabric.points.size()) {}

    std::vector<StrandDepth> run() {
        for (EntryIndex entry = 0; entry < m_fabric.entryCount; ++entry) {
            const auto points = m_fabric.at(entry);
            if (!points.empty() && point(points[0]).role == Role::Crossing) {
                orderCrossing(entry);
            } else {
                orderBonding(entry);
            }
        }
        return std::move(m_depths);
    }

private:
    const BondingPoint& point(PointIndex p) const { return m_fabric.points[static_cast<std::size_t>(p)]; }

    float diameter(PointIndex p) const {
        const auto carrier = m_fabric.made.loops[static_cast<std::size_t>(point(p).loop)].carrier;
        return carrier < m_diameterMm.size() ? static_cast<float>(m_diameterMm[carrier]) : 0.3F;
    }

    void orderBonding(EntryIndex entry) {
        for (const auto level : {fabric::ClaspLevel::Lower, fabric::ClaspLevel::Upper}) {
            fabric::orderInDepth(m_fabric, entry, level, m_row);
            spread(level == fabric::ClaspLevel::Upper);
        }
    }

    void orderCrossing(EntryIndex entry) {
        const auto points = m_fabric.at(entry);
        m_row.assign(points.begin(), points.end());
        std::ranges::sort(m_row, {}, [&](PointIndex p) { return point(p).front; });
        spread(false);
        spread(true);
    }

    /// Lays the strands of m_row side by side in depth, back to front, about zero.
    void spread(bool upper) {
        const float factor = gapFactor(m_row.size());
        float depth = 0;
        for (std::size_t i = 0; i < m_row.size(); ++i) {
            depth += i > 0 ? factor * 0.5F * (diameter(m_row[i - 1]) + diameter(m_row[i])) : 0;
            set(m_row[i], upper, depth);
        }
        for (const PointIndex p : m_row) {
            auto& d = m_depths[static_cast<std::size_t>(p)];
            set(p, upper, (upper ? d.upper : d.lower) - 0.5F * depth);
        }
    }

    void set(PointIndex p, bool upper, float depth) {
        auto& d = m_depths[static_cast<std::size_t>(p)];
        (upper ? d.upper : d.lower) = depth;
    }

    const Fabric& m_fabric;
    std::span<const double> m_diameterMm;
    std::vector<StrandDepth> m_depths;
    std::vector<PointIndex> m_row;
};

} // namespace

std::vector<StrandDepth> orderStrands(const Fabric& fabric, std::span<const double> diameterMm) {
    return Orderer(fabric, diameterMm).run();
}

} // namespace knittsim::geometry
