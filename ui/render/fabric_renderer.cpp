#include "ui/render/fabric_renderer.h"

#include "ui/render/buffer_texture.h"
#include "ui/render/fibre_noise.h"
#include "ui/render/level_of_detail.h"
#include "ui/render/shader_set.h"
#include "ui/render/tube_indices.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace knittsim::render {

namespace {

// Texture units.
constexpr int kNodesUnit = 0;
constexpr int kSurfaceUnit = 1;
constexpr int kOwnerUnit = 2;
constexpr int kStateUnit = 3;
constexpr int kNoiseUnit = 4;

enum State : std::uint8_t { Plain, Selected, Hovered };

Vec3f shown(yarn::Colour c) {
    return Vec3f(c.r, c.g, c.b) / 255.0F;
}

/// Light adds up linearly; the shader takes the root at the end.
Vec3f linear(const Vec3f& colour) {
    return colour.cwiseProduct(colour);
}

/// Of the background, which is lighter at the top.
std::pair<Vec3f, Vec3f> lowerAndUpper(bool dark) {
    return dark ? std::pair(Vec3f(0.105F, 0.112F, 0.125F), Vec3f(0.185F, 0.195F, 0.215F))
                : std::pair(Vec3f(0.84F, 0.85F, 0.86F), Vec3f(0.955F, 0.96F, 0.965F));
}

Vec3f accent(bool dark) {
    return dark ? Vec3f(1.0F, 0.70F, 0.16F) : Vec3f(0.93F, 0.42F, 0.02F);
}

const char* text(GLenum name) {
    const auto* value = reinterpret_cast<const char*>(glGetString(name));
    return value != nullptr ? value : "unknown";
}

/// Of the picture, which has more pixels than the window on fine screens.
float millimetresPerPixel(const View& view) {
    return 2 * view.camera.state().halfHeight / static_cast<float>(std::max(1, view.height));
}

} // namespace

struct FabricRenderer::Implementation {
    std::string renderer, version;
    ShaderSet shaders;
    TubeIndices tubes;
    BufferTexture nodes{GL_RGBA32F}, surface{GL_RG32UI}, owner{GL_R32UI}, state{GL_R8UI};
    GLuint noise = 0;
    GLuint emptyArray = 0; ///< core profile draws nothing without an array object
    GLuint markerArray = 0;
    GLuint markerBuffer = 0;
    GLint mostTexels = 0;

    std::shared_ptr<const SceneFrame> frame;
    std::shared_ptr<const SceneTopology> topology;
    std::vector<std::vector<std::pair<GLint, GLsizei>>> runs; ///< vertex ranges by carrier
    std::vector<YarnLook> looks;
    std::vector<machine::LoopIndex> selection;
    machine::LoopIndex hovered = -1;
    bool stateDirty = true;
    std::size_t carriers = 0;
    std::vector<GLint> firsts; ///< of the pieces to draw
    std::vector<const void*> offsets;
    std::vector<GLsizei> counts;

    ~Implementation() {
        glDeleteTextures(1, &noise);
        glDeleteVertexArrays(1, &emptyArray);
        glDeleteVertexArrays(1, &markerArray);
        glDeleteBuffers(1, &markerBuffer);
    }

    void makeNoise();
    void makeArrays();
    void setTopology(std::shared_ptr<const SceneTopology> next);
    void uploadState();
    bool anyState() const { return hovered >= 0 || !selection.empty(); }
    const YarnLook& look(std::size_t carrier) const;

    void drawBackground(const View& view) const;
    void drawYarns(const View& view);
    void drawCarrier(const View& view, const Frustum& frustum, machine::CarrierIndex carrier);
    void drawHair(const View& view, const Frustum& frustum, machine::CarrierIndex carrier,
                  float radius) const;
    const ShaderProgram& programFor(const Detail& detail, bool cut) const;
    void collectPieces(const Frustum& frustum, machine::CarrierIndex carrier, float radius,
                       const Detail& detail);
    void setCamera(const ShaderProgram& program, const View& view) const;
    void setYarn(const ShaderProgram& program, const View& view, const YarnLook& look, float radius) const;
    void setRamp(const ShaderProgram& program) const;
    void drawMarkers(const View& view) const;
};

FabricRenderer::FabricRenderer() : m(std::make_unique<Implementation>()) {}
FabricRenderer::~FabricRenderer() = default;

Result<std::unique_ptr<FabricRenderer>> FabricRenderer::create() {
    using R = Result<std::unique_ptr<FabricRenderer>>;
    if (epoxy_gl_version() < 33) {
        return Diagnostic{.id = "KS0402", .place = {}, .arguments = {text(GL_VERSION)}};
    }
    std::unique_ptr<FabricRenderer> result(new FabricRenderer);
    Implementation& m = *result->m;
    m.renderer = text(GL_RENDERER);
    m.version = text(GL_VERSION);
    auto shaders = loadShaders();
    if (!shaders) {
        return R::failure(shaders.diagnostics());
    }
    m.shaders = std::move(shaders.value());
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &m.mostTexels);
    m.makeNoise();
    m.makeArrays();
    return result;
}

void FabricRenderer::Implementation::makeNoise() {
    const std::vector<std::uint8_t> texels = makeFibreNoise();
    glGenTextures(1, &noise);
    glBindTexture(GL_TEXTURE_2D, noise);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG8, kNoiseSize, kNoiseSize, 0, GL_RG, GL_UNSIGNED_BYTE, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void FabricRenderer::Implementation::makeArrays() {
    glGenVertexArrays(1, &emptyArray);
    glGenVertexArrays(1, &markerArray);
    glGenBuffers(1, &markerBuffer);
    glBindVertexArray(markerArray);
    glBindBuffer(GL_ARRAY_BUFFER, markerBuffer);
    glEnableVertexAttribArray(0);
    const auto attribute = [](GLuint location, std::size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(Marker),
                              reinterpret_cast<const void*>(offset));
    };
    attribute(0, offsetof(Marker, place));
    attribute(2, offsetof(Marker, front));
    attribute(3, offsetof(Marker, behind));
    glEnableVertexAttribArray(1);
    glVertexAttribIPointer(1, 1, GL_UNSIGNED_INT, sizeof(Marker),
                           reinterpret_cast<const void*>(offsetof(Marker, kind)));
    glBindVertexArray(0);
}

bool FabricRenderer::upload(std::shared_ptr<const SceneFrame> frame) {
    const std::size_t texels = std::max(frame->nodes.size(), frame->topology->pointCount);
    if (texels > static_cast<std::size_t>(m->mostTexels)) {
        m->frame.reset();
        return false;
    }
    if (frame->topology != m->topology) {
        m->setTopology(frame->topology);
    }
    m->nodes.upload(frame->nodes.data(), frame->nodes.size() * sizeof frame->nodes[0]);
    m->surface.upload(frame->surface.data(), frame->surface.size() * sizeof frame->surface[0]);
    glBindBuffer(GL_ARRAY_BUFFER, m->markerBuffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(frame->markers.size() * sizeof(Marker)),
                 frame->markers.data(), GL_STREAM_DRAW);
    m->frame = std::move(frame);
    return true;
}

void FabricRenderer::Implementation::setTopology(std::shared_ptr<const SceneTopology> next) {
    topology = std::move(next);
    owner.upload(topology->owner.data(), topology->owner.size() * sizeof topology->owner[0]);
    carriers = 0;
    for (const geometry::YarnCurves::Range& yarn : topology->yarns) {
        carriers = std::max<std::size_t>(carriers, std::size_t{yarn.carrier} + 1);
    }
    stateDirty = true;
}

void FabricRenderer::clear() {
    m->frame.reset();
}

void FabricRenderer::setLooks(std::vector<YarnLook> looks) {
    m->looks = std::move(looks);
}

void FabricRenderer::setSelection(std::span<const machine::LoopIndex> loops) {
    std::vector<machine::LoopIndex> sorted(loops.begin(), loops.end());
    std::ranges::sort(sorted);
    m->stateDirty = m->stateDirty || sorted != m->selection;
    m->selection = std::move(sorted);
}

void FabricRenderer::setHovered(machine::LoopIndex loop) {
    m->stateDirty = m->stateDirty || m->hovered != loop;
    m->hovered = loop;
}

void FabricRenderer::Implementation::uploadState() {
    if (!stateDirty || !topology || !anyState()) {
        return;
    }
    std::vector<std::uint8_t> states(topology->pointCount, Plain);
    for (std::size_t p = 0; p + 1 < states.size(); ++p) {
        const machine::LoopIndex loop = topology->loopOfPoint[p];
        // The yarn behind the last point of a loop is the sinker to the next one: it belongs to neither.
        if (loop < 0 || topology->loopOfPoint[p + 1] != loop) {
            continue;
        }
        states[p] = std::ranges::binary_search(selection, loop) ? Selected
                    : loop == hovered                           ? Hovered
                                                                : Plain;
    }
    state.upload(states.data(), states.size());
    stateDirty = false;
}

const YarnLook& FabricRenderer::Implementation::look(std::size_t carrier) const {
    static const YarnLook kDefault;
    return carrier < looks.size() ? looks[carrier] : kDefault;
}

void FabricRenderer::draw(const View& view) {
    glViewport(-view.left, -view.bottom, view.width, view.height);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glClearColor(0, 0, 0, 0);
    glClearDepth(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (!view.transparent) {
        m->drawBackground(view);
    }
    if (m->frame) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        if (view.section) {
            glEnable(GL_CLIP_DISTANCE0);
        }
        m->drawYarns(view);
        if (!m->frame->markers.empty()) {
            m->drawMarkers(view);
        }
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_CLIP_DISTANCE0);
    }
    glBindVertexArray(0);
    glUseProgram(0);
    glActiveTexture(GL_TEXTURE0);
}

void FabricRenderer::Implementation::drawBackground(const View& view) const {
    glDisable(GL_DEPTH_TEST);
    shaders.background->use();
    const auto [lower, upper] = lowerAndUpper(view.dark);
    shaders.background->set("uLower", lower);
    shaders.background->set("uUpper", upper);
    glBindVertexArray(emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void FabricRenderer::Implementation::drawYarns(const View& view) {
    uploadState();
    nodes.bind(kNodesUnit);
    surface.bind(kSurfaceUnit);
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
    switch (frame->style) {
    case DrawStyle::Yarn:
        return cut                 ? *shaders.cutTube
               : detail.sides == 0 ? *shaders.yarnBand
               : detail.plies > 0  ? *shaders.pliedTube
                                   : *shaders.yarnTube;
    case DrawStyle::Strokes:
        return detail.sides == 0 ? *shaders.strokesBand : *shaders.strokesTube;
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
        mesh ? Detail{} : detailAt(2 * radius / perPixel, frame->segmentMm / (2 * radius), view.quality);
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
        program.set("uDotMm", 1.4F * radius);
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
        if (frame->style == DrawStyle::Yarn && detail.plies > 0 && view.hair) {
            drawHair(view, frustum, carrier, radius);
        }
    } else {
        glBindVertexArray(emptyArray);
        glMultiDrawArrays(GL_TRIANGLE_STRIP, firsts.data(), counts.data(), pieces);
    }
}

/// Loose fibres of a carrier's yarns, as lines.
void FabricRenderer::Implementation::drawHair(const View& view, const Frustum& frustum,
                                              machine::CarrierIndex carrier, float radius) const {
    constexpr double kHairy = 0.2;   ///< less is not seen
    constexpr double kPerWidth = 14; ///< fibres on a piece of the hairiest yarn as long as it is wide
    constexpr GLsizei kVertices = 4;
    const YarnLook& yarnLook = look(carrier);
    const double wanted = yarnLook.hairiness * kPerWidth * frame->segmentMm / (2 * radius);
    if (yarnLook.hairiness < kHairy) {
        return;
    }
    const int hairs = std::max(1, static_cast<int>(std::lround(wanted)));
    const ShaderProgram& program = *shaders.hair;
    setCamera(program, view);
    setYarn(program, view, yarnLook, radius);
    setRamp(program);
    program.set("uRadius", radius);
    program.set("uHairs", hairs);
    program.set("uSegmentMm", frame->segmentMm);
    glBindVertexArray(emptyArray);
    for (const Chunk& chunk : frame->chunks) {
        if (chunk.carrier == carrier && frustum.sees(chunk.centre, chunk.reach + 2 * radius)) {
            program.set("uFirst", chunk.firstNode);
            glDrawArraysInstanced(GL_LINE_STRIP, 0, kVertices, hairs * (chunk.count - 1));
        }
    }
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
    program.set("uFill", onScreen(0.70F, -0.15F, 0.50F));
    program.set("uSky", onScreen(0, 1, 0));
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

void FabricRenderer::Implementation::drawMarkers(const View& view) const {
    const ShaderProgram& program = *shaders.marker;
    const MeshColours colours = meshColours(view.dark);
    const auto [lower, upper] = lowerAndUpper(view.dark);
    setCamera(program, view);
    const float perPixel = millimetresPerPixel(view);
    const float size = std::clamp(kMarkerMm / perPixel, kLeastMarkerPixels, kMostMarkerPixels);
    program.set("uSize", size);
    program.set("uLift", 0.5F * size * perPixel);
    program.set("uFoot", shown(colours.foot));
    program.set("uHead", shown(colours.head));
    program.set("uCrossing", shown(colours.crossing));
    program.set("uLower", lower);
    program.set("uUpper", upper);
    program.set("uHeight", view.transparent ? 0.0F : static_cast<float>(view.height));
    program.set("uBottom", static_cast<float>(view.bottom));
    glEnable(GL_PROGRAM_POINT_SIZE);
    // Soft edges; where there is no background the alpha of the picture must not change.
    if (!view.transparent) {
        glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    }
    glBindVertexArray(markerArray);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(frame->markers.size()));
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glDisable(GL_SAMPLE_ALPHA_TO_ONE);
    glDisable(GL_PROGRAM_POINT_SIZE);
}

const std::string& FabricRenderer::rendererName() const {
    return m->renderer;
}
const std::string& FabricRenderer::versionText() const {
    return m->version;
}

} // namespace knittsim::render
