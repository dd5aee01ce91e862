#include "core/geometry/frame_field.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace knittsim::geometry {

using fabric::EntryIndex;
using fabric::Fabric;
using fabric::PointIndex;
using fabric::Role;

namespace {

constexpr float kTiny = 1e-6F;    ///< mm; shorter vectors have no direction
constexpr int kSmoothSweeps = 12; ///< spreads the surface over about two wales

std::size_t at(EntryIndex entry) {
    return static_cast<std::size_t>(entry);
}

Vec3f unitOr(const Vec3f& v, const Vec3f& fallback) {
    const float length = v.norm();
    return length > kTiny && std::isfinite(length) ? Vec3f(v / length) : fallback;
}

/// Entry of the nearest corner of the same yarn before (step -1) or after a crossing.
EntryIndex cornerBeside(const Fabric& fabric, PointIndex p, PointIndex first, PointIndex last, int step) {
    for (PointIndex q = p + step; q >= first && q < last; q += step) {
        const fabric::BondingPoint& point = fabric.points[static_cast<std::size_t>(q)];
        if (point.role != Role::Crossing) {
            return point.entry;
        }
    }
    return -1;
}

} // namespace

FrameField::FrameField(const Fabric& fabric) {
    const auto entries = static_cast<std::size_t>(fabric.entryCount);
    m_loops.reserve(fabric.loops.size());
    const auto entryOf = [&](PointIndex p) {
        return p < 0 ? -1 : fabric.points[static_cast<std::size_t>(p)].entry;
    };
    for (const fabric::Loop& loop : fabric.loops) {
        if (loop.headLeft >= 0 && loop.headRight >= 0) {
            m_loops.push_back({entryOf(loop.footLeft), entryOf(loop.headLeft), entryOf(loop.headRight),
                               entryOf(loop.footRight)});
        }
    }
    m_linkCount.assign(entries, 0);
    for (const fabric::Yarn& yarn : fabric.yarns) {
        const PointIndex last = yarn.first + yarn.count;
        for (PointIndex p = yarn.first; p < last; ++p) {
            const EntryIndex here = entryOf(p);
            if (p + 1 < last) {
                m_links.emplace_back(here, entryOf(p + 1));
                m_linkCount[at(here)] += 1;
                m_linkCount[at(entryOf(p + 1))] += 1;
            }
            if (fabric.points[static_cast<std::size_t>(p)].role == Role::Crossing) {
                m_crossings.push_back({here, cornerBeside(fabric, p, yarn.first, last, -1),
                                       cornerBeside(fabric, p, yarn.first, last, +1)});
            }
        }
    }
    for (auto* vectors : {&m_position, &m_across, &m_along, &m_normal, &m_smooth, &m_sum}) {
        vectors->assign(entries, Vec3f::Zero());
    }
    for (auto* numbers : {&m_chord, &m_rise, &m_relief, &m_chordWeight, &m_riseWeight}) {
        numbers->assign(entries, 0);
    }
}

void FrameField::update(std::span<const float> positions) {
    const std::size_t entries = m_position.size();
    for (std::size_t e = 0; e < entries; ++e) {
        const Vec3f p = 3 * e + 2 < positions.size()
                            ? Vec3f(positions[3 * e], positions[3 * e + 1], positions[3 * e + 2])
                            : Vec3f(Vec3f::Zero());
        m_position[e] = p.allFinite() ? p : Vec3f(Vec3f::Zero());
        m_across[e].setZero();
        m_along[e].setZero();
        m_chord[e] = m_rise[e] = m_chordWeight[e] = m_riseWeight[e] = 0;
    }
    for (const Corners& corners : m_loops) {
        addLoop(corners);
    }
    for (std::size_t e = 0; e < entries; ++e) {
        finishEntry(e);
    }
    copyToCrossings();
}

void FrameField::addLoop(const Corners& c) {
    const Vec3f heads = m_position[at(c.headRight)] - m_position[at(c.headLeft)];
    const float headChord = heads.norm();
    const auto addChord = [&](EntryIndex e, const Vec3f& chord, float length) {
        m_across[at(e)] += chord;
        m_chord[at(e)] += length;
        m_chordWeight[at(e)] += 1;
    };
    addChord(c.headLeft, heads, headChord);
    addChord(c.headRight, heads, headChord);
    if (c.footLeft < 0 || c.footRight < 0) {
        return;
    }
    const Vec3f up = 0.5F * (m_position[at(c.headLeft)] + m_position[at(c.headRight)] -
                             m_position[at(c.footLeft)] - m_position[at(c.footRight)]);
    const float rise = up.norm();
    for (const EntryIndex e : {c.footLeft, c.headLeft, c.headRight, c.footRight}) {
        m_along[at(e)] += up;
        m_rise[at(e)] += rise;
        m_riseWeight[at(e)] += 1;
    }
}

void FrameField::finishEntry(std::size_t e) {
    const Vec3f across = unitOr(m_across[e], Vec3f::UnitX());
    const Vec3f along = unitOr(m_along[e], std::abs(across.y()) < 0.9F ? Vec3f::UnitY() : Vec3f::UnitX());
    const Vec3f fallback = std::abs(across.z()) < 0.9F ? Vec3f(Vec3f::UnitZ()) : Vec3f(-Vec3f::UnitX());
    const Vec3f normal =
        unitOr(across.cross(along), unitOr(fallback - fallback.dot(across) * across, fallback));
    m_across[e] = across;
    m_normal[e] = normal;
    m_along[e] = normal.cross(across);
    m_chord[e] = m_chordWeight[e] > 0 ? m_chord[e] / m_chordWeight[e] : 0;
    m_rise[e] = m_riseWeight[e] > 0 ? m_rise[e] / m_riseWeight[e] : 1.5F * m_chord[e];
}

void FrameField::copyToCrossings() {
    for (const Neighbours& n : m_crossings) {
        m_normal[at(n.entry)].setZero();
        m_across[at(n.entry)].setZero();
    }
    for (const Neighbours& n : m_crossings) {
        for (const EntryIndex source : {n.before, n.after}) {
            if (source >= 0) {
                m_normal[at(n.entry)] += m_normal[at(source)];
                m_across[at(n.entry)] += m_across[at(source)];
            }
        }
    }
    for (const Neighbours& n : m_crossings) {
        const std::size_t e = at(n.entry);
        m_normal[e] = unitOr(m_normal[e], Vec3f::UnitZ());
        const Vec3f flat = m_across[e] - m_across[e].dot(m_normal[e]) * m_normal[e];
        m_across[e] = unitOr(flat, m_normal[e].unitOrthogonal());
        m_along[e] = m_normal[e].cross(m_across[e]);
    }
}

void FrameField::updateWithRelief(std::span<const float> positions) {
    update(positions);
    smooth();
    for (std::size_t e = 0; e < m_relief.size(); ++e) {
        m_relief[e] = (m_position[e] - m_smooth[e]).dot(m_normal[e]);
    }
}

void FrameField::smooth() {
    m_smooth = m_position;
    for (int sweep = 0; sweep < kSmoothSweeps; ++sweep) {
        std::ranges::fill(m_sum, Vec3f(Vec3f::Zero()));
        for (const auto& [a, b] : m_links) {
            m_sum[at(a)] += m_smooth[at(b)];
            m_sum[at(b)] += m_smooth[at(a)];
        }
        for (std::size_t e = 0; e < m_smooth.size(); ++e) {
            if (m_linkCount[e] > 0) {
                m_smooth[e] = 0.3F * m_smooth[e] + 0.7F * (m_sum[e] / m_linkCount[e]);
            }
        }
    }
}

} // namespace knittsim::geometry
