#include "ui/views/yarn_library/yarn_model.h"

#include "core/yarn/own_yarns.h"
#include "ui/document/document.h"

#include <QColor>
#include <QMimeData>
#include <QRegularExpression>

#include <algorithm>

namespace knittsim::ui {

QColor colourOf(const yarn::Yarn& yarn) {
    return {yarn.colour.r, yarn.colour.g, yarn.colour.b};
}

namespace {

QString kindOf(const yarn::Yarn& yarn) {
    static const QRegularExpression kNoLetter(QStringLiteral("[^\\p{L}-]"));
    return QString::fromStdString(yarn.fibre).section(kNoLetter, 0, 0).toLower();
}

bool isOwn(const yarn::Yarn& yarn) {
    return yarn::isOwn(document::Document::ownYarnFolder().toStdString(), yarn.id);
}

} // namespace

YarnModel::YarnModel(std::shared_ptr<const yarn::YarnLibrary> library, QObject* parent)
    : QAbstractListModel(parent), m_library(std::move(library)) {
    find();
}

void YarnModel::setLibrary(std::shared_ptr<const yarn::YarnLibrary> library) {
    beginResetModel();
    m_found.clear(); // they lie in the old one
    m_library = std::move(library);
    endResetModel();
    find();
}

void YarnModel::setSearch(const QString& text) {
    m_search = text;
    find();
}

void YarnModel::setFibre(const QString& fibre) {
    m_fibre = fibre;
    find();
}

void YarnModel::setOnlyOwn(bool on) {
    m_onlyOwn = on;
    find();
}

QStringList YarnModel::fibres() const {
    QStringList kinds;
    for (const yarn::Yarn& yarn : m_library->yarns()) {
        kinds << kindOf(yarn);
    }
    kinds.removeDuplicates();
    kinds.sort();
    return kinds;
}

QModelIndex YarnModel::indexOf(const std::string& id) const {
    const auto found = std::ranges::find(m_found, id, &yarn::Yarn::id);
    return found == m_found.end() ? QModelIndex() : index(static_cast<int>(found - m_found.begin()));
}

void YarnModel::find() {
    beginResetModel();
    m_found.clear();
    const QStringList words = m_search.split(u' ', Qt::SkipEmptyParts);
    for (const yarn::Yarn& yarn : m_library->yarns()) {
        const QString all =
            QString::fromStdString(yarn.name + ' ' + yarn.id + ' ' + yarn.fibre + ' ' + yarn.count);
        const bool matches = std::ranges::all_of(
            words, [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
        if (matches && (m_fibre.isEmpty() || kindOf(yarn) == m_fibre) && (!m_onlyOwn || isOwn(yarn))) {
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
