#include "core/physics/yarn_model/near_places.h"

#include <array>
#include <bit>
#include <cmath>

namespace knittsim::physics {

namespace {

/// Of all images only those above, or beside to the right: each pair is then met once.
bool isForward(int across, int up) {
    return up > 0 || (up == 0 && across > 0);
}

class Grid {
public:
    Grid(const Eigen::Matrix3Xd& points, const std::optional<Eigen::Vector2d>& cell, double range)
        : m_range(range) {
        m_low = points.rowwise().minCoeff();
        m_high = points.rowwise().maxCoeff();
        for (Eigen::Index i = 0; i < points.cols(); ++i) {
            m_members.push_back({points.col(i), {static_cast<Entry>(i), 0, 0}, {}});
        }
        if (cell) {
            addImages(points, *cell);
        }
        sort();
    }

    template<class Visit> void forNear(const Eigen::Vector3d& point, Visit visit) const {
        const Box centre = boxOf(point);
        for (int dz = -1; dz <= 1; ++dz) {
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const Box box{centre[0] + dx, centre[1] + dy, centre[2] + dz};
                    const std::size_t bucket = bucketOf(box);
                    for (std::size_t i = m_begin[bucket]; i < m_begin[bucket + 1]; ++i) {
                        const Member& m = m_members[m_sorted[i]];
                        if (m.box == box && (m.point - point).squaredNorm() < m_range * m_range) {
                            visit(m.place);
                        }
                    }
                }
            }
        }
    }

private:
    using Box = std::array<int, 3>;
    struct Member {
        Eigen::Vector3d point;
        Place place;
        Box box;
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
                        m_members.push_back({image, {static_cast<Entry>(i), across, up}, {}});
                    }
                }
            }
        }
    }

    Box boxOf(const Eigen::Vector3d& point) const {
        Box box{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto d = static_cast<Eigen::Index>(k);
            box[k] = static_cast<int>(std::floor((point[d] - m_low[d]) / m_range));
        }
        return box;
    }

    std::size_t bucketOf(const Box& box) const {
        const auto u = [](int i) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(i)); };
        std::uint64_t hash = u(box[0]) * 0x9E3779B97F4A7C15U;
        hash ^= u(box[1]) * 0xC2B2AE3D27D4EB4FU;
        hash ^= u(box[2]) * 0x165667B19E3779F9U;
        return static_cast<std::size_t>(hash ^ (hash >> 32U)) & m_mask;
    }

    /// Counting sort by bucket.
    void sort() {
        m_mask = std::bit_ceil(m_members.size() + 1) - 1;
        m_begin.assign(m_mask + 2, 0);
        for (Member& m : m_members) {
            m.box = boxOf(m.point);
            ++m_begin[bucketOf(m.box) + 1];
        }
        for (std::size_t b = 1; b < m_begin.size(); ++b) {
            m_begin[b] += m_begin[b - 1];
        }
        std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
        m_sorted.resize(m_members.size());
        for (std::size_t i = 0; i < m_members.size(); ++i) {
            m_sorted[next[bucketOf(m_members[i].box)]++] = i;
        }
    }

    double m_range;
    Eigen::Vector3d m_low;
    Eigen::Vector3d m_high;
    std::size_t m_mask = 0;
    std::vector<Member> m_members;
    std::vector<std::size_t> m_begin; ///< by bucket, into m_sorted
    std::vector<std::size_t> m_sorted;
};

} // namespace

std::vector<NearPair> findNearPairs(const Eigen::Matrix3Xd& points,
                                    const std::optional<Eigen::Vector2d>& cell, double range) {
    std::vector<NearPair> pairs;
    if (points.cols() == 0) {
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

} // namespace knittsim::physics
