#pragma once

#include "ui/views/fabric_view/annotation_painter.h"

#include <QWidget>

#include <functional>
#include <vector>

namespace knittsim::ui {

/// Badge of the side that is seen and words beside it, legends of the mesh and of the colours, scale bar,
/// axes, a ring round the selected bonding point and the annotations, pins and a person's pull, painted over
/// the picture. Lets all events through.
class Overlay : public QWidget {
    Q_OBJECT

public:
    Overlay(QWidget* parent, const CanvasContent& content, const Annotations& annotations);

    /// Called before each painting: brings the annotations up to date.
    void onPaint(std::function<void()> prepare) { m_prepare = std::move(prepare); }

    /// Shown in the middle while there is nothing to see, and as a note above the scale bar.
    void setMessage(const QString& message);

    /// "technical face", "technical back", or that the fabric is seen from its edge.
    QString sideText() const;

    /// What the annotations say in words: what lines and signs are, what is shown alone, how to measure. With
    /// a line of `sample`, where that is valid.
    struct Word {
        QString text;
        QColor sample{};
    };
    std::vector<Word> words() const;

    /// Pixels that badge, words and legends take from the upper edge (the lower one in a class).
    int headHeight() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct WordBox {
        QRect place;
        Word word;
    };
    /// From the upper left corner: words beside each other in as many rows as they need, legends below them.
    struct Head {
        std::vector<WordBox> words;
        QRect legend;   ///< empty where none is shown
        QRect colours;  ///< the same
        int height = 0; ///< with room below it
    };
    Head layOut() const;
    QSize legendSize() const;  ///< empty where none is shown
    QSize coloursSize() const; ///< the same
    QString coloursTitle() const;
    QString noColoursReason() const;
    void paintPhoto(QPainter& painter) const;
    void paintHead(QPainter& painter) const;
    void paintWord(QPainter& painter, const WordBox& box) const;
    void paintLegend(QPainter& painter, const QRect& box) const;
    void paintColours(QPainter& painter, const QRect& box) const;
    void paintPins(QPainter& painter) const;
    void paintPull(QPainter& painter) const;
    QPointF onScreen(const Vec3f& place) const;
    void paintMark(QPainter& painter) const;
    void paintScale(QPainter& painter) const;
    void paintAxes(QPainter& painter) const;
    void paintLabel(QPainter& painter, const QRectF& rect, const QString& text) const;
    void paintMessage(QPainter& painter) const;
    QColor ink() const { return overlayInk(m_content.dark).ink; }
    QColor ground() const { return overlayInk(m_content.dark).ground; }

    const CanvasContent& m_content;
    const Annotations& m_annotations;
    std::function<void()> m_prepare;
    QString m_message;
};

/// The longest of 1, 2, 5, 10, 20, ... and 0.1, 0.2, 0.5 mm that takes at most `mostPixels`.
double scaleBarMm(double millimetresPerPixel, double mostPixels);

} // namespace knittsim::ui
