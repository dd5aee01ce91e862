#include "ui/views/diagnostics/diagnostics_filter.h"

#include "ui/views/diagnostics/diagnostics_model.h"

#include <tuple>

namespace knittsim::ui {

void DiagnosticsFilter::showSeverity(Severity severity, bool shown) {
    m_shown[static_cast<std::size_t>(severity)] = shown;
    invalidateFilter();
}

void DiagnosticsFilter::showRule(const QString& rule) {
    m_rule = rule;
    invalidateFilter();
}

void DiagnosticsFilter::showOff(bool shown) {
    m_off = shown;
    invalidateFilter();
}

QString DiagnosticsFilter::offReason(const QModelIndex& index) const {
    return static_cast<const DiagnosticsModel*>(sourceModel())->offReason(mapToSource(index).row());
}

const Diagnostic& DiagnosticsFilter::problemAt(const QModelIndex& index) const {
    return sourceProblem(mapToSource(index).row());
}

const Diagnostic& DiagnosticsFilter::sourceProblem(int row) const {
    return static_cast<const DiagnosticsModel*>(sourceModel())->problems()[static_cast<std::size_t>(row)];
}

bool DiagnosticsFilter::filterAcceptsRow(int row, const QModelIndex&) const {
    const Diagnostic& problem = sourceProblem(row);
    return m_shown[static_cast<std::size_t>(problem.severity)] &&
           (m_off || static_cast<const DiagnosticsModel*>(sourceModel())->offReason(row).isEmpty()) &&
           (m_rule.isEmpty() || m_rule == QLatin1String(problem.id.c_str()));
}

bool DiagnosticsFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const Diagnostic& a = sourceProblem(left.row());
    const Diagnostic& b = sourceProblem(right.row());
    if (left.column() == DiagnosticsModel::Kind) { // the worst first
        return std::tie(b.severity, a.id, a.place.line) < std::tie(a.severity, b.id, b.place.line);
    }
    if (left.column() == DiagnosticsModel::Where) {
        return std::tie(a.place.line, a.place.operation) < std::tie(b.place.line, b.place.operation);
    }
    return left.data().toString().localeAwareCompare(right.data().toString()) < 0;
}

} // namespace knittsim::ui
