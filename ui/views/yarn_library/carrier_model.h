#pragma once

#include "ui/document/document.h"
#include "ui/views/yarn_library/yarn_model.h"

namespace knittsim::ui {

/// The carriers that the program uses, or the chart has a yarn for, with their yarns. A yarn dropped on a row
/// goes onto that carrier.
class CarrierModel : public QAbstractListModel {
    Q_OBJECT

public:
    explicit CarrierModel(document::Document& document, QObject* parent = nullptr);

    /// Index into Document::carriers(), or -1.
    int carrierAt(const QModelIndex& index) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QStringList mimeTypes() const override { return {kYarnMime}; }
    Qt::DropActions supportedDropActions() const override { return Qt::CopyAction; }
    bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                         const QModelIndex& parent) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

private:
    void takeFile();
    std::vector<int> rows() const;

    document::Document& m_document;
    std::vector<int> m_rows;
};

} // namespace knittsim::ui
