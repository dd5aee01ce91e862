#include "core/physics/bonding_point_model.h"

#include "core/physics/bend_term.h"
#include "core/physics/plate_term.h"
#include "core/physics/stitch_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knittsim::physics {

using fabric::Fabric;
using fabric::PointIndex;
using fabric::Role;

namespace {

struct Springs {
    std::vector<Spring> springs;
    std::vector<PointIndex> points;
    RopeTerm ropes;
    std::vector<std::pair<PointIndex, PointIndex>> ropePoints;
};

const yarn::Yarn& yarnOf(std::span<const yarn::Yarn> yarns, machine::CarrierIndex carrier) {
    static const yarn::Yarn fallback;
    return carrier < yarns.size() ? yarns[carrier] : fallback;
}

Entry entryOf(const Fabric& f, PointIndex p) {
    return f.points[static_cast<std::size_t>(p)].entry;
}

/// Stiffness of a strand between its ends: its arcs bend, all of it stretches; mN/mm.
double strandStiffness(const Strand& s, const yarn::Yarn& y, const PreviewOptions& options) {
    const double bend = s.arc * s.arc * s.arc / (options.arcStiffness * y.bendingStiffness);
    return 1 / (bend + s.length / y.axialStiffnessMilliNewton);
}

/// Crossings split a strand into springs in a row, each with its share of length and give.
void addStrand(const Fabric& f, const Strand& s, double stiffness, Springs& out) {
    double sum = 0;
    const auto share = [&](PointIndex p) {
        return std::max(f.lengths[static_cast<std::size_t>(p)] / s.length, 1e-3);
    };
    for (PointIndex p = s.first; p < s.last; ++p) {
        sum += share(p);
    }
    for (PointIndex p = s.first; p < s.last; ++p) {
        if (entryOf(f, p) != entryOf(f, p + 1)) {
            const double part = share(p) / sum;
            const double k = stiffness / part;
            out.springs.push_back({entryOf(f, p), entryOf(f, p + 1), part * s.rest, k, s.pushes() ? k : 0});
            out.points.push_back(p);
        }
    }
}

void addRope(const Fabric& f, const Strand& s, double stiffness, Springs& out) {
    std::vector<Entry> way;
    for (PointIndex p = s.first; p <= s.last; ++p) {
        way.push_back(entryOf(f, p));
    }
    out.ropes.add(way, s.rest, stiffness);
    out.ropePoints.emplace_back(s.first, s.last);
}

/// Floats slide where they pass other strands; loops do not.
Springs previewSprings(const Fabric& f, const Strands& strands, std::span<const yarn::Yarn> yarns,
                       const PreviewOptions& options) {
    Springs out;
    out.springs.reserve(f.points.size());
    out.points.reserve(f.points.size());
    for (const Strand& s : strands.all) {
        if (s.length <= 0) {
            continue;
        }
        const double stiffness = strandStiffness(s, yarnOf(yarns, s.carrier), options);
        if (s.kind == Strand::Kind::Float && s.last > s.first + 1) {
            addRope(f, s, stiffness, out);
        } else {
            addStrand(f, s, stiffness, out);
        }
    }
    return out;
}

template<class Visit> void forSegments(const Fabric& f, Visit visit) {
    for (const fabric::Yarn& y : f.yarns) {
        for (PointIndex p = y.first; p + 1 < y.first + y.count; ++p) {
            visit(y, p);
        }
    }
}

Springs paperSprings(const Fabric& f, const PaperOptions& options) {
    Springs out;
    forSegments(f, [&](const fabric::Yarn&, PointIndex p) {
        if (entryOf(f, p) != entryOf(f, p + 1)) {
            out.springs.push_back({entryOf(f, p), entryOf(f, p + 1), f.lengths[static_cast<std::size_t>(p)],
                                   options.pull, options.repel});
            out.points.push_back(p);
        }
    });
    return out;
}

std::vector<Bend> paperBends(const Fabric& f, double stiffness) {
    std::vector<Bend> bends;
    forSegments(f, [&](const fabric::Yarn& y, PointIndex p) {
        if (p > y.first) {
            const Bend b{entryOf(f, p - 1), entryOf(f, p), entryOf(f, p + 1), stiffness};
            if (b.before != b.middle && b.middle != b.after && b.before != b.after) {
                bends.push_back(b);
            }
        }
    });
    return bends;
}

std::unique_ptr<EnergyTerm> plates(const Fabric& f, const std::vector<Spring>& springs,
                                   std::span<const yarn::Yarn> yarns, const PreviewOptions& options) {
    double diameter = 0;
    for (const fabric::Yarn& y : f.yarns) {
        diameter = std::max(diameter, yarnOf(yarns, y.carrier).outerDiameterMm);
    }
    double stiffness = 0;
    for (const Spring& s : springs) {
        stiffness += s.pull / static_cast<double>(springs.size());
    }
    return std::make_unique<PlateTerm>(options.plateHalfGap * diameter, options.plateStiffness * stiffness);
}

/// Half of the yarn on either side of a bonding point belongs to its entry; kg.
Vector masses(const Fabric& f, std::span<const yarn::Yarn> yarns) {
    Vector mass = Vector::Zero(f.entryCount);
    double sum = 0;
    forSegments(f, [&](const fabric::Yarn& y, PointIndex p) {
        const double half = 0.5e-9 * yarnOf(yarns, y.carrier).tex *
                            f.lengths[static_cast<std::size_t>(p)]; // tex = 1e-9 kg/mm
        mass[entryOf(f, p)] += half;
        mass[entryOf(f, p + 1)] += half;
        sum += 2 * half;
    });
    const double mean = sum > 0 ? sum / f.entryCount : 1e-9;
    return mass.cwiseMax(0.1 * mean);
}

} // namespace

void BondingPointModel::tensions(const Vector& x, std::span<float> byPoint) const {
    std::fill(byPoint.begin(), byPoint.end(), 0.0F);
    for (std::size_t i = 0; i < springPoint.size(); ++i) {
        byPoint[static_cast<std::size_t>(springPoint[i])] =
            static_cast<float>(model->springs().tension(x, i));
    }
}

Vector machinePositions(const Fabric& f) {
    Vector x(Eigen::Index{3} * f.entryCount);
    for (Entry e = 0; e < f.entryCount; ++e) {
        at(x, e) = f.machinePositions[static_cast<std::size_t>(e)];
    }
    return x;
}

BondingPointModel buildBondingPointModel(const Fabric& f, std::span<const yarn::Yarn> yarns,
                                         const ModelOptions& options) {
    BondingPointModel result;
    std::vector<std::unique_ptr<EnergyTerm>> others;
    Springs springs;
    SpringLaw law;
    if (options.mode == ModelOptions::Mode::Paper) {
        springs = paperSprings(f, options.paper);
        law = options.paper.law;
        others.push_back(std::make_unique<BendTerm>(paperBends(f, options.paper.bend)));
    } else {
        const Strands strands = findStrands(f);
        springs = previewSprings(f, strands, yarns, options.preview);
        StitchMesh mesh = findStitchMesh(f, strands, yarns, options.preview);
        others.push_back(std::make_unique<StraightTerm>(mesh.straights));
        others.push_back(std::make_unique<CurlTerm>(std::move(mesh.curls)));
        others.push_back(std::make_unique<ShearTerm>(std::move(mesh.corners)));
        others.push_back(plates(f, springs.springs, yarns, options.preview));
    }
    auto ropes = std::make_unique<RopeTerm>(std::move(springs.ropes));
    result.ropes = ropes.get();
    others.push_back(std::move(ropes));
    const Vector positions = machinePositions(f);
    result.model = std::make_unique<Model>(
        std::make_unique<SpringTerm>(std::move(law), std::move(springs.springs)), std::move(others),
        masses(f, yarns), Eigen::Map<const Eigen::Matrix3Xd>(positions.data(), 3, f.entryCount));
    result.springPoint = std::move(springs.points);
    result.ropePoints = std::move(springs.ropePoints);
    return result;
}

} // namespace knittsim::physics
