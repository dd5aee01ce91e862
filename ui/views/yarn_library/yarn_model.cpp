#include "ui/views/yarn_library/yarn_model.h"

#include <QColor>
#include <QMimeData>

#include <algorithm>

namespace knittsim::ui {

QColor colourOf(const yarn::Yarn& yarn) {
    return {yarn.colour.r, yarn.colour.g, yarn.colour.b};
}

YarnModel::YarnModel(const yarn::YarnLibrary& library, QObject* parent)
    : QAbstractListModel(parent), m_library(library) {
    setSearch({});
}

void YarnModel::setSearch(const QString& text) {
    beginResetModel();
    m_found.clear();
    const QStringList words = text.split(u' ', Qt::SkipEmptyParts);
    for (const yarn::Yarn& yarn : m_library.yarns()) {
        const QString all =
            QString::fromStdString(yarn.name + ' ' + yarn.id + ' ' + yarn.fibre + ' ' + yarn.count);
        if (std::all_of(words.begin(), words.end(),
                        [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); })) {
            m_found.push_back(&yarn);
        }
    }
    endResetModel();
}

const yarn::Yarn* YarnModel::yarnAt(const QModelIndex& index) const {
    return index.isValid() ? m_found[static_cast<std::size_t>(index.row())] : nullptr;
}

int YarnModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_found.size());
}

QVariant YarnModel::data(const QModelIndex& index, int role) const {
    const yarn::Yarn* yarn = yarnAt(index);
    if (!yarn) {
        return {};
    }
    switch (role) {
    case Qt::DisplayRole:
    case TitleRole:
        return QString::fromStdString(yarn->name);
    case DetailRole:
        return QString::fromStdString(yarn->count + " \u00b7 " + yarn->fibre);
    case ColourRole:
        return colourOf(*yarn);
    case PliesRole:
        return yarn->surface.plies;
    case IdRole:
        return QString::fromStdString(yarn->id);
    case Qt::ToolTipRole:
        return tr("%1: drag it onto a carrier, or double click to put it on the selected carrier")
            .arg(QString::fromStdString(yarn->name));
    default:
        return {};
    }
}

Qt::ItemFlags YarnModel::flags(const QModelIndex& index) const {
    return QAbstractListModel::flags(index) | Qt::ItemIsDragEnabled;
}

QMimeData* YarnModel::mimeData(const QModelIndexList& indexes) const {
    auto* data = new QMimeData;
    if (!indexes.isEmpty()) {
        data->setData(kYarnMime, indexes.front().data(IdRole).toString().toUtf8());
    }
    return data;
}

} // namespace knittsim::ui
