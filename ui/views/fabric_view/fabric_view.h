#pragma once

#include "core/fabric/fabric.h"
#include "core/simulation/frame.h"
#include "core/simulation/yarn_picture.h"
#include "ui/render/camera.h"
#include "ui/render/colour_scale.h"
#include "ui/render/look.h"
#include "ui/render/section.h"
#include "ui/views/fabric_view/annotations.h"

#include <QByteArray>
#include <QImage>
#include <QStringList>
#include <QVector3D>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace knittsim::ui {

/// The fabric in three dimensions. Draws only when something changed; curves are built on a worker thread,
/// the latest picture wins. Without OpenGL 3.3 it says so (glFailed) and paints the fabric flat with
/// QPainter.
///
/// Mouse: left drag orbits, middle or Shift+left drag pans, wheel zooms at the cursor, click selects a
/// stitch or sets the tape, Ctrl+left drag (or any left drag in drag mode) on yarn pulls its bonding point.
/// All functions: window thread.
class FabricView : public QWidget {
    Q_OBJECT

public:
    explicit FabricView(QWidget* parent = nullptr);
    ~FabricView() override;

    /// Shows another fabric at its machine positions until a frame comes. `looks` by carrier. Keeps the
    /// camera; the first fabric after an empty view is fitted. Null empties the view.
    void setFabric(std::shared_ptr<const fabric::Fabric> fabric, std::vector<render::YarnLook> looks);

    /// New positions. Frames whose position count does not match the fabric are ignored.
    void setFrame(std::shared_ptr<const simulation::Frame> frame);

    /// The yarn itself instead of curves through bonding points, until the next frame or fabric; not in the
    /// mesh style. Of the present fabric; null ends it.
    void setYarn(std::shared_ptr<const simulation::YarnPicture> yarn);

    /// What the colours of the yarns tell, with a legend.
    void setColourBy(render::ColourBy what);
    render::ColourBy colourBy() const;

    /// Marks bonding points (indices into Fabric::points) that are held, until another fabric comes.
    void setPins(std::vector<int> points);

    /// Colours and surfaces by carrier; never touches the shape, except where a diameter changed.
    void setLooks(std::vector<render::YarnLook> looks);

    void setStyle(render::DrawStyle style);
    render::DrawStyle style() const;

    /// Highlights one loop (index into Fabric::loops); -1 for none. Emits nothing.
    void setSelection(int loop);
    int selection() const;

    /// Rings a bonding point (index into Fabric::points); -1 for none. Emits nothing.
    void setSelectedPoint(int point);

    /// Moves the camera so that a loop lies in the middle; keeps direction and zoom.
    void centreOn(int loop);

    void fit();
    void setFollowing(bool on); ///< keeps a changing fabric fitted until the person moves the camera
    /// For a class: fit() and following show the loops on the needles and the courses below them, names are
    /// large, measures are left out.
    void setForClass(bool on);
    void lookFront();
    void lookBack();
    void lookTop();
    void lookBottom();
    void lookLeft();
    void lookRight();
    void zoomBy(double factor); ///< > 1 comes nearer, about the middle

    void setOrthographic(bool on);
    bool isOrthographic() const;
    void setDark(bool on); ///< dark or light background
    void setHair(bool on); ///< loose fibres of hairy yarn, seen near by
    bool hasHair() const;
    void setDetail(std::optional<render::DetailLevel> level); ///< nothing: as the size on the screen asks
    std::optional<render::DetailLevel> detail() const;
    /// What the last picture shows; nothing in the mesh style, and where it is not known.
    std::optional<render::DetailLevel> detailDrawn() const;
    void setLegend(bool on); ///< explains the bonding points of the mesh style
    bool hasLegend() const;
    void setDragMode(bool on); ///< plain left drag pulls bonding points

    // Annotations. All have a legend in the picture; none is part of picture().
    /// What the picture is not yet, below the badge; empty: nothing.
    void setNotice(const QString& text);
    void setDimensions(bool on); ///< width, height and gauge
    bool hasDimensions() const;
    void setGuides(bool on); ///< numbered lines along courses and wales
    bool hasGuides() const;
    void setProblemMarks(bool on);
    bool hasProblemMarks() const;
    int problemMarkCount() const;                        ///< that are placed
    void setProblems(std::vector<LoopProblem> problems); ///< of the present fabric; setFabric() forgets them
    /// Needles from which loops of the present frame hang.
    void setNeedles(std::vector<fabric::NeedleHook> needles);
    void setTaping(bool on); ///< clicks set the two ends of a measuring tape instead of selecting
    bool isTaping() const;

    /// Cuts away what lies before a plane through the selected stitch, else through the middle of the fabric,
    /// parallel to the picture. Alt and wheel move it. An empty view forgets it.
    void setSection(bool on);
    const std::optional<render::Section>& section() const;

    /// Hides all but the yarn or the course of the selected loop, else of the one under the mouse. False, and
    /// nothing changed, where there is none. An empty view forgets it.
    enum class Alone { Nothing, Yarn, Course };
    bool showAlone(Alone what);
    Alone alone() const;
    QString shownPart() const;             ///< what is shown alone, in words; empty: all
    std::vector<bool> shownPoints() const; ///< by bonding point of the fabric shown; empty: all

    /// A photograph over or beside the fabric; it stays when the fabric changes.
    void setPhotograph(Photograph photograph);
    const Photograph& photograph() const;
    /// The next four clicks align it: a point of the photograph, the same of the fabric, and once more. False
    /// where there is nothing to align.
    bool startAlignment();
    bool cancelAlignment(); ///< whether it ran
    bool isAligning() const;
    bool seesBack() const; ///< the camera looks at the technical back

    /// What the tool tip says of a loop.
    void setDescriber(std::function<QString(int loop)> describer);

    QStringList words() const;                                ///< of badge and legends, as they are painted
    std::optional<geometry::Measurement> measurement() const; ///< of the shape wanted

    render::CameraState cameraState() const;
    void setCameraState(const render::CameraState& state); ///< emits cameraMoved()
    geometry::Bounds bounds() const;                       ///< of the yarn shown, mm; empty: nothing is shown

    /// fit() leaves room for a box of this size too, mm, so that two fabrics can be seen in one scale.
    void setFitRoom(const Vec3f& size);

    /// Style, colours and annotations as in another view; not its legends' content.
    void takeDisplay(const FabricView& other);

    /// Camera direction, place, zoom and kind of projection. restoreCamera() returns false for foreign bytes.
    QByteArray saveCamera() const;
    bool restoreCamera(const QByteArray& bytes);

    bool hasOpenGl() const;       ///< false after glFailed
    QString rendererName() const; ///< GL_RENDERER, empty before the first paint or without OpenGL
    double lastPaintMs() const;   ///< time of the last drawn frame on this thread

    bool isUpToDate() const; ///< the picture is of the fabric that was set last

    /// The picture as shown, without badge and scale bar; also without OpenGL and while the view is hidden.
    QImage picture();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void loopClicked(int loop);   ///< -1: clicked beside the yarn
    void pointClicked(int point); ///< after loopClicked: the bonding point nearest on the yarn, or -1
    void loopHovered(int loop);   ///< -1: left the yarn
    void dragMoved(int point, QVector3D placeMm); ///< the yarn at a bonding point, to there
    void dragEnded();
    void cameraMoved();
    void photographChanged();
    void detailDrawnChanged();
    void displayChanged();             ///< what takeDisplay() takes
    void sceneChanged();               ///< another shape is shown; bounds()
    void measured(double millimetres); ///< both ends of the tape are set
    void glFailed(QString reason);     ///< once; a sentence for the user

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Implementation;
    std::unique_ptr<Implementation> m;
};

} // namespace knittsim::ui
