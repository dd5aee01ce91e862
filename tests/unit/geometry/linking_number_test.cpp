#include "core/geometry/linking_number.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace knittsim::geometry {
namespace {

using Polyline = std::vector<Vec3>;

Polyline circle(const Vec3& centre, const Vec3& u, const Vec3& v, int points = 40) {
    Polyline line;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        line.push_back(centre + std::cos(angle) * u + std::sin(angle) * v);
    }
    return line;
}

const Polyline kFlat = circle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});

/// Winds `times` around the circle kFlat on a thin torus and closes.
Polyline aroundFlat(int times) {
    Polyline line;
    for (int i = 0; i < 200; ++i) {
        const double t = 2 * std::numbers::pi * i / 200;
        const double radius = 1 + 0.4 * std::cos(times * t);
        line.emplace_back(radius * std::cos(t), radius * std::sin(t), 0.4 * std::sin(times * t));
    }
    return line;
}

Polyline reversed(const Polyline& line) {
    return {line.rbegin(), line.rend()};
}

// Right-hand rule: with the fingers along kFlat the thumb points up, and the other circle runs up where it
// goes through the middle of it.
TEST(LinkingNumber, HopfLinkIsOneWithTheSignOfTheHand) {
    const Polyline up = circle({1, 0, 0}, {-1, 0, 0}, {0, 0, 1});
    EXPECT_NEAR(linkingNumber(kFlat, up), 1, 1e-9);
    EXPECT_NEAR(linkingNumber(kFlat, reversed(up)), -1, 1e-9);
    EXPECT_NEAR(linkingNumber(reversed(kFlat), reversed(up)), 1, 1e-9);
}

TEST(LinkingNumber, IsTheSameEitherWayRound) {
    const Polyline up = circle({1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, 17);
    EXPECT_NEAR(linkingNumber(up, kFlat), linkingNumber(kFlat, up), 1e-9);
}

TEST(LinkingNumber, ApartIsNone) {
    EXPECT_NEAR(linkingNumber(kFlat, circle({3, 0, 0}, {1, 0, 0}, {0, 0, 1})), 0, 1e-9);
    EXPECT_NEAR(linkingNumber(kFlat, circle({0, 0, 0.1}, {1, 0, 0}, {0, 1, 0})), 0, 1e-9);
}

TEST(LinkingNumber, TrianglesOfAHopfLink) {
    // By hand: the second triangle goes up through the first one once and comes back outside.
    const Polyline a{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const Polyline b{{1, 1, -1}, {1, 1, 1}, {9, 9, 0}};
    EXPECT_NEAR(linkingNumber(a, b), 1, 1e-9);
}

TEST(LinkingNumber, SolomonsLinkIsTwo) {
    EXPECT_NEAR(std::abs(linkingNumber(kFlat, aroundFlat(2))), 2, 1e-9);
    EXPECT_NEAR(std::abs(linkingNumber(kFlat, aroundFlat(5))), 5, 1e-9);
}

// Interlocked, and still 0: a doubled strand runs through the ring there and back, and its two bights hook
// into each other on the far side, each of them over the other one once.
TEST(LinkingNumber, WhiteheadLinkIsNone) {
    const auto at = [](double radius, double degrees, double height) {
        const double angle = degrees * std::numbers::pi / 180;
        return Vec3(radius * std::cos(angle), radius * std::sin(angle), height);
    };
    Polyline doubled;
    for (int degrees = 20; degrees <= 340; degrees += 10) {
        doubled.push_back(at(2.2, degrees, 0)); // there, through the ring at 180 degrees
    }
    for (const auto& [radius, degrees, height] :
         {std::array{2.2, 360.0, 0.0}, {2.2, 370.0, 0.3}, {1.8, 370.0, 0.3}, {1.8, 360.0, 0.0}}) {
        doubled.push_back(at(radius, degrees, height)); // the first bight lies over the second one at its end
    }
    for (int degrees = 340; degrees >= 20; degrees -= 10) {
        doubled.push_back(at(1.8, degrees, 0)); // and back
    }
    for (const auto& [radius, degrees, height] :
         {std::array{2.0, 5.0, 0.0}, {2.0, -10.0, 0.3}, {2.4, -10.0, 0.3}, {2.4, 5.0, 0.0}}) {
        doubled.push_back(at(radius, degrees, height)); // the second one over the first one
    }
    const Polyline ring = circle({-2, 0, 0}, {0.8, 0, 0}, {0, 0, 0.8});
    EXPECT_NEAR(linkingNumber(doubled, ring), 0, 1e-9);
    // One way only, closed on the far side, it is linked.
    Polyline once(doubled.begin(), doubled.begin() + 33);
    EXPECT_NEAR(std::abs(linkingNumber(once, ring)), 1, 1e-9);
}

TEST(LinkingNumber, NothingIsLinkedWithNothing) {
    EXPECT_EQ(linkingNumber({}, kFlat), 0);
}

} // namespace
} // namespace knittsim::geometry
