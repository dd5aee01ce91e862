#include "core/simulation/fabric_yarns.h"

#include "core/base/segment_distance.h"
#include "core/fabric/machine_shape.h"
#include "core/geometry/crossing_audit.h"
#include "core/geometry/yarn_curve_builder.h"
#include "core/simulation/start_spacings.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace knittsim::simulation {

namespace {

using fabric::Fabric;
using fabric::PointIndex;
using geometry::YarnCurves;
using physics::Entry;

constexpr int kSamples = 6;         ///< of the curve between two control points
constexpr double kLeastYarn = 0.3;  ///< of its share of the curve: spans with hardly any yarn
constexpr double kLeastDepth = 0.5; ///< stretch along the third axis
constexpr double kMostDepth = 4;
constexpr double kBulge = 0.05;        ///< diameters, of the curve beside the chain
constexpr double kFiner = 0.2;         ///< times as much where that has lost a crossing
constexpr double kShortest = 0.05;     ///< segments, between two nodes
constexpr double kUsualWale = 1 / 4.1; ///< of plain knit (PHYSICS 3), loop lengths
constexpr double kUsualCourse = 1 / 5.3;
constexpr double kGravity = 9.81e-6;                     ///< weight of 1 tex, mN/mm
constexpr double kClosedLoop = 1 - fabric::kSinkerShare; ///< of a loop length, between its two bases

/// Carrier whose yarn is the longest.
machine::CarrierIndex mostUsedCarrier(const Fabric& f) {
    const auto longest = std::ranges::max_element(f.yarns, {}, &fabric::Yarn::lengthMm);
    return longest == f.yarns.end() ? 0 : longest->carrier;
}

/// A curve with its yarn: arc length is mapped to fed yarn span by span.
class Laying {
public:
    Laying(const Fabric& f, YarnCurves curves, double segmentMm, double diameterMm)
        : m_fabric(f), m_curves(std::move(curves)), m_segmentMm(segmentMm), m_diameterMm(diameterMm),
          m_bulge(f.loops.size(), kBulge) {}

    const YarnCurves& curves() const { return m_curves; }

    double curveLength(const Eigen::Vector3d& stretch) const {
        double sum = 0;
        for (const YarnCurves::Range& yarn : m_curves.yarns) {
            for (std::int32_t n = yarn.first; n + 1 < yarn.first + yarn.count; ++n) {
                sum += (node(n + 1) - node(n)).cwiseProduct(stretch).norm();
            }
        }
        return sum;
    }

    void stretch(const Eigen::Vector3d& by) {
        for (Vec3f& p : m_curves.nodes) {
            p = p.cwiseProduct(by.cast<float>());
        }
    }

    void add(std::size_t yarn, FabricYarns& result) const;

    /// The chain is to keep nearer to the curve of a loop.
    void refine(machine::LoopIndex loop) {
        if (loop >= 0) {
            m_bulge[static_cast<std::size_t>(loop)] *= kFiner;
        }
    }

private:
    Eigen::Vector3d node(std::int32_t n) const {
        return m_curves.nodes[static_cast<std::size_t>(n)].cast<double>();
    }

    /// How far a node of the curve may lie beside the chain, mm.
    double mostBulge(std::int32_t n) const {
        const PointIndex piece = m_curves.piece[static_cast<std::size_t>(n)];
        const machine::LoopIndex loop = m_fabric.points[static_cast<std::size_t>(piece)].loop;
        return m_diameterMm * (loop < 0 ? kBulge : m_bulge[static_cast<std::size_t>(loop)]);
    }

    /// By node of the curve: fed yarn from the start of its yarn, mm.
    std::vector<double> fedAt(const YarnCurves::Range& yarn) const;

    /// A place on the curve and the yarn fed up to it.
    struct Mark {
        std::int32_t node = 0; ///< of the curve, at or before it
        double share = 0;      ///< on the way to the next one
        double fedMm = 0;
    };
    Mark markAt(const YarnCurves::Range& yarn, std::span<const double> fed, double at) const;
    Eigen::Vector3d place(const Mark& mark) const {
        return mark.share > 0 ? (1 - mark.share) * node(mark.node) + mark.share * node(mark.node + 1)
                              : node(mark.node);
    }
    void addBetween(const YarnCurves::Range& yarn, std::span<const double> fed, const Mark& begin,
                    const Mark& end, std::vector<Mark>& marks) const;

    const Fabric& m_fabric;
    YarnCurves m_curves;
    double m_segmentMm;
    double m_diameterMm;
    std::vector<double> m_bulge; ///< by loop, diameters
};

std::vector<double> Laying::fedAt(const YarnCurves::Range& yarn) const {
    std::vector<double> length(1, 0); // of the curve, then of the yarn
    for (std::int32_t n = yarn.first; n + 1 < yarn.first + yarn.count; ++n) {
        length.push_back(length.back() + (node(n + 1) - node(n)).norm());
    }
    double stored = 0;
    const auto pointAt = [&](std::size_t i) {
        return m_curves.point[static_cast<std::size_t>(yarn.first) + i];
    };
    for (PointIndex p = pointAt(0); p <= pointAt(length.size() - 1); ++p) {
        stored += m_fabric.lengths[static_cast<std::size_t>(p)];
    }
    const double usual = length.back() > 0 ? stored / length.back() : 1;
    std::vector<double> fed(1, 0);
    for (std::size_t begin = 0; begin + 1 < length.size();) {
        std::size_t end = begin + 1;
        while (end + 1 < length.size() && pointAt(end) == pointAt(begin)) {
            ++end;
        }
        const double span = length[end] - length[begin];
        const bool tail = pointAt(begin) == pointAt(length.size() - 1);
        const double yarnHere = std::max(m_fabric.lengths[static_cast<std::size_t>(pointAt(begin))],
                                         (tail ? 1 : kLeastYarn) * usual * span);
        for (std::size_t i = begin + 1; i <= end; ++i) {
            const double share = span > 0 ? (length[i] - length[begin]) / span
                                          : static_cast<double>(i - begin) / static_cast<double>(end - begin);
            fed.push_back(fed[begin] + share * yarnHere);
        }
        begin = end;
    }
    return fed;
}

Laying::Mark Laying::markAt(const YarnCurves::Range& yarn, std::span<const double> fed, double at) const {
    const auto next = std::ranges::upper_bound(fed.subspan(1, fed.size() - 2), at);
    const auto i = static_cast<std::size_t>(next - fed.begin()) - 1;
    const double way = fed[i + 1] - fed[i];
    return {yarn.first + static_cast<std::int32_t>(i),
            way > 0 ? std::clamp((at - fed[i]) / way, 0.0, 1.0) : 0, at};
}

/// Marks between two, so that no node of the curve lies farther from the chain than m_bulge: else a bend that
/// holds another strand might be cut off.
void Laying::addBetween(const YarnCurves::Range& yarn, std::span<const double> fed, const Mark& begin,
                        const Mark& end, std::vector<Mark>& marks) const {
    const double least = kShortest * m_segmentMm;
    const Eigen::Vector3d a = place(begin);
    const Eigen::Vector3d b = place(end);
    double most = 1; // of what it may
    std::int32_t worst = -1;
    for (std::int32_t n = begin.node + 1; n <= end.node; ++n) {
        const double bulge = closestPoints(a, b, node(n), node(n)).distance / mostBulge(n);
        if (bulge > most) {
            most = bulge;
            worst = n;
        }
    }
    if (worst < 0 || end.fedMm - begin.fedMm < 2 * least) {
        return;
    }
    const double at = fed[static_cast<std::size_t>(worst - yarn.first)];
    const Mark middle{worst, 0, std::clamp(at, begin.fedMm + least, end.fedMm - least)};
    addBetween(yarn, fed, begin, middle, marks);
    marks.push_back(middle);
    addBetween(yarn, fed, middle, end, marks);
}

void Laying::add(std::size_t index, FabricYarns& result) const {
    const YarnCurves::Range& yarn = m_curves.yarns[index];
    const std::vector<double> fed = fedAt(yarn);
    const int segments = 2 * std::max(2, static_cast<int>(std::lround(0.5 * fed.back() / m_segmentMm)));
    const double segment = fed.back() / segments;
    if (!(segment > 0) || fed.size() < 2) {
        return;
    }
    std::vector<Mark> marks{markAt(yarn, fed, 0)};
    for (int k = 1; k <= segments; ++k) {
        const Mark end = markAt(yarn, fed, std::min(k * segment, fed.back()));
        addBetween(yarn, fed, marks.back(), end, marks);
        marks.push_back(end);
    }
    physics::YarnChains& chains = result.chains;
    const Entry first = chains.nodeCount();
    const auto count = static_cast<Entry>(marks.size());
    chains.nodes.conservativeResize(3, first + count);
    chains.chains.push_back({first, count, static_cast<int>(yarn.carrier)});
    result.carrier.push_back(yarn.carrier);
    for (Entry k = 0; k < count; ++k) {
        const Mark& mark = marks[static_cast<std::size_t>(k)];
        const double rest =
            k + 1 < count ? marks[static_cast<std::size_t>(k) + 1].fedMm - mark.fedMm : segment;
        chains.nodes.col(first + k) = place(mark) / result.units.lengthMm;
        chains.restLength.push_back(rest / result.units.lengthMm);
        result.point.push_back(m_curves.point[static_cast<std::size_t>(mark.node)]);
        result.piece.push_back(m_curves.piece[static_cast<std::size_t>(mark.node)]);
    }
    Entry k = 0;
    for (std::size_t c = 0; c < fed.size(); ++c) {
        while (k + 1 < count && std::abs(marks[static_cast<std::size_t>(k) + 1].fedMm - fed[c]) <=
                                    std::abs(marks[static_cast<std::size_t>(k)].fedMm - fed[c])) {
            ++k;
        }
        const auto p = m_curves.point[static_cast<std::size_t>(yarn.first) + c];
        Entry& nearest = result.nodeOfPoint[static_cast<std::size_t>(p)];
        nearest = nearest < 0 ? first + k : nearest;
    }
}

/// Stretch along the third axis that makes the curves as long as their yarn.
double depthFor(const Laying& laying, const Eigen::Vector2d& plane, double fedMm) {
    double low = kLeastDepth;
    double high = kMostDepth;
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (low + high);
        (laying.curveLength({plane.x(), plane.y(), middle}) < fedMm ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

void removeChains(FabricYarns& yarns) {
    yarns.chains.nodes.resize(3, 0);
    yarns.chains.chains.clear();
    yarns.chains.restLength.clear();
    yarns.carrier.clear();
    yarns.point.clear();
    yarns.piece.clear();
    std::ranges::fill(yarns.nodeOfPoint, -1);
}

/// Chains along all curves; finer ones where a crossing of the fabric would be lost.
void layAll(const Fabric& f, Laying& laying, FabricYarns& result) {
    for (std::size_t found = 0;;) {
        removeChains(result);
        for (std::size_t yarn = 0; yarn < laying.curves().yarns.size(); ++yarn) {
            laying.add(yarn, result);
        }
        const YarnCurves laid = curvesOf(result, result.chains.start());
        const geometry::CrossingAudit audit =
            geometry::auditCrossings(f, laid, geometry::projectCrossings(laid));
        if (audit.found == audit.expected || audit.found <= found) {
            return;
        }
        found = audit.found;
        std::set<machine::LoopIndex> loops;
        for (const geometry::CrossingFault& fault : audit.faults) {
            if (fault.kind == geometry::CrossingFault::Kind::Missing) {
                loops.insert({fault.a.loop, fault.b.loop});
            }
        }
        for (const machine::LoopIndex loop : loops) {
            laying.refine(loop);
        }
    }
}

void hangUp(const Fabric& f, FabricYarns& yarns) {
    const auto nodeOf = [&](PointIndex p) { return yarns.nodeOfPoint[static_cast<std::size_t>(p)]; };
    for (const fabric::Loop& loop : f.loops) {
        if (loop.end == fabric::Loop::End::Held && loop.headLeft >= 0) {
            const auto [first, last] = std::minmax({nodeOf(loop.headLeft), nodeOf(loop.headRight)});
            for (Entry e = first; e <= last; ++e) {
                yarns.onHolder.push_back(e);
            }
        }
    }
    for (std::size_t e = 0; e < yarns.piece.size(); ++e) {
        const fabric::BondingPoint& point = f.points[static_cast<std::size_t>(yarns.piece[e])];
        const fabric::Loop& loop = f.loops[static_cast<std::size_t>(point.loop)];
        if (loop.footLeft < 0 && loop.course == 0) {
            yarns.onComb.push_back(static_cast<Entry>(e));
        }
    }
}

/// The first and the last loop of a yarn are closed, as a slip knot closes them.
void knotEnds(double loopLength, FabricYarns& yarns) {
    const physics::YarnChains& chains = yarns.chains;
    for (const physics::Chain& chain : chains.chains) {
        const double segment = chains.restLength[static_cast<std::size_t>(chain.first)];
        const auto way = static_cast<Entry>(std::lround(kClosedLoop * loopLength / segment));
        if (way < 2 || 2 * way >= chain.count) {
            continue;
        }
        const Entry last = chain.first + chain.count - 1;
        for (const auto& [end, at] :
             {std::pair(chain.first, chain.first + way), std::pair(last, last - way)}) {
            yarns.knots.push_back({end, at, (chains.nodes.col(at) - chains.nodes.col(end)).norm()});
        }
    }
}

} // namespace

FabricYarns layYarns(const Fabric& f, std::span<const yarn::Yarn> yarns, const YarnLayout& layout) {
    FabricYarns result;
    result.nodeOfPoint.assign(f.points.size(), -1);
    const auto yarnOf = [&](machine::CarrierIndex carrier) {
        return carrier < yarns.size() ? yarns[carrier] : yarn::Yarn();
    };
    result.units = physics::unitsOf(yarnOf(mostUsedCarrier(f)));
    machine::CarrierIndex carriers = 0;
    double fed = 0;
    for (const fabric::Yarn& yarn : f.yarns) {
        carriers = std::max<machine::CarrierIndex>(carriers, yarn.carrier + 1);
        for (PointIndex p = yarn.first; p < yarn.first + yarn.count; ++p) {
            fed += f.lengths[static_cast<std::size_t>(p)];
        }
    }
    std::vector<double> diameters;
    result.chains.yarns.resize(carriers);
    result.weightOfYarn.resize(carriers);
    for (machine::CarrierIndex c = 0; c < carriers; ++c) {
        setYarn(result, c, yarnOf(c));
        diameters.push_back(yarnOf(c).outerDiameterMm);
    }
    const double loopLength = f.made.loops.empty() ? 1 : fabric::meanLoopLength(f); // any, where none is
    const Eigen::Vector2d plane = drawIn(f, yarns, layout);
    if (layout.cancelled != nullptr && (*layout.cancelled)()) {
        return result;
    }
    Laying laying(f,
                  geometry::buildYarnCurves(f, fabric::machinePlaces(f), diameters,
                                            {.samplesPerSegment = kSamples, .exact = true}),
                  loopLength / layout.nodesPerLoop, result.units.lengthMm);
    const Eigen::Vector2d laid = plane.cwiseProduct(Eigen::Vector2d(layout.wider, layout.higher));
    laying.stretch({laid.x(), laid.y(), depthFor(laying, laid, fed)});
    layAll(f, laying, result);
    hangUp(f, result);
    knotEnds(loopLength / result.units.lengthMm, result);
    return result;
}

FabricYarns guessYarns(const Fabric& f, std::span<const yarn::Yarn> yarns) {
    const double loopLength = fabric::meanLoopLength(f);
    YarnLayout layout;
    layout.waleSpacingMm = kUsualWale * loopLength;
    layout.courseSpacingMm = kUsualCourse * loopLength;
    return layYarns(f, yarns, layout);
}

void setYarn(FabricYarns& yarns, machine::CarrierIndex carrier, const yarn::Yarn& yarn) {
    if (carrier >= yarns.chains.yarns.size()) {
        return;
    }
    yarns.chains.yarns[carrier] = physics::toRod(yarn, yarns.units);
    yarns.weightOfYarn[carrier] = kGravity * yarn.tex * yarns.units.lengthMm / yarns.units.forceMilliNewton();
}

FabricYarns withHalfTheNodes(const Fabric& f, const FabricYarns& yarns, const physics::Vector& x,
                             const std::vector<char>& kept) {
    FabricYarns result;
    result.units = yarns.units;
    result.carrier = yarns.carrier;
    result.chains.yarns = yarns.chains.yarns;
    result.weightOfYarn = yarns.weightOfYarn;
    std::vector<Entry> renamed(static_cast<std::size_t>(yarns.chains.nodeCount()), 0);
    std::vector<Eigen::Vector3d> nodes;
    for (const physics::Chain& chain : yarns.chains.chains) {
        const auto first = static_cast<Entry>(nodes.size());
        for (Entry i = 0; i < chain.count; ++i) {
            const auto old = static_cast<std::size_t>(chain.first + i);
            const double rest = yarns.chains.restLength[old];
            if (i % 2 == 0 || i + 1 == chain.count || (!kept.empty() && kept[old] != 0)) {
                nodes.emplace_back(physics::at(x, chain.first + i));
                result.chains.restLength.push_back(rest);
                result.point.push_back(yarns.point[old]);
                result.piece.push_back(yarns.piece[old]);
            } else {
                result.chains.restLength.back() += rest;
            }
            // A node that is left out is known by the one before it.
            renamed[old] = static_cast<Entry>(nodes.size()) - 1;
        }
        result.chains.chains.push_back({first, static_cast<Entry>(nodes.size()) - first, chain.yarn});
    }
    result.chains.nodes =
        Eigen::Map<const Eigen::Matrix3Xd>(nodes.front().data(), 3, static_cast<Eigen::Index>(nodes.size()));
    for (const Entry node : yarns.nodeOfPoint) {
        result.nodeOfPoint.push_back(node < 0 ? -1 : renamed[static_cast<std::size_t>(node)]);
    }
    hangUp(f, result);
    knotEnds(fabric::meanLoopLength(f) / result.units.lengthMm, result);
    return result;
}

} // namespace knittsim::simulation
