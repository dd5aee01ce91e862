#include "ui/render/picture_sequence.h"

#include "ui/render/image.h"

#include <fmt/format.h>

#include <algorithm>

namespace knittsim::render {

namespace fs = std::filesystem;

namespace {

geometry::Bounds boundsOf(const simulation::SettlingShape& shape) {
    geometry::Bounds box;
    if (shape.curves) {
        return geometry::boundsOf(shape.curves->nodes);
    }
    for (std::size_t i = 0; i + 2 < shape.positions.size(); i += 3) {
        box.add({shape.positions[i], shape.positions[i + 1], shape.positions[i + 2]});
    }
    return box;
}

/// Sees all shapes; loops at the edges stand out by about a loop's width.
CameraState cameraFor(const RenderRequest& look, std::span<const simulation::SettlingShape> shapes) {
    constexpr float kMargin = 1.05F;
    geometry::Bounds all;
    for (const simulation::SettlingShape& shape : shapes) {
        const geometry::Bounds box = boundsOf(shape);
        all.add(box.low);
        all.add(box.high);
    }
    Camera camera;
    camera.setViewport(look.width, look.height);
    camera.setScene(all);
    camera.look(look.side);
    camera.fit(all);
    CameraState state = camera.state();
    state.halfHeight *= kMargin;
    return state;
}

/// A folder that goes again unless it was kept.
class NewFolder {
public:
    explicit NewFolder(fs::path wanted) : m_wanted(std::move(wanted)) {}
    ~NewFolder() {
        if (m_made) {
            std::error_code ignored;
            fs::remove_all(m_path, ignored);
        }
    }
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;

    Result<Written> make() {
        std::error_code error;
        if (fs::exists(m_wanted)) {
            return problem("there is something of this name already");
        }
        if (m_wanted.has_parent_path()) {
            fs::create_directories(m_wanted.parent_path(), error);
        }
        // One of these names may be left from a run that crashed.
        for (int number = 1; !error && !m_made; ++number) {
            m_path = m_wanted;
            m_path += fmt::format(".part{}", number);
            m_made = fs::create_directory(m_path, error);
        }
        return m_made ? Result<Written>(Written{}) : problem(error.message());
    }
    Result<Written> keep() {
        std::error_code error;
        fs::rename(m_path, m_wanted, error);
        m_made = static_cast<bool>(error);
        if (error) {
            return problem(error.message());
        }
        return Written{};
    }
    const fs::path& path() const { return m_path; }

private:
    Result<Written> problem(std::string reason) const {
        return Diagnostic{
            .id = "KS0002", .place = {.file = m_wanted.string()}, .arguments = {std::move(reason)}};
    }

    fs::path m_wanted;
    fs::path m_path;
    bool m_made = false; ///< m_path is there
};

} // namespace

Result<Written> writeSequence(const fs::path& folder, const RenderRequest& look,
                              std::span<const simulation::SettlingShape> shapes, const Progress& progress) {
    NewFolder pictures(folder);
    if (auto made = pictures.make(); !made) {
        return made;
    }
    auto painter = OffscreenPainter::create();
    if (!painter) {
        return Result<Written>::failure(painter.diagnostics());
    }
    RenderRequest request = look;
    request.camera = look.camera.value_or(cameraFor(look, shapes));
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const auto share = [&](double part) {
            return !progress ||
                   progress((static_cast<double>(i) + part) / static_cast<double>(shapes.size()));
        };
        request.positions = shapes[i].positions;
        request.curves = look.style != DrawStyle::Mesh ? shapes[i].curves.get() : nullptr;
        request.progress = share;
        const auto image = painter.value()->draw(request);
        if (!image) {
            return Result<Written>::failure(image.diagnostics());
        }
        const auto written = writePng(pictures.path() / fmt::format("{:04}.png", i + 1), image.value());
        if (!written) {
            return written;
        }
    }
    return pictures.keep();
}

} // namespace knittsim::render
