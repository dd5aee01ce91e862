#include "ui/views/diagnostics/diagnostics_model.h"

#include "ui/document/message_text.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"

#include <QGuiApplication>

namespace knittsim::ui {

QIcon severityIcon(Severity severity) {
    const Accents accents = accentsOf(QGuiApplication::palette());
    switch (severity) {
    case Severity::Error:
        return icon(QStringLiteral("error"), accents.error);
    case Severity::Warning:
        return icon(QStringLiteral("warning"), accents.warning);
    case Severity::Info:
        break;
    }
    return icon(QStringLiteral("info"), accents.busy);
}

void DiagnosticsModel::setProblems(const Diagnostics& problems, const std::vector<machine::Waived>& waived) {
    beginResetModel();
    m_problems = problems;
    m_reasons.clear();
    for (const machine::Waived& problem : waived) {
        m_problems.push_back(problem.finding);
        m_reasons << QString::fromStdString(problem.reason);
    }
    endResetModel();
}

QString DiagnosticsModel::offReason(int row) const {
    return m_reasons.value(row - (static_cast<int>(m_problems.size()) - static_cast<int>(m_reasons.size())));
}

QString DiagnosticsModel::textOf(int row, int column) const {
    const Diagnostic& problem = m_problems[static_cast<std::size_t>(row)];
    const QString reason = offReason(row);
    switch (column) {
    case Kind:
        return (reason.isEmpty() ? document::severityText(problem.severity) : tr("Off")) + u' ' +
               QString::fromStdString(problem.id);
    case Where:
        return document::placeText(problem.place);
    default:
        return (reason.isEmpty() ? QString() : tr("Turned off: %1.").arg(reason) + u' ') +
               (document::causeText(problem) + u' ' + document::cureText(problem)).trimmed();
    }
}

int DiagnosticsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_problems.size());
}

int DiagnosticsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant DiagnosticsModel::data(const QModelIndex& index, int role) const {
    const Diagnostic& problem = m_problems[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
        return textOf(index.row(), index.column());
    case Qt::DecorationRole:
        return index.column() == Kind ? QVariant(severityIcon(problem.severity)) : QVariant();
    default:
        return {};
    }
}

QVariant DiagnosticsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    return section == Kind    ? tr("Problem")
           : section == Where ? tr("Place")
                              : tr("What is wrong and what helps");
}

} // namespace knittsim::ui
