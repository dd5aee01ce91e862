#include "core/export/stroke_order.h"
#include "core/geometry/projected_crossings.h"
#include "tests/unit/export/swatch.h"

#include <Eigen/Geometry>

#include <cmath>
#include <sstream>

namespace knittsim::exports {
namespace {

constexpr float kMostMm = 0.4F;

struct Line {
    std::string kind; ///< class: e0, b0, d0, ...
    std::vector<Eigen::Vector2f> places;
};

std::vector<Line> readPaths(const std::string& svg) {
    std::vector<Line> lines;
    for (std::size_t at = svg.find("<path "); at != std::string::npos; at = svg.find("<path ", at + 1)) {
        const auto attribute = [&](const std::string& name) {
            const std::size_t from = svg.find(' ' + name + "=\"", at) + name.size() + 3;
            return svg.substr(from, svg.find('"', from) - from);
        };
        Line& line = lines.emplace_back();
        line.kind = attribute("class");
        std::string path = attribute("d");
        for (char& c : path) {
            c = c == 'M' || c == 'L' ? ' ' : c;
        }
        std::istringstream numbers(path);
        for (Eigen::Vector2f p; numbers >> p.x() >> p.y();) {
            line.places.push_back(p);
        }
    }
    return lines;
}

float distance(const Line& line, const Eigen::Vector2f& p) {
    float nearest = 1e9F;
    for (std::size_t i = 1; i < line.places.size(); ++i) {
        const Eigen::Vector2f way = line.places[i] - line.places[i - 1];
        const float square = std::max(1e-12F, way.squaredNorm());
        const float share = std::clamp((p - line.places[i - 1]).dot(way) / square, 0.0F, 1.0F);
        nearest = std::min(nearest, (line.places[i - 1] + share * way - p).norm());
    }
    return nearest;
}

/// Strokes that hold a place along a yarn; two where they meet.
bool holds(const Stroke& stroke, std::size_t yarn, float arc) {
    return stroke.yarn == yarn && stroke.from <= arc && arc <= stroke.to;
}

class StrokeOrder : public testing::TestWithParam<bool> {};

TEST_P(StrokeOrder, PaintsTheNearerStrandLaterAtEveryCrossing) {
    const bool back = GetParam();
    const Shape shape = swatch();
    const std::vector<Stroke> strokes = strokesInOrder(shape.curves, kMostMm, back);
    const auto crossings = projectCrossings(shape.curves);
    ASSERT_GT(crossings.size(), 100u);
    const auto lastWith = [&](std::int32_t node, float share) {
        const auto n = static_cast<std::size_t>(node);
        const float arc = shape.curves.arc[n] + share * (shape.curves.arc[n + 1] - shape.curves.arc[n]);
        const std::size_t yarn = yarnAt(shape.curves, node);
        std::ptrdiff_t last = -1;
        for (std::size_t s = 0; s < strokes.size(); ++s) {
            last = holds(strokes[s], yarn, arc) ? static_cast<std::ptrdiff_t>(s) : last;
        }
        return last;
    };
    for (const geometry::ProjectedCrossing& crossing : crossings) {
        const auto over = lastWith(crossing.over, crossing.overShare);
        const auto under = lastWith(crossing.under, crossing.underShare);
        EXPECT_TRUE(back ? under > over : over > under) << crossing.over << ' ' << crossing.under;
    }
}

TEST_P(StrokeOrder, CoversEveryYarnOnce) {
    const Shape shape = swatch();
    std::vector<double> length(shape.curves.yarns.size(), 0);
    for (const Stroke& stroke : strokesInOrder(shape.curves, kMostMm, GetParam())) {
        EXPECT_LE(stroke.to - stroke.from, kMostMm * 1.001F);
        length[stroke.yarn] += stroke.to - stroke.from;
    }
    for (std::size_t y = 0; y < length.size(); ++y) {
        const geometry::YarnCurves::Range& yarn = shape.curves.yarns[y];
        EXPECT_NEAR(length[y], shape.curves.arc[static_cast<std::size_t>(yarn.first + yarn.count - 1)], 0.01);
    }
}

INSTANTIATE_TEST_SUITE_P(Sides, StrokeOrder, testing::Bool());

TEST_F(ExportTest, SvgShowsMillimetresAndMirrorsTheBack) {
    const Shape shape = swatch();
    const std::string front = written("f.svg", shape);
    const std::string back = written("b.svg", shape, {.back = true});
    float width = 0;
    float height = 0;
    ASSERT_EQ(
        std::sscanf(front.c_str() + front.find("width="), "width=\"%fmm\" height=\"%fmm\"", &width, &height),
        2);
    const auto box = [](const std::vector<Line>& lines) {
        Eigen::AlignedBox2f all;
        for (const Line& line : lines) {
            for (const Eigen::Vector2f& p : line.places) {
                all.extend(p);
            }
        }
        return all;
    };
    const auto frontLines = readPaths(front);
    const auto frontBox = box(frontLines);
    const auto backBox = box(readPaths(back));
    EXPECT_GT(frontBox.min().x(), 0);
    EXPECT_LT(frontBox.max().x(), width);
    EXPECT_GT(frontBox.min().y(), 0);
    EXPECT_LT(frontBox.max().y(), height);
    EXPECT_NEAR(frontBox.min().x(), width - backBox.max().x(), 2e-3);
    float low = 1e9F;
    float high = -1e9F;
    for (const Vec3f& node : shape.curves.nodes) {
        low = std::min(low, node.x());
        high = std::max(high, node.x());
    }
    EXPECT_NEAR(frontBox.sizes().x(), high - low, 5e-3);
    // Edge, body and dots, always in this order.
    ASSERT_EQ(frontLines.size() % 3, 0u);
    for (std::size_t i = 0; i < frontLines.size(); ++i) {
        EXPECT_EQ(frontLines[i].kind[0], "ebd"[i % 3]);
    }
}

TEST_F(ExportTest, SvgEndsEveryCrossingWithTheStrandInFront) {
    const Shape shape = swatch(4);
    const auto lines = readPaths(written("f.svg", shape));
    // From the file alone: the last body over a crossing runs along the strand in front.
    float left = 1e9F;
    float top = -1e9F;
    for (const Vec3f& node : shape.curves.nodes) {
        left = std::min(left, node.x() - 0.4F);
        top = std::max(top, node.y() + 0.4F);
    }
    std::size_t looked = 0;
    std::size_t right = 0;
    for (const auto& crossing : projectCrossings(shape.curves)) {
        const auto o = static_cast<std::size_t>(crossing.over);
        const Vec3f place =
            shape.curves.nodes[o] + crossing.overShare * (shape.curves.nodes[o + 1] - shape.curves.nodes[o]);
        const Eigen::Vector2f p(place.x() - left, top - place.y());
        const Line* last = nullptr;
        for (const Line& line : lines) {
            last = line.kind[0] == 'b' && distance(line, p) < 0.02F ? &line : last;
        }
        ASSERT_NE(last, nullptr);
        const auto u = static_cast<std::size_t>(crossing.under);
        const Vec3f over = shape.curves.nodes[o + 1] - shape.curves.nodes[o];
        const Vec3f under = shape.curves.nodes[u + 1] - shape.curves.nodes[u];
        const Vec3f a = over.normalized();
        const Vec3f b = under.normalized();
        if (std::abs(a.x() * b.y() - a.y() * b.x()) < 0.5F) {
            continue; // too flat to tell the strands apart by direction
        }
        std::size_t nearest = 1;
        for (std::size_t i = 1; i < last->places.size(); ++i) {
            const auto middle = [&](std::size_t k) {
                return (0.5F * (last->places[k] + last->places[k - 1]) - p).norm();
            };
            nearest = middle(i) < middle(nearest) ? i : nearest;
        }
        const Eigen::Vector2f way = (last->places[nearest] - last->places[nearest - 1]).normalized();
        const Eigen::Vector2f flatOver = Eigen::Vector2f(over.x(), -over.y()).normalized();
        const Eigen::Vector2f flatUnder = Eigen::Vector2f(under.x(), -under.y()).normalized();
        ++looked;
        right += std::abs(way.dot(flatOver)) > std::abs(way.dot(flatUnder)) ? 1U : 0U;
    }
    EXPECT_GT(looked, 50u);
    EXPECT_EQ(right, looked);
}

} // namespace
} // namespace knittsim::exports
