#include "ui/views/diagnostics/diagnostics_panel.h"

#include "core/base/message_table.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace knittsim::ui {

namespace {

constexpr std::array kWorstFirst{Severity::Error, Severity::Warning, Severity::Info};

QString countText(Severity severity, int count) {
    switch (severity) {
    case Severity::Error:
        return count == 1 ? DiagnosticsPanel::tr("1 error") : DiagnosticsPanel::tr("%1 errors").arg(count);
    case Severity::Warning:
        return count == 1 ? DiagnosticsPanel::tr("1 warning")
                          : DiagnosticsPanel::tr("%1 warnings").arg(count);
    case Severity::Info:
        break;
    }
    return count == 1 ? DiagnosticsPanel::tr("1 note") : DiagnosticsPanel::tr("%1 notes").arg(count);
}

QString objectNameOf(Severity severity) {
    return severity == Severity::Error     ? QStringLiteral("showErrors")
           : severity == Severity::Warning ? QStringLiteral("showWarnings")
                                           : QStringLiteral("showNotes");
}

} // namespace

DiagnosticsPanel::DiagnosticsPanel(document::Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_list(new DiagnosticsList(this)), m_rules(new QComboBox(this)),
      m_off(new QToolButton(this)), m_report(new QToolButton(this)) {
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(4, 2, 4, 2);
    for (const Severity severity : kWorstFirst) {
        auto* button = new QToolButton(this);
        button->setObjectName(objectNameOf(severity));
        button->setCheckable(true);
        button->setChecked(true);
        button->setAutoRaise(true);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setToolTip(tr("Shows or hides these problems"));
        connect(button, &QToolButton::toggled, this,
                [this, severity](bool shown) { m_list->filter().showSeverity(severity, shown); });
        m_severities[static_cast<std::size_t>(severity)] = button;
        bar->addWidget(button);
    }
    m_rules->setObjectName(QStringLiteral("ruleChoice"));
    m_rules->setAccessibleName(tr("Rule"));
    m_rules->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_rules->setMinimumContentsLength(12);
    connect(m_rules, &QComboBox::currentIndexChanged, this,
            [this] { m_list->filter().showRule(m_rules->currentData().toString()); });
    m_rules->setToolTip(tr("Shows the problems of one rule only"));
    bar->addWidget(m_rules, 1);
    m_off->setObjectName(QStringLiteral("showOff"));
    m_off->setCheckable(true);
    m_off->setAutoRaise(true);
    m_off->setToolTip(tr("Shows the problems of rules that are turned off, with the reason"));
    connect(m_off, &QToolButton::toggled, this, [this](bool shown) { m_list->filter().showOff(shown); });
    bar->addWidget(m_off);
    m_report->setObjectName(QStringLiteral("exportReport"));
    m_report->setAutoRaise(true);
    m_report->setText(tr("Export report\u2026"));
    m_report->setToolTip(tr("Writes machine, sizes, yarn, time and all problems to a file (Ctrl+Shift+E)"));
    connect(m_report, &QToolButton::clicked, this, &DiagnosticsPanel::reportWanted);
    bar->addWidget(m_report);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(bar);
    layout->addWidget(m_list, 1);
    connect(m_list, &DiagnosticsList::placeWanted, this, &DiagnosticsPanel::placeWanted);
    connect(m_list, &DiagnosticsList::offWanted, this, &DiagnosticsPanel::askToTurnOff);
    connect(m_list, &DiagnosticsList::onWanted, this,
            [this](const QString& rule) { m_document.turnRuleOn(rule.toStdString()); });
    connect(&m_document, &document::Document::problemsChanged, this, &DiagnosticsPanel::takeProblems);
    takeProblems();
}

void DiagnosticsPanel::takeProblems() {
    const Diagnostics& problems = m_document.problems();
    for (const Severity severity : kWorstFirst) {
        const auto count = static_cast<int>(std::ranges::count(problems, severity, &Diagnostic::severity));
        QToolButton* button = m_severities[static_cast<std::size_t>(severity)];
        button->setText(countText(severity, count));
        button->setIcon(severityIcon(severity));
        button->setEnabled(count > 0);
    }
    takeRules();
    const auto off = static_cast<int>(m_document.waived().size());
    m_off->setText(tr("%1 turned off").arg(off));
    m_off->setVisible(off > 0 || m_off->isChecked());
    m_off->setEnabled(off > 0);
    m_report->setEnabled(m_document.file() || m_document.failedFile());
    m_list->setProblems(problems, m_document.waived());
}

void DiagnosticsPanel::askToTurnOff(const QString& rule) {
    auto* dialog = new QInputDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("turnOffDialog"));
    dialog->setWindowTitle(tr("Turn off a rule"));
    dialog->setLabelText(
        tr("%1 will not count in any file. Why not? The reason stays with the problems.").arg(rule));
    dialog->setOkButtonText(tr("Turn off"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this, rule](const QString& reason) {
        if (const QString text = reason.simplified(); !text.isEmpty()) {
            m_document.turnRuleOff(rule.toStdString(), text.toStdString());
        }
    });
    dialog->open();
}

void DiagnosticsPanel::takeRules() {
    std::map<std::string, int> counts;
    for (const Diagnostic& problem : m_document.problems()) {
        ++counts[problem.id];
    }
    for (const machine::Waived& waived : m_document.waived()) {
        ++counts[waived.finding.id];
    }
    const QSignalBlocker quiet(m_rules);
    m_rules->clear();
    m_rules->addItem(tr("All rules"), QString());
    for (const auto& [id, count] : counts) {
        const Message* message = findMessage(id);
        const QString rule = QString::fromStdString(id);
        const QString name =
            message == nullptr
                ? QString()
                : QString::fromUtf8(message->name.data(), static_cast<qsizetype>(message->name.size()));
        m_rules->addItem(QStringLiteral("%1 %2 (%3)").arg(rule, name).arg(count), rule);
    }
    m_list->filter().showRule({});
}

} // namespace knittsim::ui
