#pragma once

#include "core/base/vec3.h"
#include "core/fabric/fabric.h"

#include <span>
#include <vector>

namespace knittsim::geometry {

/// The fabric's own directions at every entry of the bonding point table, so that curves keep their shape
/// when the fabric bends in space. Built once for a fabric; update() is linear and allocates nothing after
/// the first call.
class FrameField {
public:
    explicit FrameField(const fabric::Fabric& fabric);

    /// `positions`: 3 per entry, mm. Entries that coincide or are not finite get the axes of space.
    void update(std::span<const float> positions);

    /// As update(), and also relief(). Costs a few sweeps more.
    void updateWithRelief(std::span<const float> positions);

    /// By entry, mm; zero where the given ones were not finite.
    const std::vector<Vec3f>& position() const { return m_position; }

    // By entry. across: unit, from left to right; along: unit, from feet to heads; normal: across x along.
    const std::vector<Vec3f>& across() const { return m_across; }
    const std::vector<Vec3f>& along() const { return m_along; }
    const std::vector<Vec3f>& normal() const { return m_normal; }

    /// mm between the left and the right entry of the loops here.
    const std::vector<float>& chord() const { return m_chord; }

    /// mm between feet and heads of the loops here.
    const std::vector<float>& rise() const { return m_rise; }

    /// Height of an entry over the smoothed surface of the fabric around it, mm along its normal.
    const std::vector<float>& relief() const { return m_relief; }

private:
    /// Entries of the corners of a loop, -1 for feet that it does not have.
    struct Corners {
        fabric::EntryIndex footLeft, headLeft, headRight, footRight;
    };
    struct Neighbours {
        fabric::EntryIndex entry, before, after;
    };

    void addLoop(const Corners& corners);
    void finishEntry(std::size_t entry);
    void copyToCrossings();
    void smooth();

    std::vector<Corners> m_loops;
    std::vector<Neighbours> m_crossings; ///< crossings take the mean frame of the corners beside them
    std::vector<std::pair<fabric::EntryIndex, fabric::EntryIndex>> m_links; ///< neighbours along a yarn
    std::vector<float> m_linkCount;                                         ///< by entry
    std::vector<Vec3f> m_position, m_across, m_along, m_normal, m_smooth, m_sum;
    std::vector<float> m_chord, m_rise, m_relief, m_chordWeight, m_riseWeight;
};

} // namespace knittsim::geometry
