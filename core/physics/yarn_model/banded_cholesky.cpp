#include "core/physics/yarn_model/banded_cholesky.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

BandedCholesky::BandedCholesky(Entry nodeCount, bool closed)
    : m_nodeCount(nodeCount), m_closed(closed), m_width(closed ? 14 : 8),
      m_band(static_cast<std::size_t>(Eigen::Index{3} * nodeCount * (m_width + 1)), 0) {}

void BandedCholesky::setZero() {
    std::fill(m_band.begin(), m_band.end(), 0.0);
}

/// First scalar row of a node.
Eigen::Index BandedCholesky::place(Entry node) const {
    if (!m_closed) {
        return Eigen::Index{3} * node;
    }
    const Entry back = m_nodeCount - 1 - node;
    return Eigen::Index{3} * (node <= back ? 2 * node : 2 * back + 1);
}

void BandedCholesky::add(Entry i, Entry j, const Matrix3& block) {
    const Eigen::Index row = place(i);
    const Eigen::Index column = place(j);
    for (Eigen::Index r = 0; r < 3; ++r) {
        for (Eigen::Index c = 0; c < 3; ++c) {
            if (row + r >= column + c) {
                band(row + r, column + c) += block(r, c);
            }
        }
    }
}

bool BandedCholesky::factorise() {
    const Eigen::Index n = Eigen::Index{3} * m_nodeCount;
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Index first = std::max<Eigen::Index>(0, i - m_width);
        for (Eigen::Index j = first; j <= i; ++j) {
            double sum = band(i, j);
            for (Eigen::Index k = std::max(first, j - m_width); k < j; ++k) {
                sum -= band(i, k) * band(j, k);
            }
            if (j < i) {
                band(i, j) = sum * band(j, j); // the diagonal holds its inverse
            } else if (sum > 0 && std::isfinite(sum)) {
                band(i, i) = 1 / std::sqrt(sum);
            } else {
                return false;
            }
        }
    }
    return true;
}

Vector BandedCholesky::folded(const Eigen::Ref<const Vector>& v) const {
    Vector result(v.size());
    for (Entry node = 0; node < m_nodeCount; ++node) {
        result.segment<3>(place(node)) = v.segment<3>(Eigen::Index{3} * node);
    }
    return result;
}

/// The rows of an open chain, all of one width: sums in the order in which their parts come to be known.
void BandedCholesky::solveOpen(double* y) const {
    constexpr Eigen::Index kWidth = 8;
    const Eigen::Index n = Eigen::Index{3} * m_nodeCount;
    for (Eigen::Index i = 0; i < n; ++i) {
        const double* row = &m_band[static_cast<std::size_t>(i * (kWidth + 1))];
        if (i < kWidth) {
            double sum = y[i];
            for (Eigen::Index k = 0; k < i; ++k) {
                sum -= row[k - i + kWidth] * y[k];
            }
            y[i] = sum * row[kWidth];
            continue;
        }
        const double* z = y + i - kWidth;
        const double old = row[0] * z[0] + row[1] * z[1] + (row[2] * z[2] + row[3] * z[3]);
        const double middle = row[4] * z[4] + row[5] * z[5];
        y[i] = (((y[i] - old) - middle) - row[6] * z[6] - row[7] * z[7]) * row[kWidth];
    }
    for (Eigen::Index i = n - 1; i >= 0; --i) {
        const double* row = &m_band[static_cast<std::size_t>(i * (kWidth + 1))];
        const double value = y[i] * row[kWidth];
        y[i] = value;
        if (i >= kWidth) {
            double* z = y + i - kWidth;
            for (Eigen::Index k = 0; k < kWidth; ++k) {
                z[k] -= row[k] * value;
            }
        } else {
            for (Eigen::Index k = 0; k < i; ++k) {
                y[k] -= row[k - i + kWidth] * value;
            }
        }
    }
}

void BandedCholesky::solve(Eigen::Ref<Vector> x) const {
    if (!m_closed) {
        solveOpen(x.data());
        return;
    }
    const Eigen::Index n = Eigen::Index{3} * m_nodeCount;
    Vector y = folded(x);
    for (Eigen::Index i = 0; i < n; ++i) {
        double sum = y[i];
        for (Eigen::Index k = std::max<Eigen::Index>(0, i - m_width); k < i; ++k) {
            sum -= band(i, k) * y[k];
        }
        y[i] = sum * band(i, i);
    }
    for (Eigen::Index i = n - 1; i >= 0; --i) {
        y[i] *= band(i, i);
        for (Eigen::Index k = std::max<Eigen::Index>(0, i - m_width); k < i; ++k) {
            y[k] -= band(i, k) * y[i];
        }
    }
    for (Entry node = 0; node < m_nodeCount; ++node) {
        x.segment<3>(Eigen::Index{3} * node) = y.segment<3>(place(node));
    }
}

double BandedCholesky::square(const Eigen::Ref<const Vector>& v) const {
    const Vector y = folded(v);
    Vector product = Vector::Zero(y.size()); // L^T y
    for (Eigen::Index i = 0; i < y.size(); ++i) {
        for (Eigen::Index k = std::max<Eigen::Index>(0, i - m_width); k < i; ++k) {
            product[k] += band(i, k) * y[i];
        }
        product[i] += y[i] / band(i, i);
    }
    return product.squaredNorm();
}

} // namespace knittsim::physics
