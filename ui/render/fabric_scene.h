#pragma once

#include "core/geometry/bounds.h"
#include "core/geometry/yarn_curve_builder.h"
#include "ui/render/colour_scale.h"
#include "ui/render/look.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace knittsim::render {

/// Yarns far away are drawn with every second or fourth node only.
constexpr int kMostStride = 4;

/// Loops of a fabric whose crossings are looked at: a round takes about 25 ms for 1000 loops.
constexpr std::size_t kMostOrdered = 5000;

/// What does not change while a fabric moves: for each node its carrier and bonding point, and where yarns
/// lie.
struct SceneTopology {
    std::vector<std::uint32_t> owner;               ///< by node: bonding point; anything between two yarns
    std::vector<geometry::YarnCurves::Range> yarns; ///< each begins at a multiple of kMostStride
    std::vector<machine::LoopIndex> loopOfPoint;
    std::size_t pointCount = 0;
};

/// A place of the bonding point table as the bare mesh shows it.
struct Marker {
    enum Kind : std::uint32_t {
        Bond,     ///< a foot in a head: a loop is drawn through here
        OpenHead, ///< nothing is drawn through yet
        Crossing, ///< two strands pass each other
    };
    std::array<float, 3> place{}; ///< mm
    std::uint32_t kind = Bond;
    std::array<float, 3> front{}; ///< Crossing: way of the strand in front (to a viewer of the front bed), mm
    std::array<float, 3> behind{}; ///< Crossing: way of the other one
};

/// A short piece of yarn, so that pieces outside the picture need not be drawn.
struct Chunk {
    std::int32_t firstNode = 0;
    std::int32_t count = 0;
    machine::CarrierIndex carrier = 0;
    Vec3f centre = Vec3f::Zero();
    float reach = 0; ///< mm from the centre to the farthest node
};

/// One shape of a fabric, ready for upload. Made on any thread, then immutable.
struct SceneFrame {
    std::shared_ptr<const SceneTopology> topology;
    std::vector<std::array<float, 4>> nodes; ///< x y z mm, arc length mm
    /// By node: a direction across the yarn (2 x 11 bits) with the height over the fabric (10 bits), and the
    /// fabric's normal (2 x 11 bits) with the share of the value in `range` (10 bits).
    std::vector<std::array<std::uint32_t, 2>> surface;
    std::vector<std::array<std::uint8_t, 4>> hidden; ///< by node: HiddenSky, the way first
    std::vector<Chunk> chunks;
    std::vector<Marker> markers; ///< Mesh only
    float segmentMm = 0;         ///< mean distance of neighbouring nodes
    geometry::Bounds bounds;     ///< of the yarn
    DrawStyle style = DrawStyle::Yarn;
    ValueRange range;             ///< of the values that the colours tell; empty: the yarns' own colours
    std::vector<float> diameters; ///< by carrier, mm, as the curves were made for
};

/// Turns positions into frames for one fabric, one set of diameters and one style. Pure; one thread at a
/// time.
class FabricScene {
public:
    /// `samples`: nodes between two control points of a curve.
    FabricScene(std::shared_ptr<const fabric::Fabric> fabric, std::span<const YarnLook> looks,
                DrawStyle style, int samples);

    /// With samplesFor() of the fabric.
    FabricScene(std::shared_ptr<const fabric::Fabric> fabric, std::span<const YarnLook> looks,
                DrawStyle style);

    /// `positions`: 3 per entry, mm; empty: where the machine leaves them. `values` by bonding point, for the
    /// yarn from there to the next one, are told by colours; of another number they are ignored.
    std::shared_ptr<const SceneFrame> prepare(std::span<const float> positions,
                                              std::span<const float> values = {});

    /// Curves that somebody else has made of this fabric, with normal and height; not for Mesh. `values`
    /// likewise, by node.
    std::shared_ptr<const SceneFrame> prepareCurves(const geometry::YarnCurves& curves,
                                                    std::span<const float> values = {});

    /// Looks once more at who lies in front at every crossing and mends what is wrong; to be called between
    /// frames, while there is time. Returns whether the next frame will differ. Does nothing for Mesh, for
    /// fabrics above kMostOrdered loops and once all is right.
    bool improve();

    /// Curves of the last frame, for picking. Not filled for Mesh.
    const geometry::YarnCurves& curves() const { return m_builder->curves(); }

private:
    static void layOut(SceneTopology& topology, std::span<const geometry::YarnCurves::Range> yarns,
                       std::span<const fabric::PointIndex> pointOfNode);
    std::shared_ptr<SceneFrame> emptyFrame() const;
    void fillCurves(SceneFrame& frame, const geometry::YarnCurves& curves) const;
    static void addValues(SceneFrame& frame, std::span<const float> values, bool byPoint);
    void fillMesh(SceneFrame& frame, std::span<const float> positions) const;
    void addMarkers(SceneFrame& frame, std::span<const float> positions) const;

    std::shared_ptr<const fabric::Fabric> m_fabric;
    DrawStyle m_style;
    std::vector<double> m_diameters;
    std::unique_ptr<geometry::YarnCurveBuilder> m_builder;
    std::shared_ptr<const SceneTopology> m_topology;
    std::vector<float> m_machinePositions;
    int m_roundsLeft = 0; ///< of improve()
};

/// Nodes between two control points: fewer for large fabrics, whose stitches are small on the screen.
int samplesFor(const fabric::Fabric& fabric);

} // namespace knittsim::render
