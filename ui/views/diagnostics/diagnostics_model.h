#pragma once

#include "core/machine/checks/check.h"

#include <QAbstractTableModel>

class QIcon;

namespace knittsim::ui {

/// Sign of a severity in its colour.
QIcon severityIcon(Severity severity);

/// Problems as a table. Plain copy of what the document found.
class DiagnosticsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Kind, Where, What, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    /// Those that count, then those that do not.
    void setProblems(const Diagnostics& problems, const std::vector<machine::Waived>& waived);
    const Diagnostics& problems() const { return m_problems; }

    /// Why the problem of this row does not count; empty where it does.
    QString offReason(int row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString textOf(int row, int column) const;

    Diagnostics m_problems;
    QStringList m_reasons; ///< of the last rows
};

} // namespace knittsim::ui
