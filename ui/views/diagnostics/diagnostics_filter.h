#pragma once

#include "core/base/diagnostic.h"

#include <QSortFilterProxyModel>

#include <array>

namespace knittsim::ui {

/// The problems that are shown, in the order wanted: by severity, by place or by words. Before a column is
/// chosen they stay in the order of the document.
class DiagnosticsFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void showSeverity(Severity severity, bool shown);
    /// Shows only this rule; all rules when empty.
    void showRule(const QString& rule);
    /// Also those that do not count.
    void showOff(bool shown);

    const Diagnostic& problemAt(const QModelIndex& index) const;
    /// Why it does not count; empty where it does.
    QString offReason(const QModelIndex& index) const;

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    const Diagnostic& sourceProblem(int row) const;

    std::array<bool, 3> m_shown{true, true, true}; ///< by Severity
    QString m_rule;
    bool m_off = false;
};

} // namespace knittsim::ui
