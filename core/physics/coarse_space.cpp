#include "core/physics/coarse_space.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {

/// Sums 3x3 blocks by patch; keeps the lower triangle. Rows are short, so a search along them is quick.
class PatchSums final : public BlockSink {
public:
    PatchSums(const std::vector<int>& patch, int count)
        : m_patch(patch), m_rows(static_cast<std::size_t>(count)) {
        for (int p = 0; p < count; ++p) {
            m_rows[static_cast<std::size_t>(p)].push_back({p, Matrix3::Zero()});
        }
    }

    void add(Entry row, Entry column, const Matrix3& block) override {
        addToPatch(m_patch[static_cast<std::size_t>(row)], m_patch[static_cast<std::size_t>(column)], block);
    }

    void addToPatch(int row, int column, const Matrix3& block) {
        if (row < column) {
            return;
        }
        auto& blocks = m_rows[static_cast<std::size_t>(row)];
        for (Block& b : blocks) {
            if (b.column == column) {
                b.value += block;
                return;
            }
        }
        blocks.push_back({column, block});
    }

    std::vector<Eigen::Triplet<double>> triplets() const {
        std::vector<Eigen::Triplet<double>> result;
        for (std::size_t row = 0; row < m_rows.size(); ++row) {
            for (const Block& b : m_rows[row]) {
                for (int i = 0; i < 3; ++i) {
                    for (int j = 0; j < 3; ++j) {
                        const int r = 3 * static_cast<int>(row) + i;
                        const int c = 3 * b.column + j;
                        if (r >= c) {
                            result.emplace_back(r, c, b.value(i, j));
                        }
                    }
                }
            }
        }
        return result;
    }

private:
    struct Block {
        int column;
        Matrix3 value;
    };

    const std::vector<int>& m_patch;
    std::vector<std::vector<Block>> m_rows;
};

/// Of two compressed matrices.
bool hasSamePattern(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
    return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
           std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

} // namespace

void CoarseSpace::cut(const Model& model, int entriesAcross) {
    const Eigen::Matrix3Xd& layout = model.layout();
    m_patchCount = 0;
    m_usable = false;
    m_matrix.resize(0, 0);
    m_patch.clear();
    if (layout.cols() == 0) {
        return;
    }
    const double entries = static_cast<double>(layout.cols());
    const double across = std::max<double>(entriesAcross, std::sqrt(entries / (0.8 * kMostPatches)));
    const Eigen::Vector3d low = layout.rowwise().minCoeff();
    const Eigen::Vector3d extent = layout.rowwise().maxCoeff() - low;
    const double least = std::max(1e-6, 0.01 * extent.maxCoeff());
    const double width = std::max(extent.x(), least);
    const double height = std::max(extent.y(), least);
    // An entry's own share of the width and height, were they spread evenly over a rectangle of that shape.
    const double cell = across * std::sqrt(width * height / entries);
    const double middle = low.z() + 0.5 * extent.z();
    const auto columns = static_cast<std::size_t>(width / cell) + 1;
    const auto rows = static_cast<std::size_t>(height / cell) + 1;

    std::vector<int> numbers(2 * columns * rows, -1);
    m_patch.reserve(static_cast<std::size_t>(layout.cols()));
    for (Eigen::Index e = 0; e < layout.cols(); ++e) {
        const auto column = static_cast<std::size_t>((layout(0, e) - low.x()) / cell);
        const auto row = static_cast<std::size_t>((layout(1, e) - low.y()) / cell);
        const std::size_t sheet = layout(2, e) > middle ? 1 : 0;
        int& number = numbers[(row * columns + column) * 2 + sheet];
        if (number < 0) {
            number = m_patchCount++;
        }
        m_patch.push_back(number);
    }
}

bool CoarseSpace::build(const Model& model, double massFactor) {
    PatchSums sums(m_patch, m_patchCount);
    model.addBlocks(sums);
    const double ground = 1e-6 * model.stiffnessScale();
    for (int p = 0; p < m_patchCount; ++p) {
        sums.addToPatch(p, p, ground * Matrix3::Identity());
    }
    for (Entry e = 0; e < model.entryCount(); ++e) {
        const double pin = model.isPinned(e) ? model.stiffnessScale() : 0;
        sums.add(e, e, (pin + massFactor * model.mass()[e]) * Matrix3::Identity());
    }
    const auto triplets = sums.triplets();
    Eigen::SparseMatrix<double> matrix(3 * m_patchCount, 3 * m_patchCount);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    // Energies that act only now and then come and go in the pattern.
    const bool asBefore = hasSamePattern(matrix, m_matrix);
    m_matrix.swap(matrix);
    if (!asBefore) {
        m_solver.analyzePattern(m_matrix);
    }
    m_solver.factorize(m_matrix);
    m_usable = m_solver.info() == Eigen::Success;
    return m_usable;
}

void CoarseSpace::apply(const Vector& r, Vector& z) const {
    if (!m_usable) {
        return;
    }
    Vector sums = Vector::Zero(Eigen::Index{3} * m_patchCount);
    for (std::size_t e = 0; e < m_patch.size(); ++e) {
        at(sums, m_patch[e]) += at(r, static_cast<Entry>(e));
    }
    const Vector moves = m_solver.solve(sums);
    for (std::size_t e = 0; e < m_patch.size(); ++e) {
        at(z, static_cast<Entry>(e)) += at(moves, m_patch[e]);
    }
}

} // namespace knittsim::physics
