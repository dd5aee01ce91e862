#include "ui/render/fabric_renderer.h"

#include "ui/render/fabric_renderer_implementation.h"
#include "ui/render/fibre_noise.h"

#include <algorithm>
#include <utility>

namespace knittsim::render {

namespace {

enum State : std::uint8_t { Plain, Selected, Hovered };

const char* text(GLenum name) {
    const auto* value = reinterpret_cast<const char*>(glGetString(name));
    return value != nullptr ? value : "unknown";
}

} // namespace

Vec3f shown(yarn::Colour c) {
    return Vec3f(c.r, c.g, c.b) / 255.0F;
}

std::pair<Vec3f, Vec3f> lowerAndUpper(bool dark) {
    return dark ? std::pair(Vec3f(0.105F, 0.112F, 0.125F), Vec3f(0.185F, 0.195F, 0.215F))
                : std::pair(Vec3f(0.84F, 0.85F, 0.86F), Vec3f(0.955F, 0.96F, 0.965F));
}

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

bool FabricRenderer::contextIsLost() {
    constexpr GLenum kContextLost = 0x0507; // GL_CONTEXT_LOST, of OpenGL 4.5 and of extensions before
    GLenum status = GL_NO_ERROR;
    if (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness")) {
        status = glGetGraphicsResetStatus();
    } else if (epoxy_has_gl_extension("GL_ARB_robustness")) {
        status = glGetGraphicsResetStatusARB();
    }
    return status != GL_NO_ERROR || glGetError() == kContextLost;
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
    m->hidden.upload(frame->hidden.data(), frame->hidden.size() * sizeof frame->hidden[0]);
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
