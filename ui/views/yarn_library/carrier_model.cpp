#include "ui/views/yarn_library/carrier_model.h"

#include <QColor>
#include <QMimeData>

#include <algorithm>

namespace knittsim::ui {

CarrierModel::CarrierModel(document::Document& document, QObject* parent)
    : QAbstractListModel(parent), m_document(document) {
    connect(&m_document, &document::Document::fileChanged, this, &CarrierModel::takeFile);
    connect(&m_document, &document::Document::chartChanged, this, [this] {
        if (m_rows != rows()) {
            takeFile();
        }
    });
    connect(&m_document, &document::Document::yarnsChanged, this, [this] {
        if (!m_rows.empty()) {
            emit dataChanged(index(0), index(rowCount() - 1));
        }
    });
    takeFile();
}

void CarrierModel::takeFile() {
    beginResetModel();
    m_rows = rows();
    endResetModel();
}

std::vector<int> CarrierModel::rows() const {
    std::vector<int> found;
    const auto project = m_document.project();
    const auto& carriers = m_document.carriers();
    for (std::size_t i = 0; i < carriers.size(); ++i) {
        const bool drawn = project && std::ranges::count(project->chart.yarns, carriers[i].carrier,
                                                         &pattern::ChartYarn::carrier) > 0;
        if (carriers[i].used || drawn) {
            found.push_back(static_cast<int>(i));
        }
    }
    return found;
}

int CarrierModel::carrierAt(const QModelIndex& index) const {
    const auto row = static_cast<std::size_t>(index.row());
    return index.isValid() && row < m_rows.size() ? m_rows[row] : -1;
}

int CarrierModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

QVariant CarrierModel::data(const QModelIndex& index, int role) const {
    const int carrier = carrierAt(index);
    if (carrier < 0) {
        return {};
    }
    const document::CarrierYarn& row = m_document.carriers()[static_cast<std::size_t>(carrier)];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
        return tr("Carrier %1: %2")
            .arg(QString::fromStdString(row.carrier), QString::fromStdString(row.yarn.name));
    case TitleRole:
        return QString::fromStdString(row.yarn.name);
    case DetailRole:
        return QString::fromStdString(row.yarn.count);
    case ColourRole:
        return colourOf(row.yarn);
    case PliesRole:
        return row.yarn.surface.plies;
    case BadgeRole:
        return QString::fromStdString(row.carrier);
    case IdRole:
        return QString::fromStdString(row.yarn.id);
    case Qt::ToolTipRole:
        return tr("Carrier %1. Drop a yarn of the library here; the fabric goes on from its shape. "
                  "Double click or Enter: another colour.")
            .arg(QString::fromStdString(row.carrier));
    default:
        return {};
    }
}

Qt::ItemFlags CarrierModel::flags(const QModelIndex& index) const {
    return index.isValid() ? QAbstractListModel::flags(index) | Qt::ItemIsDropEnabled : Qt::NoItemFlags;
}

bool CarrierModel::canDropMimeData(const QMimeData* data, Qt::DropAction, int, int,
                                   const QModelIndex& parent) const {
    return parent.isValid() && data->hasFormat(kYarnMime);
}

bool CarrierModel::dropMimeData(const QMimeData* data, Qt::DropAction, int, int, const QModelIndex& parent) {
    const int carrier = carrierAt(parent);
    const yarn::Yarn* yarn = m_document.library().find(data->data(kYarnMime).toStdString());
    if (carrier < 0 || !yarn) {
        return false;
    }
    m_document.assignYarn(carrier, *yarn);
    return true;
}

} // namespace knittsim::ui
