#include "ui/views/diagnostics/diagnostics_panel.h"

#include "core/base/message_table.h"

#include <QComboBox>
#include <QHBoxLayout>
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
    : QWidget(parent), m_document(document), m_list(new DiagnosticsList(this)), m_rules(new QComboBox(this)) {
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(4, 2, 4, 2);
    for (const Severity severity : kWorstFirst) {
        auto* button = new QToolButton(this);
        button->setObjectName(objectNameOf(severity));
        button->setCheckable(true);
        button->setChecked(true);
        button->setAutoRaise(true);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
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
    bar->addWidget(m_rules, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(bar);
    layout->addWidget(m_list, 1);
    connect(m_list, &DiagnosticsList::placeWanted, this, &DiagnosticsPanel::placeWanted);
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
    m_list->setProblems(problems);
}

void DiagnosticsPanel::takeRules() {
    std::map<std::string, int> counts;
    for (const Diagnostic& problem : m_document.problems()) {
        ++counts[problem.id];
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
