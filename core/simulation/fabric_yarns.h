#pragma once

#include "core/fabric/fabric.h"
#include "core/geometry/measure.h"
#include "core/geometry/yarn_curve.h"
#include "core/physics/yarn_model/chains.h"
#include "core/physics/yarn_model/yarn_units.h"

#include <functional>
#include <span>
#include <vector>

namespace knittsim::simulation {

/// All yarns of a fabric as chains of the yarn model, and the way back from nodes to loops.
struct FabricYarns {
    physics::YarnChains chains;            ///< one chain a yarn; lengths in `units`, yarns by carrier
    physics::YarnUnits units;              ///< those of the yarn of which there is most
    std::vector<double> weightOfYarn;      ///< by carrier, as chains.yarns: of a length of yarn, EI/d^3
    std::vector<fabric::PointIndex> point; ///< by node: bonding point at or before it
    std::vector<fabric::PointIndex>
        piece; ///< by node: bonding point whose leg, float or half sinker it is on
    std::vector<physics::Entry> nodeOfPoint; ///< by bonding point: the node nearest to it along the yarn, -1
    std::vector<machine::CarrierIndex> carrier; ///< by chain

    std::vector<physics::Entry> onHolder; ///< heads of live loops, on the stitch holder
    std::vector<physics::Entry> onComb;   ///< loops of the cast-on
    /// The first and the last loop of a yarn are closed, as a slip knot closes them.
    struct Knot {
        physics::Entry end = 0;
        physics::Entry at = 0;
        double length = 0; ///< between them, d
    };
    std::vector<Knot> knots;
};

/// Gives a carrier another yarn; nodes and fed lengths stay. Carriers without yarn are ignored.
void setYarn(FabricYarns& yarns, machine::CarrierIndex carrier, const yarn::Yarn& yarn);

/// How the yarns are laid out at first.
struct YarnLayout {
    int nodesPerLoop = 18;
    /// To start from; 0: those of the fabric's repeat, or of the bonding-point model at rest.
    double waleSpacingMm = 0;
    double courseSpacingMm = 0;
    /// Laid and grown so many times as wide and high as that; settling begins at the spacings themselves,
    /// where the machine's pull has left the fabric.
    double wider = 1;
    double higher = 1;
    /// Asked at least every 20 ms of settling for these spacings; once true, the layout is of no use.
    const std::function<bool()>* cancelled = nullptr;
};

/// The exact curves of the machine's shape, drawn in to the given spacings: one stretch along each axis of
/// space, so every strand stays on its side of every other one. The third axis is stretched such that the
/// curves are as long as the yarn that the machine fed. Nodes lie evenly along each yarn, with more where the
/// curve bends away from them and where the chains would lose a crossing of the fabric. `yarns` by carrier;
/// carriers beyond its end get a default yarn.
FabricYarns layYarns(const fabric::Fabric& fabric, std::span<const yarn::Yarn> yarns,
                     const YarnLayout& layout = {});

/// The same curves, drawn in to what plain knit has: something to look at before the spacings are known.
FabricYarns guessYarns(const fabric::Fabric& fabric, std::span<const yarn::Yarn> yarns);

/// The same yarns at x with every second node left out, but those to be `kept` (by node; empty: none).
FabricYarns withHalfTheNodes(const fabric::Fabric& fabric, const FabricYarns& yarns, const physics::Vector& x,
                             const std::vector<char>& kept = {});

/// The chains at x as curves in mm, for drawing and for the proofs of core/geometry; their surface is that of
/// a table.
geometry::YarnCurves curvesOf(const FabricYarns& yarns, const physics::Vector& x);

/// 3 per entry of the bonding point table, mm: where the strands that meet there are on average.
std::vector<float> entryPositions(const fabric::Fabric& fabric, const FabricYarns& yarns,
                                  const physics::Vector& x);

} // namespace knittsim::simulation
