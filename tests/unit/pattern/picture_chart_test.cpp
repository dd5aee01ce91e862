#include "core/pattern/compile.h"
#include "core/pattern/ok_lab.h"
#include "core/pattern/picture_chart.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace knittsim::pattern {
namespace {

using yarn::Colour;

constexpr Colour kBlack{0, 0, 0};
constexpr Colour kWhite{255, 255, 255};
constexpr Colour kRed{200, 30, 40};

template<class ColourAt> Picture pictureOf(int width, int height, ColourAt colourAt) {
    Picture picture{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Colour colour = colourAt(x, y);
            picture.rgb.insert(picture.rgb.end(), {colour.r, colour.g, colour.b});
        }
    }
    return picture;
}

TEST(PictureChart, TheTopOfThePictureIsTheLastCourse) {
    const Picture picture = pictureOf(30, 20, [](int x, int y) { return y < 10 && x < 10 ? kRed : kWhite; });
    const auto cells = reducePicture(picture, {.wales = 3, .courses = 2, .colours = {kWhite, kRed}});
    ASSERT_TRUE(cells);
    EXPECT_EQ(cells->yarns, (std::vector<std::uint8_t>{0, 0, 0, 1, 0, 0}));
}

TEST(PictureChart, ACircleStaysRoundInStitchesThatAreWiderThanHigh) {
    const Picture picture = pictureOf(200, 200, [](int x, int y) {
        return (x - 100) * (x - 100) + (y - 100) * (y - 100) < 80 * 80 ? kBlack : kWhite;
    });
    constexpr double kAspect = 0.75;
    const int wales = 60;
    const int courses = coursesFor(picture, wales, kAspect);
    EXPECT_EQ(courses, 80);
    const auto cells =
        reducePicture(picture, {.wales = wales, .courses = courses, .colours = {kWhite, kBlack}});
    ASSERT_TRUE(cells);
    int widest = 0;
    std::vector<int> columns(static_cast<std::size_t>(wales), 0);
    for (int c = 0; c < courses; ++c) {
        int across = 0;
        for (int w = 0; w < wales; ++w) {
            const int black = cells->yarns[static_cast<std::size_t>(c * wales + w)];
            across += black;
            columns[static_cast<std::size_t>(w)] += black;
        }
        widest = std::max(widest, across);
    }
    const int highest = *std::ranges::max_element(columns);
    EXPECT_NEAR(highest * kAspect, widest, 1.0);
    EXPECT_NEAR(widest, 48, 1);
}

TEST(PictureChart, FindsTheColoursOfAPictureTheCommonestFirst) {
    const Picture picture = pictureOf(40, 40, [](int x, int y) {
        return x < 20 ? kWhite : y < 30 ? kRed : kBlack;
    });
    const auto cells = reducePicture(picture, {.wales = 20, .courses = 20, .count = 3});
    ASSERT_TRUE(cells);
    EXPECT_EQ(cells->colours, (std::vector<Colour>{kWhite, kRed, kBlack}));
    // Of two colours no third is made.
    const Picture two = pictureOf(40, 40, [](int x, int) { return x < 25 ? kWhite : kBlack; });
    EXPECT_EQ(reducePicture(two, {.wales = 40, .courses = 40, .count = 5})->colours.size(), 2U);
}

TEST(PictureChart, DitheringKeepsTheMeanLight) {
    const Colour grey{120, 120, 120};
    const Picture picture = pictureOf(60, 60, [&](int, int) { return grey; });
    PictureOptions options{.wales = 60, .courses = 60, .colours = {kBlack, kWhite}, .dither = true};
    const auto cells = reducePicture(picture, options);
    ASSERT_TRUE(cells);
    const double share = double(std::ranges::count(cells->yarns, 1)) / 3600;
    EXPECT_NEAR(share, linearOf(grey.r), 0.01);
    options.dither = false;
    const auto flat = reducePicture(picture, options);
    ASSERT_TRUE(flat);
    EXPECT_TRUE(std::ranges::all_of(flat->yarns, [&](int yarn) { return yarn == flat->yarns[0]; }));
}

TEST(PictureChart, LightnessIsThatOfThePaper) {
    // Ottosson's table of test values: XYZ of D65 white is L = 1; here white and black of sRGB.
    EXPECT_NEAR(okLabOf(linearOf(kWhite))[0], 1, 1e-3);
    EXPECT_NEAR(okLabOf(linearOf(kWhite))[1], 0, 1e-3);
    EXPECT_NEAR(okLabOf(linearOf(kBlack))[0], 0, 1e-9);
    for (int i = 0; i < 256; ++i) {
        EXPECT_EQ(channelOf(linearOf(static_cast<std::uint8_t>(i))), i);
    }
}

TEST(PictureChart, CanBeCancelledAtEveryMoment) {
    const Picture picture = pictureOf(50, 50, [](int x, int y) { return x * y % 3 ? kRed : kWhite; });
    int calls = 0;
    const auto whole = reducePicture(picture, {.wales = 25, .courses = 25}, [&](double share) {
        EXPECT_GE(share, 0);
        EXPECT_LE(share, 1);
        ++calls;
        return true;
    });
    ASSERT_TRUE(whole);
    for (const int end : {0, 10, 24}) {
        int left = end;
        EXPECT_FALSE(
            reducePicture(picture, {.wales = 25, .courses = 25}, [&](double) { return left-- > 0; }));
    }
    EXPECT_GT(calls, 25);
}

TEST(PictureChart, KnitsAsFloatJacquardAndAsIntarsia) {
    const Picture picture = pictureOf(40, 40, [](int x, int y) {
        return x < 13 ? kWhite : x + y < 40 ? kRed : kBlack;
    });
    const auto cells = reducePicture(picture, {.wales = 20, .courses = 24, .count = 3});
    ASSERT_TRUE(cells);
    for (const ColourMethod method : {ColourMethod::Float, ColourMethod::Intarsia}) {
        const Chart chart = chartOf(*cells, {"1", "2", "3"}, method);
        EXPECT_EQ(chart.width, 20);
        EXPECT_EQ(chart.yarns.size(), cells->colours.size());
        EXPECT_TRUE(compile(chart));
    }
}

} // namespace
} // namespace knittsim::pattern
