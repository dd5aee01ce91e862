#include "core/physics/strand.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

using fabric::BondingPoint;
using fabric::Fabric;
using fabric::LoopIndex;
using fabric::PointIndex;
using fabric::Role;

namespace {

const BondingPoint& pointOf(const Fabric& f, PointIndex p) {
    return f.points[static_cast<std::size_t>(p)];
}
const machine::Loop& madeOf(const Fabric& f, LoopIndex l) {
    return f.made.loops[static_cast<std::size_t>(l)];
}

LoopIndex loopWithRole(const Fabric& f, PointIndex point, Role role) {
    for (const PointIndex p : f.at(pointOf(f, point).entry)) {
        if (pointOf(f, p).role == role) {
            return pointOf(f, p).loop;
        }
    }
    return -1;
}

bool areNeighbours(const machine::Loop& a, const machine::Loop& b) {
    const double gap = positionPitches(a.needle, a.rack) - positionPitches(b.needle, b.rack);
    return std::abs(gap) < 1.5 && a.direction == b.direction;
}

Strand::Kind kindOf(const Fabric& f, const BondingPoint& a, const BondingPoint& b) {
    if (a.loop == b.loop) {
        return a.role == b.role ? Strand::Kind::Head : Strand::Kind::Leg;
    }
    const bool feet = a.role == Role::Foot && b.role == Role::Foot;
    return feet && areNeighbours(madeOf(f, a.loop), madeOf(f, b.loop)) ? Strand::Kind::Sinker
                                                                       : Strand::Kind::Float;
}

/// Faces that change at the two ends of a leg.
int faceChanges(const Fabric& f, const BondingPoint& foot, PointIndex footPoint, PointIndex headPoint) {
    const int face = faceOf(f, foot.loop);
    const LoopIndex below = loopUnder(f, footPoint);
    const LoopIndex above = loopThrough(f, headPoint);
    return (below >= 0 && faceOf(f, below) != face ? 1 : 0) +
           (above >= 0 && faceOf(f, above) != face ? 1 : 0);
}

/// Length of a piece of a loop as it was knitted, whatever share of its loop that is. What it took over from
/// a ladder (core/fabric/reduction.h) hangs slack: it makes the arcs rounder and pushes nothing apart.
double withoutSlack(const Fabric& f, const Strand& s, double share) {
    return std::min(s.length, share * madeOf(f, pointOf(f, s.first).loop).lengthMm);
}

double legRest(const Fabric& f, const Strand& s) {
    const bool up = pointOf(f, s.first).role == Role::Foot;
    const PointIndex foot = up ? s.first : s.last;
    const PointIndex head = up ? s.last : s.first;
    const int changes = faceChanges(f, pointOf(f, foot), foot, head);
    const double shrink = changes == 0 ? 1.0 : changes == 1 ? kLegOneFaceChange : kLegTwoFaceChanges;
    return kLegChord * shrink * withoutSlack(f, s, fabric::kLegShare);
}

/// A float turns into its loops with the arcs of a sinker and is straight between them. At the edge, where
/// the yarn goes on in another course, it is no more bent than a leg, and while it waits there the take-down
/// draws it along with the courses that pass by.
void measureFloat(const Fabric& f, Strand& s) {
    const LoopIndex fromLoop = pointOf(f, s.first).loop;
    const LoopIndex toLoop = pointOf(f, s.last).loop;
    const double loop = madeOf(f, toLoop).lengthMm;
    const double chord = madeOf(f, fromLoop).direction == madeOf(f, toLoop).direction ? kArcChord : kLegChord;
    const int courses = std::abs(f.loops[static_cast<std::size_t>(fromLoop)].course -
                                 f.loops[static_cast<std::size_t>(toLoop)].course);
    s.arc = std::min(s.length, fabric::kSinkerShare * loop);
    s.rest = std::max(s.length - (1 - chord) * s.arc, courses * kLegChord * fabric::kLegShare * loop);
}

void measure(const Fabric& f, Strand& s) {
    s.arc = s.length;
    switch (s.kind) {
    case Strand::Kind::Head:
        s.rest = kArcChord * withoutSlack(f, s, fabric::kHeadShare);
        break;
    case Strand::Kind::Sinker: {
        // Yarn beyond that of a plain sinker was laid from bed to bed: it turns through the depth of the
        // fabric and does not hold wales apart.
        const double plain = fabric::kSinkerShare * madeOf(f, pointOf(f, s.last).loop).lengthMm;
        s.rest = kArcChord * std::min(s.length, plain);
        break;
    }
    case Strand::Kind::Leg:
        s.rest = legRest(f, s);
        break;
    case Strand::Kind::Float:
        measureFloat(f, s);
        break;
    }
}

} // namespace

std::int32_t Strands::legAt(PointIndex point) const {
    for (const std::int32_t s :
         {endingAt[static_cast<std::size_t>(point)], beginningAt[static_cast<std::size_t>(point)]}) {
        if (s >= 0 && all[static_cast<std::size_t>(s)].kind == Strand::Kind::Leg) {
            return s;
        }
    }
    return -1;
}

std::int32_t Strands::otherAt(PointIndex point) const {
    for (const std::int32_t s :
         {endingAt[static_cast<std::size_t>(point)], beginningAt[static_cast<std::size_t>(point)]}) {
        if (s >= 0 && all[static_cast<std::size_t>(s)].kind != Strand::Kind::Leg) {
            return s;
        }
    }
    return -1;
}

PointIndex Strands::across(std::int32_t strand, PointIndex point) const {
    const Strand& s = all[static_cast<std::size_t>(strand)];
    return s.first == point ? s.last : s.first;
}

Strands findStrands(const Fabric& f) {
    Strands strands;
    strands.all.reserve(f.points.size());
    strands.endingAt.assign(f.points.size(), -1);
    strands.beginningAt.assign(f.points.size(), -1);
    for (const fabric::Yarn& yarn : f.yarns) {
        PointIndex before = -1;
        double length = 0;
        for (PointIndex p = yarn.first; p < yarn.first + yarn.count; ++p) {
            if (pointOf(f, p).role != Role::Crossing) {
                if (before >= 0) {
                    Strand s{.kind = kindOf(f, pointOf(f, before), pointOf(f, p)),
                             .first = before,
                             .last = p,
                             .carrier = yarn.carrier,
                             .length = length};
                    measure(f, s);
                    const auto index = static_cast<std::int32_t>(strands.all.size());
                    strands.beginningAt[static_cast<std::size_t>(before)] = index;
                    strands.endingAt[static_cast<std::size_t>(p)] = index;
                    strands.all.push_back(s);
                }
                before = p;
                length = 0;
            }
            length += f.lengths[static_cast<std::size_t>(p)];
        }
    }
    return strands;
}

LoopIndex loopThrough(const Fabric& f, PointIndex head) {
    return loopWithRole(f, head, Role::Foot);
}

LoopIndex loopUnder(const Fabric& f, PointIndex foot) {
    return loopWithRole(f, foot, Role::Head);
}

int faceOf(const Fabric& f, LoopIndex loop) {
    return machine::isFront(madeOf(f, loop).needle.bed) ? 1 : -1;
}

} // namespace knittsim::physics
