#include "core/geometry/stroke_style.h"
#include "ui/render/fabric_renderer_implementation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knittsim::render {

namespace {

// Texture units.
constexpr int kNodesUnit = 0;
constexpr int kSurfaceUnit = 1;
constexpr int kOwnerUnit = 2;
constexpr int kStateUnit = 3;
constexpr int kNoiseUnit = 4;
constexpr int kHiddenUnit = 5;

/// Light adds up linearly; the shader takes the root at the end.
Vec3f linear(const Vec3f& colour) {
    return colour.cwiseProduct(colour);
}

Vec3f accent(bool dark) {
    return dark ? Vec3f(1.0F, 0.70F, 0.16F) : Vec3f(0.93F, 0.42F, 0.02F);
}

} // namespace

void FabricRenderer::Implementation::drawYarns(const View& view) {
    uploadState();
    nodes.bind(kNodesUnit);
    surface.bind(kSurfaceUnit);
    hidden.bind(kHiddenUnit);
    owner.bind(kOwnerUnit);
    state.bind(kStateUnit);
    glActiveTexture(GL_TEXTURE0 + kNoiseUnit);
    glBindTexture(GL_TEXTURE_2D, noise);
    const Frustum frustum(view.camera);
    for (std::size_t carrier = 0; carrier < carriers; ++carrier) {
        drawCarrier(view, frustum, static_cast<machine::CarrierIndex>(carrier));
    }
}

const ShaderProgram& FabricRenderer::Implementation::programFor(const Detail& detail, bool cut) const {
    const bool ridge = detail.sides == kRidge;
    switch (frame->style) {
    case DrawStyle::Yarn:
        return cut                 ? *shaders.cutTube
               : detail.sides == 0 ? *shaders.yarnBand
               : detail.plies > 0  ? *(ridge ? shaders.pliedRidge : shaders.pliedTube)
                                   : *(ridge ? shaders.yarnRidge : shaders.yarnTube);
    case DrawStyle::Strokes:
        return *(detail.sides == 0 ? shaders.strokesBand
                 : ridge           ? shaders.strokesRidge
                                   : shaders.strokesTube);
    case DrawStyle::Mesh:
        break;
    }
    return *shaders.line;
}

void FabricRenderer::Implementation::drawCarrier(const View& view, const Frustum& frustum,
                                                 machine::CarrierIndex carrier) {
    const YarnLook& yarnLook = look(carrier);
    const bool mesh = frame->style == DrawStyle::Mesh;
    const float perPixel = millimetresPerPixel(view);
    const float radius = mesh ? 0.8F * perPixel : 0.5F * static_cast<float>(yarnLook.diameterMm);
    Detail detail =
        mesh ? Detail{}
             : detailAt(2 * radius / perPixel, frame->segmentMm / (2 * radius), view.quality, view.level);
    const bool cut = view.section && frame->style == DrawStyle::Yarn;
    if (cut) { // only a whole tube has an inside
        detail.sides = std::max(detail.sides, 8);
    }
    collectPieces(frustum, carrier, radius, detail);
    if (counts.empty()) {
        return;
    }
    const ShaderProgram& program = programFor(detail, cut);
    setCamera(program, view);
    program.set("uRadius", radius);
    program.set("uSides", detail.sides);
    program.set("uStride", detail.stride);
    program.set("uDetail", detail.plies);
    if (frame->style == DrawStyle::Yarn) {
        setYarn(program, view, yarnLook, radius);
    } else {
        const Vec3f ink = view.dark ? Vec3f(1, 1, 1) : Vec3f(0, 0, 0);
        const float share = mesh ? 0.35F : 0.0F;
        program.set("uColour", Vec3f((1 - share) * shown(yarnLook.colour) + share * ink));
        using Strokes = geometry::StrokeStyle;
        const auto pair = [](double a, double b) {
            return Eigen::Vector2f(static_cast<float>(a), static_cast<float>(b));
        };
        program.set("uWidths", pair(Strokes::kBodyWidth, Strokes::kDotWidth));
        program.set("uDots", pair(Strokes::kDotEvery * 2 * radius, Strokes::kDotLength / Strokes::kDotEvery));
        program.set("uShares", pair(Strokes::kEdgeShade, Strokes::kDotShare));
        program.set("uSoft", std::min(0.5F, perPixel / radius));
    }
    setRamp(program);
    const auto pieces = static_cast<GLsizei>(counts.size());
    if (detail.sides > 0) {
        glBindVertexArray(tubes.array());
        if (!view.section) { // which shows the inside of cut yarn
            glEnable(GL_CULL_FACE);
        }
        glMultiDrawElements(GL_TRIANGLE_STRIP, counts.data(), GL_UNSIGNED_INT, offsets.data(), pieces);
        glDisable(GL_CULL_FACE);
        if (frame->style == DrawStyle::Yarn && detail.hair > 0 && view.hair) {
            drawHair(view, frustum, carrier, radius, detail.hair);
        }
    } else {
        glBindVertexArray(emptyArray);
        glMultiDrawArrays(GL_TRIANGLE_STRIP, firsts.data(), counts.data(), pieces);
    }
}

/// Loose fibres of a carrier's yarns, as lines. `grown`: 0 .. 1, how far they stand off.
void FabricRenderer::Implementation::drawHair(const View& view, const Frustum& frustum,
                                              machine::CarrierIndex carrier, float radius,
                                              float grown) const {
    constexpr double kHairy = 0.2;   ///< less is not seen
    constexpr double kPerWidth = 28; ///< fibres on a piece of the hairiest yarn as long as it is wide
    constexpr GLsizei kVertices = 6;
    const YarnLook& yarnLook = look(carrier);
    if (yarnLook.hairiness < kHairy) {
        return;
    }
    const bool best = view.quality == Quality::Best;
    const double hairs =
        (best ? grown : 0.5F * grown) * yarnLook.hairiness * kPerWidth * frame->segmentMm / (2 * radius);
    const ShaderProgram& program = *shaders.hair;
    setCamera(program, view);
    setYarn(program, view, yarnLook, radius);
    setRamp(program);
    program.set("uRadius", radius);
    program.set("uGrown", grown);
    program.set("uCover", best ? 0.65F : 0.9F); // fewer cover as much
    program.set("uSegmentMm", frame->segmentMm);
    program.set("uPixelMm", millimetresPerPixel(view));
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glBindVertexArray(emptyArray);
    for (const Chunk& chunk : frame->chunks) {
        if (chunk.carrier == carrier && frustum.sees(chunk.centre, chunk.reach + 2 * radius)) {
            program.set("uFirst", chunk.firstNode);
            program.set("uPieceNodes", chunk.count - 1);
            glDrawArraysInstanced(GL_LINE_STRIP, 0, kVertices,
                                  static_cast<GLsizei>(std::lround(hairs * (chunk.count - 1))));
        }
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

/// The pieces of a carrier's yarns that the camera may see, as vertex or index ranges.
void FabricRenderer::Implementation::collectPieces(const Frustum& frustum, machine::CarrierIndex carrier,
                                                   float radius, const Detail& detail) {
    firsts.clear();
    offsets.clear();
    counts.clear();
    const auto step = static_cast<std::size_t>(detail.stride);
    if (detail.sides > 0) {
        tubes.prepare(frame->nodes.size() / step + 1, detail.sides);
    }
    for (const Chunk& chunk : frame->chunks) {
        if (chunk.carrier != carrier || !frustum.sees(chunk.centre, chunk.reach + radius)) {
            continue;
        }
        const std::size_t first = static_cast<std::size_t>(chunk.firstNode) / step;
        const std::size_t segments = static_cast<std::size_t>(chunk.count - 1) / step;
        if (detail.sides > 0) {
            const std::size_t bytes = first * tubes.perSegment() * sizeof(std::uint32_t);
            offsets.push_back(reinterpret_cast<const void*>(bytes));
            counts.push_back(static_cast<GLsizei>(segments * tubes.perSegment()));
        } else {
            firsts.push_back(static_cast<GLint>(2 * first));
            counts.push_back(static_cast<GLsizei>(2 * (segments + 1)));
        }
    }
}

void FabricRenderer::Implementation::setCamera(const ShaderProgram& program, const View& view) const {
    program.use();
    program.set("uView", view.camera.view());
    program.set("uProjection", view.camera.projection());
    const bool far = view.camera.state().orthographic;
    const Vec3f viewer = far ? view.camera.towardsViewer() : view.camera.eye();
    program.set("uViewer", Eigen::Vector4f(viewer.x(), viewer.y(), viewer.z(), far ? 0.0F : 1.0F));
    // Some drivers look at the distance even where clipping is off.
    program.set("uCut", view.section ? view.section->plane() : Eigen::Vector4f(0, 0, 0, 1));
    const Vec3f glow = accent(view.dark);
    program.set("uAccent",
                &program == shaders.line.get() || frame->style == DrawStyle::Strokes ? glow : linear(glow));
    program.set("uToViewer", view.camera.towardsViewer());
    program.set("uNodes", kNodesUnit);
    program.set("uSurface", kSurfaceUnit);
    program.set("uHidden", kHiddenUnit);
    program.set("uOwner", kOwnerUnit);
    program.set("uState", kStateUnit);
    program.set("uNoise", kNoiseUnit);
    program.set("uAnyState", anyState() ? 1 : 0);
}

void FabricRenderer::Implementation::setYarn(const ShaderProgram& program, const View& view,
                                             const YarnLook& l, float radius) const {
    const Camera& camera = view.camera;
    const auto onScreen = [&](float x, float y, float z) -> Vec3f {
        return (x * camera.right() + y * camera.up() + z * camera.towardsViewer()).normalized();
    };
    constexpr float kTurn = 2 * std::numbers::pi_v<float>;
    const auto turnsPerMm = static_cast<float>(l.twistPerMetre / 1000);
    program.set("uColour", linear(shown(l.colour)));
    const Vec3f key = onScreen(-0.50F, 0.62F, 0.60F);
    program.set("uKey", key);
    program.set("uBetween", (key + camera.towardsViewer()).normalized());
    program.set("uAmbient", Vec3f(0.13F * onScreen(0.70F, -0.15F, 0.50F) + 0.08F * camera.up()));
    program.set("uPlies", static_cast<float>(l.plies));
    program.set("uTwist", kTurn * turnsPerMm * static_cast<float>(l.plies));
    program.set("uHelix", kTurn * turnsPerMm * radius);
    program.set("uHair", static_cast<float>(l.hairiness));
    program.set("uGloss", static_cast<float>(l.gloss));
    program.set("uMelange", static_cast<float>(l.melange));
}

/// The colours of values, in the light that the program reckons in.
void FabricRenderer::Implementation::setRamp(const ShaderProgram& program) const {
    program.set("uByValue", frame->range.empty() ? 0 : 1);
    for (std::size_t i = 0; !frame->range.empty() && i < kRampColours; ++i) {
        const Vec3f colour = shown(ramp()[i]);
        program.set(fmt::format("uRamp[{}]", i).c_str(),
                    frame->style == DrawStyle::Yarn ? linear(colour) : colour);
    }
}

} // namespace knittsim::render
