#pragma once

#include "ui/render/fabric_renderer.h"
#include "ui/render/scene_worker.h"

#include <QImage>
#include <QString>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace knittsim::ui {

/// What a canvas paints. Window thread.
struct CanvasContent {
    std::shared_ptr<const render::SceneFrame> scene;
    std::vector<render::YarnLook> looks;
    render::Camera camera;
    int selected = -1;                           ///< loop
    int hovered = -1;                            ///< loop
    std::optional<Vec3f> mark;                   ///< place of the selected bonding point
    std::vector<Vec3f> pins;                     ///< places that are held
    std::optional<std::pair<Vec3f, Vec3f>> pull; ///< where a person pulls yarn, and where to
    render::ColourBy colourBy = render::ColourBy::Yarn;
    std::optional<render::Section> section;
    bool hair = true;                         ///< of hairy yarn seen near by
    std::optional<render::DetailLevel> level; ///< of detail, fixed by the person
    bool dark = false;
    bool legend = true;                            ///< explain the bare mesh
    double paintMs = 0;                            ///< told back by the canvas, as is what it drew:
    std::optional<render::DetailLevel> levelDrawn; ///< nothing: none is known
    std::function<void()> painted = [] {};         ///< called after these have changed
};

/// Something that shows the fabric: OpenGL, software OpenGL on a thread, or QPainter where there is none.
class Canvas {
public:
    virtual ~Canvas() = default;
    virtual QWidget* widget() = 0;
    virtual void refresh() { widget()->update(); } ///< the content has changed
    virtual QString rendererName() const = 0;      ///< empty before the first paint or without OpenGL
    virtual QImage picture() = 0;
};

/// Draws with the window system's OpenGL. Null when it offers none, or less than 3.3, or software only and
/// `software` does not allow that; `reason` then says why. `content` must outlive the canvas. `failed` is
/// called, from the event loop, when drawing turns out to be impossible later.
std::unique_ptr<Canvas> makeGlCanvas(QWidget* parent, CanvasContent& content,
                                     std::function<void(QString)> failed, QString& reason, bool software);

/// Draws with OpenGL on a thread of its own (software OpenGL is slow) and paints the pictures. Needs no
/// OpenGL of the window system. Null when there is no OpenGL at all; `reason` then says why. `failed` as
/// above.
std::unique_ptr<Canvas> makeThreadedCanvas(QWidget* parent, CanvasContent& content,
                                           std::function<void(QString)> failed, QString& reason);

std::unique_ptr<Canvas> makeFlatCanvas(QWidget* parent, CanvasContent& content);

} // namespace knittsim::ui
