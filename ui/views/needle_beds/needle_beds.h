#pragma once

#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/machine/bed_motion.h"
#endif

#include "ui/document/document.h"
#include "ui/views/needle_beds/bed_layout.h"
#include "ui/views/needle_beds/operation_clock.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <optional>

namespace knittsim::ui {

/// The needle beds at the operation that is shown: from above and from the side. A single step is shown
/// moving; a click selects the loop on top of a needle. Drag pans, Ctrl and the wheel zoom; until then the
/// view follows the working needle, and does again after a double click.
class NeedleBeds : public QWidget {
    Q_OBJECT

public:
    explicit NeedleBeds(document::Document& document, QWidget* parent = nullptr);

    /// The player plays: steps follow each other at its speed. When it stops, motion stops where it is.
    void setPlaying(bool on);
    void setSpeed(double operationsPerSecond);

    /// Fits what the program uses, if needles stay readable, and follows the working needle from now on.
    void follow();
    bool isFollowing() const { return m_following; }

    const OperationClock& clock() const { return m_clock; }
    /// What is shown now.
    machine::BedPicture picture() const;
    /// Where a needle is drawn.
    QPoint placeOf(machine::Needle needle) const;
    double pitchPixels() const { return m_layout.pitch; }

    QSize sizeHint() const override { return {900, 260}; }
    QSize minimumSizeHint() const override { return {260, 130}; }

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void takeFile();
    void takeStep();
    void takeMotion();
    void tick();
    void arrange();
    void keepInSight();
    void zoomAt(double x, double factor);
    void paintNames(QPainter& painter, double rack);
    double durationMs() const;
    std::optional<double> workingPlace() const;
    QString textAt(QPoint point) const;

    document::Document& m_document;
    std::shared_ptr<const document::OpenedFile> m_file; ///< of m_motion
    std::optional<machine::BedMotion> m_motion;
    OperationClock m_clock;
    QTimer m_timer;
    QElapsedTimer m_sinceTick;
    double m_speed = 20;
    bool m_playing = false;
    BedLayout m_layout;
    QRectF m_side; ///< empty where there is no room
    QFont m_face;
    bool m_following = true;
    bool m_zoomed = false;
    bool m_dragging = false;
    QPoint m_pressed;
    double m_centreAtPress = 0;
};

} // namespace knittsim::ui
