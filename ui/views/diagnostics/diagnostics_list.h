#pragma once

#include "ui/document/document.h"
#include "ui/views/diagnostics/diagnostics_model.h"

#include <QTreeView>

namespace knittsim::ui {

/// The problems of the last file tried. activated() is answered by the window, which shows the line.
class DiagnosticsList : public QTreeView {
    Q_OBJECT

public:
    explicit DiagnosticsList(document::Document& document, QWidget* parent = nullptr);

    int problemCount() const { return m_model.rowCount(); }

    /// Goes to the next (+1) or previous (-1) problem and shows its place.
    void walk(int direction);

    QSize sizeHint() const override { return {480, 130}; }
    QSize minimumSizeHint() const override { return {180, 72}; }

signals:
    void placeWanted(const knittsim::Diagnostic& problem);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void takeProblems();
    void showPlace(const QModelIndex& index);

    document::Document& m_document;
    DiagnosticsModel m_model;
};

} // namespace knittsim::ui
