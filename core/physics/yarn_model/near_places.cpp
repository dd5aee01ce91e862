#include "core/physics/yarn_model/near_places.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace knittsim::physics {

namespace {

/// Of all images only those above, or beside to the right: each pair is then met once.
bool isForward(int across, int up) {
    return up > 0 || (up == 0 && across > 0);
}

/// Boxes at least as wide as the range, row after row along x, so that three neighbouring boxes of a row are
/// one stretch of the members.
class Grid {
public:
    Grid(const Eigen::Matrix3Xd& points, const std::optional<Eigen::Vector2d>& cell, double range)
        : m_range(range) {
        m_low = points.rowwise().minCoeff();
        m_high = points.rowwise().maxCoeff();
        m_members.reserve(static_cast<std::size_t>(points.cols()));
        for (Eigen::Index i = 0; i < points.cols(); ++i) {
            m_members.push_back({points.col(i), {static_cast<Entry>(i), 0, 0}});
        }
        if (cell) {
            addImages(points, *cell);
        }
        cutBoxes();
        sort();
    }

    template<class Visit> void forNear(const Eigen::Vector3d& point, Visit visit) const {
        const Eigen::Array3<std::int64_t> centre = boxOf(point);
        const std::int64_t left = std::max<std::int64_t>(0, centre.x() - 1);
        const std::int64_t right = std::min(m_count.x() - 1, centre.x() + 1);
        for (std::int64_t z = std::max<std::int64_t>(0, centre.z() - 1);
             z <= std::min(m_count.z() - 1, centre.z() + 1); ++z) {
            for (std::int64_t y = std::max<std::int64_t>(0, centre.y() - 1);
                 y <= std::min(m_count.y() - 1, centre.y() + 1); ++y) {
                const std::size_t end = m_begin[index({right, y, z}) + 1];
                for (std::size_t i = m_begin[index({left, y, z})]; i < end; ++i) {
                    const Member& m = m_members[i];
                    if ((m.point - point).squaredNorm() < m_range * m_range) {
                        visit(m.place);
                    }
                }
            }
        }
    }

private:
    struct Member {
        Eigen::Vector3d point;
        Place place;
    };

    void addImages(const Eigen::Matrix3Xd& points, const Eigen::Vector2d& cell) {
        const Eigen::Vector3d extent = m_high - m_low;
        const int mostUp = static_cast<int>((extent.y() + m_range) / cell.y());
        const int mostAcross = static_cast<int>((extent.x() + m_range) / cell.x());
        for (int up = 0; up <= mostUp; ++up) {
            for (int across = -mostAcross; across <= mostAcross; ++across) {
                if (!isForward(across, up)) {
                    continue;
                }
                const Eigen::Vector3d shift(across * cell.x(), up * cell.y(), 0);
                for (Eigen::Index i = 0; i < points.cols(); ++i) {
                    const Eigen::Vector3d image = points.col(i) + shift;
                    if ((image.array() >= m_low.array() - m_range).all() &&
                        (image.array() <= m_high.array() + m_range).all()) {
                        m_members.push_back({image, {static_cast<Entry>(i), across, up}});
                    }
                }
            }
        }
        m_low.array() -= m_range;
        m_high.array() += m_range;
    }

    /// No more boxes than a few for each member, however far apart those lie.
    void cutBoxes() {
        constexpr double kBoxesPerMember = 8;
        const Eigen::Array3d extent = (m_high - m_low).array();
        const double most = kBoxesPerMember * static_cast<double>(m_members.size()) + 64;
        m_width = m_range;
        while ((extent / m_width + 1).prod() > most) {
            m_width *= 1.5;
        }
        m_count = (extent / m_width).floor().cast<std::int64_t>() + 1;
    }

    std::size_t index(const Eigen::Array3<std::int64_t>& box) const {
        return static_cast<std::size_t>((box.z() * m_count.y() + box.y()) * m_count.x() + box.x());
    }

    Eigen::Array3<std::int64_t> boxOf(const Eigen::Vector3d& point) const {
        const Eigen::Array3<std::int64_t> box =
            ((point - m_low) / m_width).array().floor().cast<std::int64_t>();
        return box.max(0).min(m_count - 1);
    }

    /// Counting sort by box.
    void sort() {
        m_begin.assign(static_cast<std::size_t>(m_count.prod()) + 1, 0);
        for (const Member& m : m_members) {
            ++m_begin[index(boxOf(m.point)) + 1];
        }
        for (std::size_t b = 1; b < m_begin.size(); ++b) {
            m_begin[b] += m_begin[b - 1];
        }
        std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
        std::vector<Member> sorted(m_members.size());
        for (const Member& m : m_members) {
            sorted[next[index(boxOf(m.point))]++] = m;
        }
        m_members.swap(sorted);
    }

    double m_range;
    double m_width = 1; ///< of a box
    Eigen::Vector3d m_low;
    Eigen::Vector3d m_high;
    Eigen::Array3<std::int64_t> m_count; ///< of boxes, by axis
    std::vector<Member> m_members;
    std::vector<std::size_t> m_begin; ///< by box, into m_members
};

} // namespace

std::vector<NearPair> findNearPairs(const Eigen::Matrix3Xd& points,
                                    const std::optional<Eigen::Vector2d>& cell, double range) {
    std::vector<NearPair> pairs;
    if (points.cols() == 0 || !points.allFinite()) {
        return pairs;
    }
    const Grid grid(points, cell, range);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const auto a = static_cast<Entry>(i);
        grid.forNear(points.col(i), [&](const Place& b) {
            if (b.isImage() || b.node > a) {
                pairs.push_back({a, b});
            }
        });
    }
    return pairs;
}

std::vector<NearPair> findNearPairsOf(const Eigen::Matrix3Xd& points, const std::vector<char>& chosen,
                                      double range) {
    std::vector<NearPair> pairs;
    if (points.cols() == 0 || !points.allFinite()) {
        return pairs;
    }
    const Grid grid(points, std::nullopt, range);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        if (chosen[static_cast<std::size_t>(i)] == 0) {
            continue;
        }
        const auto a = static_cast<Entry>(i);
        grid.forNear(points.col(i), [&](const Place& b) {
            const bool once = chosen[static_cast<std::size_t>(b.node)] == 0 || b.node > a;
            if (b.node != a && once) {
                pairs.push_back({std::min(a, b.node), {std::max(a, b.node), 0, 0}});
            }
        });
    }
    return pairs;
}

} // namespace knittsim::physics
