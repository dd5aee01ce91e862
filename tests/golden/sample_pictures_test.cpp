#include "core/fabric/fabric_builder.h"
#include "core/fabric/reduction.h"
#include "core/pattern/samples.h"
#include "core/simulation/simulation.h"
#include "tests/golden/pictures.h"
#include "tests/support/build.h"
#include "tests/support/lattice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace knittsim::render {
namespace {

/// The samples, settled as bonding points and seen so near that a knitter names the stitch.
class SamplePictures : public Pictures {
protected:
    void SetUp() override {
        Pictures::SetUp();
        m_request.looks.assign(10, {.colour = {178, 92, 66}, .diameterMm = 0.55});
        m_request.looks[1].colour = {232, 222, 200};
        m_request.looks[2].colour = {58, 110, 140};
    }

    void knit(const char* id) {
        m_fabric = std::make_shared<fabric::Fabric>(
            fabric::buildFabric(machine::Timeline(pattern::makeSample(id), machine::genericProfile())));
        settle();
    }

    void settle() {
        simulation::Simulation simulation;
        simulation.apply(simulation::command::Load{.fabric = m_fabric, .yarns = {}, .generation = 1});
        simulation.apply(simulation::command::Start{});
        simulation.runToEnd(60);
        m_frame = simulation.frame();
    }

    /// `share`: of the fabric's height that is seen, about its middle.
    void expectSample(const std::string& name, ViewSide side, float share, float pitch = 0) {
        geometry::Bounds box;
        for (std::size_t i = 0; i < m_frame.positions.size(); i += 3) {
            box.add({m_frame.positions[i], m_frame.positions[i + 1], m_frame.positions[i + 2]});
        }
        Camera camera;
        camera.look(side);
        CameraState state = camera.state();
        state.pitch += pitch;
        state.target = box.centre();
        state.halfHeight = 0.5F * share * box.size().y();
        m_request.camera = state;
        expectPicture(name, *m_fabric, m_frame.positions);
    }

    std::shared_ptr<const fabric::Fabric> m_fabric;
    simulation::Frame m_frame;
};

TEST_F(SamplePictures, garterHasRidgesAcross) {
    knit("garter");
    expectSample("garter", ViewSide::Front, 0.3F);
}

TEST_F(SamplePictures, seedHasPurlBumpsLikeAChessboard) {
    knit("seed");
    expectSample("seed", ViewSide::Front, 0.35F);
}

TEST_F(SamplePictures, laceHasHoles) {
    knit("lace");
    expectSample("lace", ViewSide::Front, 0.45F);
}

TEST_F(SamplePictures, tuckStitches) {
    knit("tuck");
    expectSample("tuck", ViewSide::Front, 0.4F);
}

TEST_F(SamplePictures, jacquardFront) {
    knit("float-jacquard");
    expectSample("jacquard-front", ViewSide::Front, 0.6F);
}

TEST_F(SamplePictures, jacquardBackHasFloats) {
    knit("float-jacquard");
    expectSample("jacquard-back", ViewSide::Back, 0.6F);
}

TEST_F(SamplePictures, intarsiaYarnsMeetWithoutFloats) {
    knit("intarsia");
    expectSample("intarsia", ViewSide::Back, 0.6F);
}

TEST_F(SamplePictures, aTubeSeenAslant) {
    knit("tube");
    expectSample("tube", ViewSide::Front, 1.1F, 0.8F);
}

TEST_F(SamplePictures, cableOnADarkGround) {
    knit("cable-braid");
    m_request.dark = true;
    expectSample("cable-braid", ViewSide::Front, 0.5F);
}

TEST_F(SamplePictures, tensionAsColour) {
    knit("tuck");
    m_request.values = m_frame.tension;
    expectSample("tension", ViewSide::Front, 0.6F);
}

TEST_F(SamplePictures, aLadderHasRungs) {
    // One needle drops its loop; nothing holds the wale below it.
    std::string lines = "in 1\n";
    for (int course = 0; course < 8; ++course) {
        lines += course % 2 == 0 ? test::pass("knit", 'f', 7, 0, 1) : test::pass("knit", 'f', 0, 7, 1);
    }
    const auto whole = test::build(lines + "drop f4\nout 1\n");
    m_fabric = std::make_shared<fabric::Fabric>(fabric::removeRuns(whole, fabric::findRuns(whole)).fabric);
    settle();
    expectSample("ladder", ViewSide::Front, 1.1F);
}

/// Four stitches, near by.
class NearPictures : public SamplePictures {
protected:
    void expectNear(const std::string& name) {
        const auto fabric =
            test::build("in 1\n" + test::pass("knit", 'f', 5, 0, 1) + test::pass("knit", 'f', 0, 5, 1) +
                        test::pass("knit", 'f', 5, 0, 1) + test::pass("knit", 'f', 0, 5, 1) + "out 1\n");
        CameraState state;
        state.target = {3.1F, 1.9F, 0};
        state.halfHeight = 1.3F;
        m_request.camera = state;
        expectPicture(name, fabric, test::relaxedLattice(fabric, kLoopMm));
    }
};

TEST_F(NearPictures, hairyYarn) {
    m_request.looks[0].hairiness = 0.9;
    m_request.looks[0].colour = {214, 140, 150};
    expectNear("fuzz");
}

TEST_F(NearPictures, melange) {
    m_request.looks[0].hairiness = 0;
    m_request.looks[0].colour = {130, 130, 134};
    m_request.looks[0].melange = 0.9;
    expectNear("melange");
}

TEST_F(NearPictures, cutYarnIsFilled) {
    const auto fabric =
        test::build("in 1\n" + test::pass("knit", 'f', 5, 0, 1) + test::pass("knit", 'f', 0, 5, 1) +
                    test::pass("knit", 'f', 5, 0, 1) + test::pass("knit", 'f', 0, 5, 1) + "out 1\n");
    Camera camera;
    camera.look(ViewSide::Top);
    CameraState state = camera.state();
    state.target = {3.1F, 1.6F, 0};
    state.halfHeight = 1.3F;
    state.pitch -= 0.35F;
    m_request.camera = state;
    m_request.looks[0].hairiness = 0;
    m_request.looks[0].diameterMm = 0.36; // no yarn lies within another
    m_request.section = Section{{0, 1.6F, 0}, Vec3f::UnitY()};
    expectPicture("cut-faces", fabric, test::relaxedLattice(fabric, kLoopMm));
}

TEST_F(NearPictures, aStepFartherThereAreNoPlies) {
    const auto fabric =
        test::build("in 1\n" + test::pass("knit", 'f', 15, 0, 1) + test::pass("knit", 'f', 0, 15, 1) +
                    test::pass("knit", 'f', 15, 0, 1) + test::pass("knit", 'f', 0, 15, 1) + "out 1\n");
    expectPicture("plain-tube", fabric, test::relaxedLattice(fabric, kLoopMm));
}

/// What is switched off is not drawn: hairs are all that differs.
TEST_F(NearPictures, withoutFuzzThereIsLessYarnOnTheGround) {
    const auto fabric = test::build("in 1\n" + test::pass("knit", 'f', 3, 0, 1) +
                                    test::pass("knit", 'f', 0, 3, 1) + "out 1\n");
    const auto positions = test::relaxedLattice(fabric, kLoopMm);
    m_request.fabric = &fabric;
    m_request.positions = positions;
    m_request.transparent = true;
    m_request.looks[0].hairiness = 0.9;
    const auto covered = [this] {
        const auto image = renderFabric(m_request);
        int count = 0;
        for (int y = 0; image && y < image->height; ++y) {
            for (int x = 0; x < image->width; ++x) {
                count += image->at(x, y)[3] > 0 ? 1 : 0;
            }
        }
        return count;
    };
    const int hairy = covered();
    m_request.hair = false;
    const int smooth = covered();
    EXPECT_GT(hairy, smooth + smooth / 80);
}

} // namespace
} // namespace knittsim::render
