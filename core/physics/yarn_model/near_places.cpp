#include "core/physics/yarn_model/near_places.h"

#include <bit>
#include <cmath>
#include <cstdint>

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
            m_members.push_back({points.col(i), {static_cast<Entry>(i), 0, 0}, 0});
        }
        if (cell) {
            addImages(points, *cell);
        }
        sort();
    }

    template<class Visit> void forNear(const Eigen::Vector3d& point, Visit visit) const {
        const std::uint64_t centre = boxOf(point);
        for (int dz = -1; dz <= 1; ++dz) {
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const std::uint64_t box = beside(centre, dx, dy, dz);
                    const std::size_t bucket = bucketOf(box);
                    for (std::size_t i = m_begin[bucket]; i < m_begin[bucket + 1]; ++i) {
                        const Member& m = m_members[i];
                        if (m.box == box && (m.point - point).squaredNorm() < m_range * m_range) {
                            visit(m.place);
                        }
                    }
                }
            }
        }
    }

private:
    struct Member {
        Eigen::Vector3d point;
        Place place;
        std::uint64_t box = 0;
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
                        m_members.push_back({image, {static_cast<Entry>(i), across, up}, 0});
                    }
                }
            }
        }
    }

    /// A box's three numbers in one, 21 bits each.
    static std::uint64_t packed(std::int64_t x, std::int64_t y, std::int64_t z) {
        constexpr std::int64_t kMiddle = 1 << 20;
        constexpr std::uint64_t kMask = (1U << 21U) - 1;
        const auto bits = [](std::int64_t i) { return static_cast<std::uint64_t>(i + kMiddle) & kMask; };
        return bits(x) | bits(y) << 21U | bits(z) << 42U;
    }

    static std::uint64_t beside(std::uint64_t box, int dx, int dy, int dz) {
        return box +
               static_cast<std::uint64_t>(dx + dy * (std::int64_t{1} << 21) + dz * (std::int64_t{1} << 42));
    }

    std::uint64_t boxOf(const Eigen::Vector3d& point) const {
        const Eigen::Array3d box = ((point - m_low) / m_range).array().floor();
        return packed(static_cast<std::int64_t>(box.x()), static_cast<std::int64_t>(box.y()),
                      static_cast<std::int64_t>(box.z()));
    }

    std::size_t bucketOf(std::uint64_t box) const {
        const std::uint64_t hash = box * 0x9E3779B97F4A7C15U;
        return static_cast<std::size_t>(hash >> 20U) & m_mask;
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
        std::vector<Member> sorted(m_members.size());
        for (const Member& m : m_members) {
            sorted[next[bucketOf(m.box)]++] = m;
        }
        m_members.swap(sorted);
    }

    double m_range;
    Eigen::Vector3d m_low;
    Eigen::Vector3d m_high;
    std::size_t m_mask = 0;
    std::vector<Member> m_members;
    std::vector<std::size_t> m_begin; ///< by bucket, into m_members
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
