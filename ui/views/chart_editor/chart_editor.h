#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QActionGroup;
class QLabel;
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
    /// Tools and what is done with a selection, with their keys, for a menu.
    QList<QAction*> toolActions() const { return m_toolActions; }
    QList<QAction*> editActions() const { return m_editActions; }

private:
    QAction* addTool(int tool, const QString& name, const QString& text, const QKeySequence& key,
                     const QString& iconName);
    void addEdit(const QString& name, const QString& text, const QKeySequence& key,
                 const std::function<void()>& action);
    void buildTools();
    void buildEdits();
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
    QLabel* m_hint;
    QList<QAction*> m_toolActions;
    QList<QAction*> m_editActions;
    QAction* m_beds = nullptr; ///< checked: the chart works on both
};

} // namespace knittsim::ui
