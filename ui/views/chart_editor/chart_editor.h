#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QActionGroup;
class QLabel;
class QMenu;
class QToolBar;

namespace knittsim::ui {

class CataloguePopup;
class ChartCanvas;
class ChartLook;
class StitchPalette;
class YarnPalette;

/// Tools, stitches, yarns and the chart.
class ChartEditor : public QWidget {
    Q_OBJECT

public:
    ChartEditor(document::Document& document, ChartLook& look, QWidget* parent = nullptr);

    ChartCanvas* canvas() const { return m_canvas; }
    /// Puts the tools, and what is done with a selection, into a menu, with their keys.
    void addTo(QMenu* menu) const;
    /// Only a chart has these actions.
    void setUsable(bool on);

private:
    QAction* addTool(int tool, const QString& name, const QString& text, const QKeySequence& key,
                     const QString& iconName);
    QAction* addEdit(const QString& name, const QString& text, const QKeySequence& key,
                     const std::function<void()>& action, QMenu* menu = nullptr);
    void buildTools();
    void buildEdits();
    void buildCourseEdits();
    void buildDirections(); ///< shifts, moves and repeats by arrow keys
    void buildBrushMenu();
    void takeStitch();
    void takeYarn();
    QString brushText() const;
    void takeToolHint();
    void takeBeds();
    void takeBrush();
    void takeFollowing();

    document::Document& m_document;
    ChartCanvas* m_canvas;
    StitchPalette* m_stitches;
    YarnPalette* m_yarns;
    CataloguePopup* m_catalogue;
    QToolBar* m_tools;
    QActionGroup* m_toolGroup;
    QLabel* m_toolHint; ///< what the tool at hand does
    QLabel* m_hint;     ///< what is under the pointer, and what went wrong
    QMenu* m_brushMenu;
    QMenu* m_directionMenu;
    QList<QAction*> m_toolActions;
    QList<QAction*> m_editActions;
    QAction* m_beds = nullptr; ///< checked: the chart works on both
};

} // namespace knittsim::ui
