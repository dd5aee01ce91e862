#pragma once

#include "ui/document/document.h"
#include "ui/views/diagnostics/diagnostics_list.h"

#include <array>

class QComboBox;
class QToolButton;

namespace knittsim::ui {

/// The problems of the last file tried: a switch with the count for each severity, a choice of the rule, and
/// the list. placeWanted() is answered by the window, which shows line and stitch.
class DiagnosticsPanel : public QWidget {
    Q_OBJECT

public:
    explicit DiagnosticsPanel(document::Document& document, QWidget* parent = nullptr);

    void walk(int direction) { m_list->walk(direction); }

    QSize sizeHint() const override { return {480, 160}; }
    QSize minimumSizeHint() const override { return {180, 96}; }

signals:
    void placeWanted(const knittsim::Diagnostic& problem);
    void reportWanted();

private:
    void takeProblems();
    void takeRules();
    void askToTurnOff(const QString& rule);

    document::Document& m_document;
    DiagnosticsList* m_list;
    QComboBox* m_rules;
    QToolButton* m_off;
    QToolButton* m_report;
    std::array<QToolButton*, 3> m_severities{}; ///< by Severity
};

} // namespace knittsim::ui
