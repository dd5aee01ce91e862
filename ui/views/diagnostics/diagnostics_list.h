#pragma once

#include "ui/views/diagnostics/diagnostics_filter.h"
#include "ui/views/diagnostics/diagnostics_model.h"

#include <QTreeView>

namespace knittsim::ui {

/// Problems as rows: a click on a header sorts, double click or Enter wants the place, Ctrl+C copies the
/// selected rows as text.
class DiagnosticsList : public QTreeView {
    Q_OBJECT

public:
    explicit DiagnosticsList(QWidget* parent = nullptr);

    void setProblems(const Diagnostics& problems, const std::vector<machine::Waived>& waived);
    DiagnosticsFilter& filter() { return m_filter; }

    /// Rows that are shown.
    int problemCount() const { return m_filter.rowCount(); }

    /// Goes to the next (+1) or previous (-1) problem that is shown and wants its place.
    void walk(int direction);

    /// The selected rows, or all that are shown where none is selected, a line each.
    QString asText() const;

signals:
    void placeWanted(const knittsim::Diagnostic& problem);
    void offWanted(const QString& rule); ///< turn this rule off
    void onWanted(const QString& rule);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void copy() const;
    void showPlace(const QModelIndex& index);

    DiagnosticsModel m_model;
    DiagnosticsFilter m_filter;
};

} // namespace knittsim::ui
