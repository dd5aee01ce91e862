#pragma once

#include "core/physics/yarn_model/chains.h"

#include <algorithm>
#include <array>
#include <vector>

namespace knittsim::physics {

/// A weighted difference of places: J x = sum of weight_k x(place_k). The weights sum to 0.
template<std::size_t Count> struct Stencil {
    std::array<Place, Count> places;
    std::array<double, Count> weights;

    Eigen::Vector3d of(const Vector& x, Entry cell) const {
        Eigen::Vector3d result = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < Count; ++k) {
            result += weights[k] * position(x, cell, places[k]);
        }
        return result;
    }

    /// y += J^T value
    void spread(const Eigen::Vector3d& value, Vector& y, Entry cell) const {
        for (std::size_t k = 0; k < Count; ++k) {
            addAt(y, cell, places[k], weights[k] * value);
        }
    }

    bool hasImages() const {
        return std::any_of(places.begin(), places.end(), [](const Place& p) { return p.isImage(); });
    }

    /// Its part that moves with the cell: J x = ... + reach * x(cell), by coordinate.
    Eigen::Vector3d reach() const {
        Eigen::Vector3d result = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < Count; ++k) {
            result.x() += weights[k] * places[k].across;
            result.y() += weights[k] * places[k].up;
        }
        return result;
    }
};

/// Two places, or points between places, that press on each other.
template<std::size_t Count> struct Press {
    Stencil<Count> apart;      ///< from the first to the second; their nodes begin and end it
    Eigen::Vector3d direction; ///< of `apart`, unit
    double force = 0;          ///< >= 0
};

/// Sum of J^T S J over stencils J with symmetric 3x3 matrices S: the Hessian of an energy of differences.
template<std::size_t Count> class StencilHessian {
public:
    struct Part {
        Stencil<Count> stencil;
        Matrix3 stiffness;
    };

    explicit StencilHessian(Entry cell) : m_cell(cell) {}

    Entry cell() const { return m_cell; }
    std::vector<Part>& parts() { return m_parts; }

    void multiply(const Vector& v, Vector& y) const {
        for (const Part& part : m_parts) {
            if (m_cell >= 0 && part.stencil.hasImages()) {
                part.stencil.spread(part.stiffness * part.stencil.of(v, m_cell), y, m_cell);
            } else {
                multiplyWithoutImages(part, v, y);
            }
        }
    }

    void addDiagonal(Eigen::Matrix3Xd& blocks) const {
        const auto block = [&](Entry e) { return blocks.middleCols<3>(Eigen::Index{3} * e); };
        forBlocks([&](Entry row, Entry column, const Matrix3& value) {
            if (row == column) {
                block(row) += value;
            }
        });
    }

    void addBlocks(BlockSink& sink) const {
        forBlocks([&](Entry row, Entry column, const Matrix3& value) { sink.add(row, column, value); });
    }

private:
    /// Most of the work of a solver.
    static void multiplyWithoutImages(const Part& part, const Vector& v, Vector& y) {
        const double* from = v.data();
        double* to = y.data();
        double j[3] = {0, 0, 0};
        for (std::size_t k = 0; k < Count; ++k) {
            const double* p = from + std::ptrdiff_t{3} * part.stencil.places[k].node;
            const double w = part.stencil.weights[k];
            j[0] += w * p[0];
            j[1] += w * p[1];
            j[2] += w * p[2];
        }
        const double* s = part.stiffness.data(); // symmetric
        const double f[3] = {s[0] * j[0] + s[1] * j[1] + s[2] * j[2], s[3] * j[0] + s[4] * j[1] + s[5] * j[2],
                             s[6] * j[0] + s[7] * j[1] + s[8] * j[2]};
        for (std::size_t k = 0; k < Count; ++k) {
            double* p = to + std::ptrdiff_t{3} * part.stencil.places[k].node;
            const double w = part.stencil.weights[k];
            p[0] += w * f[0];
            p[1] += w * f[1];
            p[2] += w * f[2];
        }
    }

    template<class Visit> void forBlocks(Visit visit) const {
        for (const Part& part : m_parts) {
            const Stencil<Count>& s = part.stencil;
            for (std::size_t k = 0; k < Count; ++k) {
                for (std::size_t l = 0; l < Count; ++l) {
                    visit(s.places[k].node, s.places[l].node,
                          Matrix3(s.weights[k] * s.weights[l] * part.stiffness));
                }
            }
            const Eigen::Vector3d reach = s.reach();
            if (reach.isZero(0)) {
                continue;
            }
            for (std::size_t k = 0; k < Count; ++k) {
                const Matrix3 block = s.weights[k] * part.stiffness * reach.asDiagonal();
                visit(s.places[k].node, m_cell, block);
                visit(m_cell, s.places[k].node, Matrix3(block.transpose()));
            }
            visit(m_cell, m_cell, Matrix3(reach.asDiagonal() * part.stiffness * reach.asDiagonal()));
        }
    }

    Entry m_cell;
    std::vector<Part> m_parts;
};

} // namespace knittsim::physics
