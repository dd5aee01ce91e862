#include "core/geometry/strand_order.h"

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
            collect(entry);
            if (m_crossing.empty()) {
                orderBonding();
            } else {
                orderCrossing();
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

    void collect(EntryIndex entry) {
        m_heads.clear();
        m_feet.clear();
        m_crossing.clear();
        for (const PointIndex p : m_fabric.at(entry)) {
            switch (point(p).role) {
            case Role::Head:
                m_heads.push_back(p);
                break;
            case Role::Foot:
                m_feet.push_back(p);
                break;
            case Role::Crossing:
                m_crossing.push_back(p);
                break;
            }
        }
    }

    void orderBonding() {
        std::ranges::sort(m_feet, {}, [&](PointIndex p) { return point(p).loop; });
        // Yarns knitted together keep their order from the feet to the heads.
        if (!m_feet.empty() && pullSign(m_fabric, point(m_feet[0]).loop) > 0) {
            std::ranges::reverse(m_feet);
        }
        const int sign = m_feet.empty() ? bedSignOfHeads() : pullSign(m_fabric, point(m_feet[0]).loop);
        sortHeadsFromTheBack(sign);
        for (const bool upper : {false, true}) {
            m_row.clear();
            appendFeet(upper ? -1 : +1);
            m_row.insert(m_row.end(), m_heads.begin(), m_heads.end());
            appendFeet(upper ? +1 : -1);
            spread(upper);
        }
    }

    int bedSignOfHeads() const {
        if (m_heads.empty()) {
            return 1;
        }
        const fabric::Loop& loop = m_fabric.loops[static_cast<std::size_t>(point(m_heads[0]).loop)];
        return machine::isFront(loop.bound.bed) ? 1 : -1;
    }

    /// The loop deepest in the hook is the first of the stack and the one nearest to its bed.
    void sortHeadsFromTheBack(int sign) {
        const auto stack = m_feet.empty() ? std::span<const machine::LoopIndex>()
                                          : m_fabric.made.parentsOf(point(m_feet[0]).loop);
        const auto place = [&](PointIndex p) {
            const auto found = std::ranges::find(stack, point(p).loop);
            return found != stack.end() ? static_cast<int>(found - stack.begin()) : point(p).loop;
        };
        std::ranges::sort(m_heads,
                          [&](PointIndex a, PointIndex b) { return sign * place(a) > sign * place(b); });
    }

    void appendFeet(int sign) {
        for (const PointIndex p : m_feet) {
            if (pullSign(m_fabric, point(p).loop) == sign) {
                m_row.push_back(p);
            }
        }
    }

    void orderCrossing() {
        m_row = m_crossing;
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
    std::vector<PointIndex> m_heads, m_feet, m_crossing, m_row;
};

} // namespace

std::vector<StrandDepth> orderStrands(const Fabric& fabric, std::span<const double> diameterMm) {
    return Orderer(fabric, diameterMm).run();
}

} // namespace knittsim::geometry
