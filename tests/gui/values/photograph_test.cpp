#include "ui/views/fabric_view/photograph.h"

#include <gtest/gtest.h>

#include <cmath>

namespace knittsim::ui {
namespace {

void expectNear(QPointF a, QPointF b) {
    EXPECT_NEAR(a.x(), b.x(), 1e-9);
    EXPECT_NEAR(a.y(), b.y(), 1e-9);
}

TEST(Photograph, TwoPointsComeToLieOnThoseOfTheFabric) {
    const std::array image{QPointF(100, 50), QPointF(400, 250)};
    const std::array fabric{QPointF(-3, 4), QPointF(5, 6)};
    for (const bool back : {false, true}) {
        const auto place = alignTwoPoints(image, fabric, back);
        ASSERT_TRUE(place);
        expectNear(place->map(image[0]), fabric[0]);
        expectNear(place->map(image[1]), fabric[1]);
        // A similarity: it neither shears nor stretches.
        EXPECT_NEAR(std::hypot(place->m11(), place->m12()), std::hypot(place->m21(), place->m22()), 1e-12);
        EXPECT_NEAR(place->m11() * place->m21() + place->m12() * place->m22(), 0, 1e-12);
    }
}

TEST(Photograph, TheFaceIsUprightAndTheBackReadsFromLeftToRight) {
    const std::array image{QPointF(0, 0), QPointF(100, 0)};
    const auto face = alignTwoPoints(image, {QPointF(0, 0), QPointF(10, 0)}, false);
    expectNear(face->map(QPointF(0, 100)), {0, -10}); // down in the image is down in the fabric
    const auto back = alignTwoPoints(image, {QPointF(10, 0), QPointF(0, 0)}, true);
    expectNear(back->map(QPointF(0, 100)), {10, -10});
}

TEST(Photograph, OnePointTwiceAlignsNothing) {
    EXPECT_FALSE(alignTwoPoints({QPointF(1, 1), QPointF(1, 1)}, {QPointF(0, 0), QPointF(1, 0)}, false));
    EXPECT_FALSE(alignTwoPoints({QPointF(1, 1), QPointF(2, 1)}, {QPointF(1, 0), QPointF(1, 0)}, true));
}

TEST(Photograph, IsLaidInTheMiddleAsWideAsTheFabric) {
    geometry::Bounds box;
    box.add({0, 0, 0});
    box.add({20, 10, 1});
    for (const bool back : {false, true}) {
        const QRectF place = laidOn({200, 300}, box, back).mapRect(QRectF(0, 0, 200, 300));
        expectNear(place.center(), {10, 5});
        EXPECT_NEAR(place.width(), 20, 1e-9);
        EXPECT_NEAR(place.height(), 30, 1e-9);
    }
}

TEST(Photograph, BesideItTouchesTheFabricNowhere) {
    geometry::Bounds box;
    box.add({0, 0, 0});
    box.add({20, 10, 1});
    Photograph photograph;
    photograph.image = QImage(200, 300, QImage::Format_RGB32);
    photograph.beside = true;
    for (const bool back : {false, true}) {
        photograph.toFabric = laidOn(photograph.image.size(), box, back);
        const QRectF place = placeOf(photograph, box, back).mapRect(QRectF(photograph.image.rect()));
        EXPECT_TRUE(back ? place.right() < 0 : place.left() > 20) << place.left();
        EXPECT_NEAR(place.width(), 20, 1e-9); // in the same scale
    }
}

TEST(Photograph, IsRememberedWithoutItsPixels) {
    Photograph photograph;
    photograph.path = "/a/swatch.jpg";
    photograph.beside = true;
    photograph.opacity = 0.25;
    photograph.wipe = 0.5;
    photograph.toFabric = QTransform(2, 1, 1, -2, 3, 4);
    const auto again = photographFromBytes(toBytes(photograph));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->path, photograph.path);
    EXPECT_TRUE(again->beside);
    EXPECT_EQ(again->opacity, 0.25);
    EXPECT_EQ(again->wipe, 0.5);
    EXPECT_EQ(again->toFabric, photograph.toFabric);
    EXPECT_FALSE(photographFromBytes("nonsense"));
    EXPECT_FALSE(photographFromBytes(toBytes(photograph).left(20)));
}

} // namespace
} // namespace knittsim::ui
