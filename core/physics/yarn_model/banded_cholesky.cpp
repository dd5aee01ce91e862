#include "core/physics/yarn_model/banded_cholesky.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {

constexpr Eigen::Index kOpenWidth = 8;
constexpr Eigen::Index kClosedWidth = 14;

/// sum of a_k b_k. Two sums at a time: each has to wait for itself.
double product(const double* a, const double* b, Eigen::Index count) {
    double even = 0;
    double odd = 0;
    Eigen::Index k = 0;
    for (; k + 1 < count; k += 2) {
        even += a[k] * b[k];
        odd += a[k + 1] * b[k + 1];
    }
    return even + odd + (k < count ? a[k] * b[k] : 0);
}

/// `band`: n rows of kWidth + 1 numbers, the diagonal last; it holds its inverse afterwards.
template<Eigen::Index kWidth> bool factoriseRows(double* band, Eigen::Index n) {
    for (Eigen::Index i = 0; i < n; ++i) {
        double* const row = band + i * (kWidth + 1) + kWidth; // row[0] is the diagonal
        const Eigen::Index first = std::max<Eigen::Index>(0, i - kWidth);
        for (Eigen::Index j = first; j < i; ++j) {
            const double* const other = band + j * (kWidth + 1) + kWidth;
            const Eigen::Index from = std::max(first, j - kWidth);
            row[j - i] = (row[j - i] - product(row + (from - i), other + (from - j), j - from)) * other[0];
        }
        const double left = row[0] - product(row + (first - i), row + (first - i), i - first);
        if (!(left > 0) || !std::isfinite(left)) {
            return false;
        }
        row[0] = 1 / std::sqrt(left);
    }
    return true;
}

/// y := (L L^T)^-1 y. Sums in the order in which their parts come to be known.
template<Eigen::Index kWidth> void solveRows(const double* band, Eigen::Index n, double* y) {
    for (Eigen::Index i = 0; i < n; ++i) {
        const double* const row = band + i * (kWidth + 1);
        if (i < kWidth) {
            y[i] = (y[i] - product(row + (kWidth - i), y, i)) * row[kWidth];
            continue;
        }
        const double* const z = y + i - kWidth;
        double even = 0;
        double odd = 0;
        for (Eigen::Index k = 0; k < kWidth - 2; k += 2) {
            even += row[k] * z[k];
            odd += row[k + 1] * z[k + 1];
        }
        y[i] = ((y[i] - (even + odd)) - row[kWidth - 2] * z[kWidth - 2] - row[kWidth - 1] * z[kWidth - 1]) *
               row[kWidth];
    }
    for (Eigen::Index i = n - 1; i >= 0; --i) {
        const double* const row = band + i * (kWidth + 1);
        const double value = y[i] * row[kWidth];
        y[i] = value;
        const Eigen::Index first = std::max<Eigen::Index>(0, i - kWidth);
        if (first + kWidth == i) {
            for (Eigen::Index k = 0; k < kWidth; ++k) {
                y[first + k] -= row[k] * value;
            }
        } else {
            for (Eigen::Index k = 0; k < i; ++k) {
                y[k] -= row[k - i + kWidth] * value;
            }
        }
    }
}

} // namespace

BandedCholesky::BandedCholesky(Entry nodeCount, bool closed)
    : m_nodeCount(nodeCount), m_closed(closed), m_width(closed ? kClosedWidth : kOpenWidth),
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
    double* const band = m_band.data();
    const Eigen::Index n = Eigen::Index{3} * m_nodeCount;
    return m_closed ? factoriseRows<kClosedWidth>(band, n) : factoriseRows<kOpenWidth>(band, n);
}

Vector BandedCholesky::folded(const Eigen::Ref<const Vector>& v) const {
    Vector result(v.size());
    for (Entry node = 0; node < m_nodeCount; ++node) {
        result.segment<3>(place(node)) = v.segment<3>(Eigen::Index{3} * node);
    }
    return result;
}

void BandedCholesky::solve(Eigen::Ref<Vector> x) const {
    const Eigen::Index n = Eigen::Index{3} * m_nodeCount;
    if (!m_closed) {
        solveRows<kOpenWidth>(m_band.data(), n, x.data());
        return;
    }
    Vector y = folded(x);
    solveRows<kClosedWidth>(m_band.data(), n, y.data());
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
