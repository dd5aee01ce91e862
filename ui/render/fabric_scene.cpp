#include "ui/render/fabric_scene.h"

#include "core/fabric/machine_shape.h"
#include "core/geometry/yarn_frame.h"
#include "ui/render/finer_curves.h"
#include "ui/render/hidden_sky.h"
#include "ui/render/scene_chunks.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace knittsim::render {

namespace {

constexpr int kMostRounds = 8;
constexpr float kPull = 0.2F; ///< of the fabric's normal on the direction across a yarn
std::uint32_t quantise(float value, float low, float high, std::uint32_t steps) {
    const float t = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
    return static_cast<std::uint32_t>(t * static_cast<float>(steps) + 0.5F);
}

/// Octahedral map, 2 x 11 bits.
std::uint32_t packDirection(const Vec3f& direction) {
    const float sum = std::max(1e-12F, direction.cwiseAbs().sum());
    float x = direction.x() / sum;
    float y = direction.y() / sum;
    if (direction.z() < 0) {
        const float foldedX = (1 - std::abs(y)) * (x < 0 ? -1.0F : 1.0F);
        y = (1 - std::abs(x)) * (y < 0 ? -1.0F : 1.0F);
        x = foldedX;
    }
    return quantise(x, -1, 1, 2046) | quantise(y, -1, 1, 2046) << 11;
}

/// Pieces for each piece of given curves: fewer for large fabrics, whose stitches are small on the screen.
int finenessFor(const fabric::Fabric& fabric) {
    const std::size_t loops = fabric.loops.size();
    return loops > 5000 ? 1 : loops > 1500 ? 2 : 4;
}

std::vector<double> diametersOf(const fabric::Fabric& fabric, std::span<const YarnLook> looks) {
    std::size_t carriers = looks.size();
    for (const fabric::Yarn& yarn : fabric.yarns) {
        carriers = std::max<std::size_t>(carriers, std::size_t{yarn.carrier} + 1);
    }
    std::vector<double> diameters(carriers, YarnLook().diameterMm);
    std::ranges::transform(looks, diameters.begin(), [](const YarnLook& look) { return look.diameterMm; });
    return diameters;
}

Vec3f placeOf(std::span<const float> positions, fabric::EntryIndex entry) {
    const std::size_t i = 3 * static_cast<std::size_t>(entry);
    const Vec3f p = i + 2 < positions.size() ? Vec3f(positions[i], positions[i + 1], positions[i + 2])
                                             : Vec3f(Vec3f::Zero());
    return p.allFinite() ? p : Vec3f(Vec3f::Zero());
}

/// The way of the yarn at a point: from the point before it to the one after.
std::array<float, 3> wayAt(const fabric::Fabric& fabric, std::span<const float> positions,
                           fabric::PointIndex point) {
    const auto entryOf = [&](fabric::PointIndex p) {
        return fabric.points[static_cast<std::size_t>(p)].entry;
    };
    const auto last = static_cast<fabric::PointIndex>(fabric.points.size()) - 1;
    const Vec3f way = placeOf(positions, entryOf(std::min(point + 1, last))) -
                      placeOf(positions, entryOf(std::max(point - 1, 0)));
    return {way.x(), way.y(), way.z()};
}

Marker markerAt(const fabric::Fabric& fabric, std::span<const float> positions, fabric::EntryIndex entry) {
    const Vec3f place = placeOf(positions, entry);
    Marker marker{.place = {place.x(), place.y(), place.z()}, .kind = Marker::OpenHead};
    for (const fabric::PointIndex p : fabric.at(entry)) {
        const fabric::BondingPoint& point = fabric.points[static_cast<std::size_t>(p)];
        if (point.role == fabric::Role::Crossing) {
            marker.kind = Marker::Crossing;
            (point.front > 0 ? marker.front : marker.behind) = wayAt(fabric, positions, p);
        } else if (point.role == fabric::Role::Foot) {
            marker.kind = Marker::Bond;
        }
    }
    return marker;
}

} // namespace

int samplesFor(const fabric::Fabric& fabric) {
    const std::size_t loops = fabric.loops.size();
    return loops > 40000 ? 1 : loops > 5000 ? 2 : loops > 300 ? 3 : 6;
}

FabricScene::FabricScene(std::shared_ptr<const fabric::Fabric> fabric, std::span<const YarnLook> looks,
                         DrawStyle style)
    : FabricScene(fabric, looks, style, samplesFor(*fabric)) {}

FabricScene::FabricScene(std::shared_ptr<const fabric::Fabric> fabric, std::span<const YarnLook> looks,
                         DrawStyle style, int samples)
    : m_fabric(std::move(fabric)), m_style(style), m_diameters(diametersOf(*m_fabric, looks)) {
    auto topology = std::make_shared<SceneTopology>();
    topology->pointCount = m_fabric->points.size();
    topology->loopOfPoint.reserve(m_fabric->points.size());
    for (const fabric::BondingPoint& point : m_fabric->points) {
        topology->loopOfPoint.push_back(point.loop);
    }
    if (style == DrawStyle::Mesh) {
        std::vector<fabric::PointIndex> points(m_fabric->points.size());
        std::iota(points.begin(), points.end(), 0);
        std::vector<geometry::YarnCurves::Range> yarns;
        for (const fabric::Yarn& yarn : m_fabric->yarns) {
            yarns.push_back({yarn.first, yarn.count, yarn.carrier});
        }
        layOut(*topology, yarns, points);
    } else {
        m_builder = std::make_unique<geometry::YarnCurveBuilder>(
            *m_fabric, m_diameters,
            geometry::CurveOptions{.samplesPerSegment = samples, .withSurface = true});
        layOut(*topology, m_builder->curves().yarns, m_builder->curves().point);
    }
    m_topology = std::move(topology);
    m_machinePositions = fabric::machinePlaces(*m_fabric);
    m_roundsLeft = m_builder && m_fabric->loops.size() <= kMostOrdered ? kMostRounds : 0;
}

bool FabricScene::improve() {
    if (m_roundsLeft == 0) {
        return false;
    }
    --m_roundsLeft;
    const bool moved = m_builder->orderStrands(*m_fabric, m_machinePositions) > 0;
    m_roundsLeft = moved ? m_roundsLeft : 0;
    return moved;
}

/// Places the yarns one after the other, each on an aligned node.
void FabricScene::layOut(SceneTopology& topology, std::span<const geometry::YarnCurves::Range> yarns,
                         std::span<const fabric::PointIndex> pointOfNode) {
    std::int32_t node = 0;
    for (const geometry::YarnCurves::Range& yarn : yarns) {
        node = alignedNode(node);
        topology.yarns.push_back({node, yarn.count, yarn.carrier});
        topology.owner.resize(static_cast<std::size_t>(node), 0);
        const auto points =
            pointOfNode.subspan(static_cast<std::size_t>(yarn.first), static_cast<std::size_t>(yarn.count));
        topology.owner.insert(topology.owner.end(), points.begin(), points.end());
        node += yarn.count;
    }
}

std::shared_ptr<const SceneFrame> FabricScene::prepare(std::span<const float> positions,
                                                       std::span<const float> values) {
    const std::span<const float> places =
        positions.empty() ? std::span<const float>(m_machinePositions) : positions;
    const std::shared_ptr<SceneFrame> frame = emptyFrame();
    if (m_style == DrawStyle::Mesh) {
        fillMesh(*frame, places);
    } else {
        m_builder->update(places);
        fillCurves(*frame, m_builder->curves());
    }
    if (values.size() == m_topology->pointCount) {
        addValues(*frame, values, true);
    }
    return frame;
}

std::shared_ptr<const SceneFrame> FabricScene::prepareCurves(const geometry::YarnCurves& given,
                                                             std::span<const float> givenValues) {
    const int times = finenessFor(*m_fabric);
    const bool valued = givenValues.size() == given.nodes.size();
    const geometry::YarnCurves fine = times > 1 ? finer(given, times) : geometry::YarnCurves();
    const std::vector<float> fineValues =
        times > 1 && valued ? finer(given, givenValues, times) : std::vector<float>();
    const geometry::YarnCurves& curves = times > 1 ? fine : given;
    const std::span<const float> values = times > 1 ? std::span<const float>(fineValues) : givenValues;
    auto topology = std::make_shared<SceneTopology>(*m_topology);
    topology->owner.clear();
    topology->yarns.clear();
    layOut(*topology, curves.yarns, curves.point);
    const std::shared_ptr<SceneFrame> frame = emptyFrame();
    frame->topology = std::move(topology);
    fillCurves(*frame, curves);
    if (values.size() == curves.nodes.size()) {
        addValues(*frame, values, false);
    }
    return frame;
}

/// `values` by bonding point, or by node of the yarns without what lies between them.
void FabricScene::addValues(SceneFrame& frame, std::span<const float> values, bool byPoint) {
    constexpr std::uint32_t kDirection = (1U << 22) - 1;
    frame.range = rangeOf(values);
    std::size_t next = 0;
    for (const geometry::YarnCurves::Range& yarn : frame.topology->yarns) {
        const auto first = static_cast<std::size_t>(yarn.first);
        for (std::size_t n = first; n < first + static_cast<std::size_t>(yarn.count); ++n, ++next) {
            const float value = values[byPoint ? frame.topology->owner[n] : next];
            std::uint32_t& packed = frame.surface[n][1];
            packed = (packed & kDirection) | quantise(frame.range.shareOf(value), 0, 1, 1023) << 22;
        }
    }
}

std::shared_ptr<SceneFrame> FabricScene::emptyFrame() const {
    auto frame = std::make_shared<SceneFrame>();
    frame->topology = m_topology;
    frame->style = m_style;
    frame->diameters.assign(m_diameters.begin(), m_diameters.end());
    return frame;
}

void FabricScene::fillCurves(SceneFrame& frame, const geometry::YarnCurves& curves) const {
    frame.nodes.resize(frame.topology->owner.size(), kNoNode);
    frame.surface.resize(frame.topology->owner.size());
    for (std::size_t y = 0; y < curves.yarns.size(); ++y) {
        const geometry::YarnCurves::Range& yarn = curves.yarns[y];
        const float perDiameter = 1 / std::max(1e-3F, frame.diameters[yarn.carrier]);
        const auto first = static_cast<std::size_t>(yarn.first);
        const std::size_t last = first + static_cast<std::size_t>(yarn.count) - 1;
        auto to = static_cast<std::size_t>(frame.topology->yarns[y].first);
        Vec3f reference = curves.normal[first];
        for (std::size_t n = first; n <= last; ++n, ++to) {
            const Vec3f& p = curves.nodes[n];
            const Vec3f way = curves.nodes[std::min(n + 1, last)] - curves.nodes[std::max(n, first + 1) - 1];
            // Staying near the fabric's normal, so that the yarn's twist neither swims nor jumps.
            reference = geometry::carryAcross(reference + kPull * curves.normal[n],
                                              way / std::max(1e-9F, way.norm()));
            frame.nodes[to] = {p.x(), p.y(), p.z(), curves.arc[n]};
            frame.surface[to] = {packDirection(reference) |
                                     quantise(curves.height[n] * perDiameter, -2, 2, 1023) << 22,
                                 packDirection(curves.normal[n])};
        }
    }
    addHidden(frame);
    addChunks(frame);
}

void FabricScene::fillMesh(SceneFrame& frame, std::span<const float> positions) const {
    const std::array<std::uint32_t, 2> towardsFront{packDirection(Vec3f::UnitX()),
                                                    packDirection(Vec3f::UnitZ())};
    frame.nodes.resize(m_topology->owner.size(), kNoNode);
    frame.surface.assign(m_topology->owner.size(), towardsFront);
    frame.hidden.assign(m_topology->owner.size(), {127, 127, 127, 0});
    for (std::size_t y = 0; y < m_topology->yarns.size(); ++y) {
        const auto first = static_cast<std::size_t>(m_topology->yarns[y].first);
        for (std::size_t n = first; n < first + static_cast<std::size_t>(m_topology->yarns[y].count); ++n) {
            const Vec3f place = placeOf(positions, m_fabric->points[m_topology->owner[n]].entry);
            // Coincident points still advance, so that a falling arc always means another yarn.
            const float step =
                n > first ? std::max(1e-4F, (place - Vec3f::Map(frame.nodes[n - 1].data())).norm()) : 0;
            frame.nodes[n] = {place.x(), place.y(), place.z(), n > first ? frame.nodes[n - 1][3] + step : 0};
        }
    }
    addChunks(frame);
    addMarkers(frame, positions);
}

void FabricScene::addMarkers(SceneFrame& frame, std::span<const float> positions) const {
    frame.markers.reserve(static_cast<std::size_t>(m_fabric->entryCount));
    for (fabric::EntryIndex entry = 0; entry < m_fabric->entryCount; ++entry) {
        frame.markers.push_back(markerAt(*m_fabric, positions, entry));
    }
}

} // namespace knittsim::render
