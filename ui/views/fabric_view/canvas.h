#pragma once

#include "ui/render/fabric_renderer.h"
#include "ui/render/scene_worker.h"

#include <QImage>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

class QWidget;

namespace knittsim::ui {

/// What a canvas paints. Window thread.
struct CanvasContent {
    std::shared_ptr<const render::SceneFrame> scene;
    std::vector<render::YarnLook> looks;
    render::Camera camera;
    int selected = -1; ///< loop
    int hovered = -1;  ///< loop
    bool dark = false;
    double paintMs = 0; ///< told back by the canvas
};

/// Something that shows the fabric: OpenGL, or QPainter where there is none.
class Canvas {
public:
    virtual ~Canvas() = default;
    virtual QWidget* widget() = 0;
    virtual QString rendererName() const = 0; ///< empty before the first paint or without OpenGL
    virtual QImage picture() = 0;
};

/// Null when the platform gives no OpenGL 3.3 context; `reason` then says why. `content` must outlive the
/// canvas. `failed` is called, from the event loop, when drawing turns out to be impossible later.
std::unique_ptr<Canvas> makeGlCanvas(QWidget* parent, CanvasContent& content,
                                     std::function<void(QString)> failed, QString& reason);

std::unique_ptr<Canvas> makeFlatCanvas(QWidget* parent, CanvasContent& content);

} // namespace knittsim::ui
