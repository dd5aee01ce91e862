#include "core/physics/rope_term.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {
constexpr double kTiny = 1e-12; // mm; below, a piece has no direction
}

void RopeTerm::add(const std::vector<Entry>& way, double rest, double stiffness) {
    m_ropes.push_back({m_way.size(), way.size(), rest, stiffness});
    m_way.insert(m_way.end(), way.begin(), way.end());
}

double RopeTerm::excess(const Vector& x, const Rope& rope) const {
    double way = 0;
    for (std::size_t i = 0; i + 1 < rope.count; ++i) {
        way += (at(x, entry(rope, i + 1)) - at(x, entry(rope, i))).norm();
    }
    return way - rope.rest;
}

double RopeTerm::tension(const Vector& x, std::size_t rope) const {
    return m_ropes[rope].stiffness * std::max(0.0, excess(x, m_ropes[rope]));
}

double RopeTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (const Rope& rope : m_ropes) {
        const double delta = excess(x, rope);
        if (delta <= 0) {
            continue;
        }
        energy += 0.5 * rope.stiffness * delta * delta;
        if (gradient == nullptr) {
            continue;
        }
        for (std::size_t i = 0; i + 1 < rope.count; ++i) {
            const Eigen::Vector3d piece = at(x, entry(rope, i + 1)) - at(x, entry(rope, i));
            const double length = piece.norm();
            if (length > kTiny) {
                const Eigen::Vector3d force = piece * (rope.stiffness * delta / length);
                at(*gradient, entry(rope, i + 1)) += force;
                at(*gradient, entry(rope, i)) -= force;
            }
        }
    }
    return energy;
}

void RopeTerm::linearise(const Vector& x) {
    m_taut.clear();
    for (std::size_t r = 0; r < m_ropes.size(); ++r) {
        const Rope& rope = m_ropes[r];
        const double delta = excess(x, rope);
        if (delta <= 0) {
            continue;
        }
        Taut taut{r, std::vector<Eigen::Vector3d>(rope.count, Eigen::Vector3d::Zero()), {}};
        for (std::size_t i = 0; i + 1 < rope.count; ++i) {
            const Eigen::Vector3d piece = at(x, entry(rope, i + 1)) - at(x, entry(rope, i));
            const double length = std::max(piece.norm(), kTiny);
            const Eigen::Vector3d t = piece / length;
            taut.slope[i] -= std::sqrt(rope.stiffness) * t;
            taut.slope[i + 1] += std::sqrt(rope.stiffness) * t;
            // A piece shorter than the excess would be stiffer across than along; that much is not needed.
            const double across = std::min(rope.stiffness * delta / length, rope.stiffness);
            taut.across.push_back(across * (Matrix3::Identity() - t * t.transpose()));
        }
        m_taut.push_back(std::move(taut));
    }
}

void RopeTerm::multiply(const Vector& v, Vector& y) const {
    for (const Taut& taut : m_taut) {
        const Rope& rope = m_ropes[taut.rope];
        double stretch = 0;
        for (std::size_t i = 0; i < rope.count; ++i) {
            stretch += taut.slope[i].dot(at(v, entry(rope, i)));
        }
        for (std::size_t i = 0; i < rope.count; ++i) {
            at(y, entry(rope, i)) += stretch * taut.slope[i];
        }
        for (std::size_t i = 0; i + 1 < rope.count; ++i) {
            const Eigen::Vector3d force =
                taut.across[i] * (at(v, entry(rope, i + 1)) - at(v, entry(rope, i)));
            at(y, entry(rope, i + 1)) += force;
            at(y, entry(rope, i)) -= force;
        }
    }
}

void RopeTerm::addDiagonal(Eigen::Matrix3Xd& blocks) const {
    const auto block = [&](Entry e) { return blocks.middleCols<3>(Eigen::Index{3} * e); };
    for (const Taut& taut : m_taut) {
        const Rope& rope = m_ropes[taut.rope];
        for (std::size_t i = 0; i < rope.count; ++i) {
            block(entry(rope, i)) += taut.slope[i] * taut.slope[i].transpose();
        }
        for (std::size_t i = 0; i + 1 < rope.count; ++i) {
            block(entry(rope, i)) += taut.across[i];
            block(entry(rope, i + 1)) += taut.across[i];
        }
    }
}

void RopeTerm::addBlocks(BlockSink& sink) const {
    for (const Taut& taut : m_taut) {
        const Rope& rope = m_ropes[taut.rope];
        for (std::size_t i = 0; i < rope.count; ++i) {
            for (std::size_t j = 0; j < rope.count; ++j) {
                sink.add(entry(rope, i), entry(rope, j), taut.slope[i] * taut.slope[j].transpose());
            }
        }
        for (std::size_t i = 0; i + 1 < rope.count; ++i) {
            const Entry a = entry(rope, i);
            const Entry b = entry(rope, i + 1);
            sink.add(a, a, taut.across[i]);
            sink.add(b, b, taut.across[i]);
            sink.add(a, b, -taut.across[i]);
            sink.add(b, a, -taut.across[i]);
        }
    }
}

} // namespace knittsim::physics
