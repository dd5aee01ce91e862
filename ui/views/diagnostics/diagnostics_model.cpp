#include "ui/views/diagnostics/diagnostics_model.h"

#include "ui/document/message_text.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"

#include <QGuiApplication>

namespace knittsim::ui {

namespace {

QString textOf(const Diagnostic& problem, int column) {
    switch (column) {
    case DiagnosticsModel::Kind:
        return document::severityText(problem.severity) + u' ' + QString::fromStdString(problem.id);
    case DiagnosticsModel::Where:
        return document::placeText(problem.place);
    default:
        return (document::causeText(problem) + u' ' + document::cureText(problem)).trimmed();
    }
}

} // namespace

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

void DiagnosticsModel::setProblems(const Diagnostics& problems) {
    beginResetModel();
    m_problems = problems;
    endResetModel();
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
        return textOf(problem, index.column());
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
