#pragma once

#include "tests/golden/blocks.h"
#include "ui/render/egl_context.h"
#include "ui/render/fabric_renderer.h"
#include "ui/render/offscreen.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

namespace knittsim::render {

constexpr double kLoopMm = 5;

/// GL_RENDERER, or empty where nothing can be drawn.
inline const std::string& rendererName() {
    static const std::string kName = [] {
        const auto context = EglContext::create();
        if (!context) {
            return std::string();
        }
        const auto renderer = FabricRenderer::create();
        return renderer ? renderer.value()->rendererName() : std::string();
    }();
    return kName;
}

/// Small pictures of fabrics, compared with those of tests/golden/references.
class Pictures : public testing::Test {
protected:
    void SetUp() override {
        std::cout << "GL_RENDERER: " << rendererName() << '\n';
        if (!rendererName().starts_with("llvmpipe")) {
            GTEST_SKIP() << "references are made on llvmpipe";
        }
        m_request.width = 192;
        m_request.height = 144;
        YarnLook look;
        look.colour = {186, 92, 70};
        look.diameterMm = kLoopMm / 9;
        m_request.looks = {look, look, look, look};
    }

    void expectPicture(const std::string& name, const fabric::Fabric& fabric, std::vector<float> positions) {
        m_request.fabric = &fabric;
        m_request.positions = positions;
        const auto image = renderFabric(m_request);
        ASSERT_TRUE(image) << image.diagnostics().front().id;
        const std::filesystem::path folder =
            std::filesystem::path(KNITTSIM_SOURCE_DIR) / "tests/golden/references";
        const auto reference = readPng(folder / (name + ".png"));
        if (!reference) {
            ASSERT_TRUE(writePng(folder / (name + ".png"), image.value()));
            FAIL() << "there was no reference; look at the one that was written: " << name;
        }
        ASSERT_EQ(reference->width, image->width);
        ASSERT_EQ(reference->height, image->height);
        const auto difference = test::compareBlocks(reference.value(), image.value());
        EXPECT_EQ(difference.blocks, 0) << difference.text();
        if (difference.blocks > 0) {
            EXPECT_TRUE(writePng(name + ".new.png", image.value())); // in the build folder
        }
    }

    RenderRequest m_request;
};

} // namespace knittsim::render
