#pragma once

#include "core/base/diagnostic.h"

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

    void setProblems(const Diagnostics& problems);
    const Diagnostics& problems() const { return m_problems; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    Diagnostics m_problems;
};

} // namespace knittsim::ui
