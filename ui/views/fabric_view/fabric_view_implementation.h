#pragma once

#include "ui/render/scene_worker.h"
#include "ui/views/fabric_view/annotations.h"
#include "ui/views/fabric_view/canvas.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/fabric_view/overlay.h"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace knittsim::ui {

/// The parts of FabricView that no caller sees; its sources share them.
struct FabricView::Implementation {
    explicit Implementation(FabricView& owner);

    FabricView& view;
    CanvasContent content;
    std::shared_ptr<const fabric::Fabric> fabric;      ///< wanted
    std::shared_ptr<const fabric::Fabric> shownFabric; ///< of content.scene
    std::shared_ptr<const simulation::Frame> frame;
    std::vector<float> places; ///< of the bonding points of `fabric` in the shape wanted; 3 per entry, mm
    std::shared_ptr<const simulation::YarnPicture> yarn;  ///< see setYarn()
    std::vector<int> pins;                                ///< bonding points of `fabric`
    std::shared_ptr<const render::SceneFrame> wholeScene; ///< of which content.scene may be a part
    Annotations annotations;
    bool measured = false;               ///< size and lattice of the annotations are those of `places`
    std::array<QPointF, 2> photoPoints;  ///< pixels, while a photograph is aligned
    std::array<QPointF, 2> fabricPoints; ///< mm
    std::vector<LoopProblem> problems;   ///< of `fabric`
    std::function<QString(int)> describer;
    Alone alone = Alone::Nothing;
    int aloneIndex = -1;    ///< yarn or course
    std::vector<bool> keep; ///< by bonding point of shownFabric: what is shown; empty: all
    render::DrawStyle style = render::DrawStyle::Yarn;
    std::unique_ptr<Canvas> canvas;
    Overlay* overlay = nullptr;
    bool hasGl = true;
    QString glReason;
    bool fitPending = true;        ///< fit as soon as there is a picture
    bool following = false;        ///< see setFollowing()
    bool forClass = false;         ///< see setForClass()
    bool followFit = true;         ///< the person has not moved the camera since the last fit
    Vec3f fitRoom = Vec3f::Zero(); ///< see setFitRoom()
    float fittedAbove = 0;         ///< what above() was at the last fit
    bool dragMode = false;
    int selectedPoint = -1; ///< of `fabric`
    std::optional<render::DetailLevel> shownDetail;

    enum class Gesture { None, Press, Orbit, Pan, Pull } gesture = Gesture::None;
    QPointF pressed;
    QPointF last;
    geometry::Pick pulled;
    std::optional<Vec3f> pullTarget; ///< once the mouse has moved

    void makeCanvas();
    std::unique_ptr<Canvas> threadedCanvas(QString& reason);
    void useAnotherCanvas(const QString& reason);
    void useFlatCanvas(const QString& reason);
    void placeChildren();
    void request();
    void takePicture();
    void changed();
    geometry::Bounds fitBox() const;
    geometry::Bounds needleBox() const;
    void fit(render::Camera& camera) const;
    float above() const;
    void headChanged();
    void fitCamera();
    void followScene();
    void moveCamera(const std::function<void(render::Camera&)>& move);
    void look(render::ViewSide side);
    std::optional<geometry::Pick> pickAt(QPointF where) const;
    void hover(int loop);
    void placeMarks();
    void pullTo(QPointF where);
    Vec3f placeOf(fabric::EntryIndex entry) const;
    std::optional<Vec3f> placeOfLoop(int loop) const;
    void takePlaces(std::span<const float> positions);
    void annotate();
    void measure();
    void alignClick(QPointF where);
    void showParts();
    std::optional<Vec3f> tapePlaceAt(QPointF where) const;
    void tapeClick(QPointF where);
    void moveSection(double notches);
    QString describe(int loop) const;
    void takeDetail();

    render::SceneWorker worker; // last: it may call back until it is gone
};

} // namespace knittsim::ui
