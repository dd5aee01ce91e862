#pragma once

#include "core/yarn/yarn_library.h"

#include <QAbstractListModel>
#include <QString>

#include <memory>

namespace knittsim::ui {

/// MIME type of a dragged yarn; its bytes are the yarn's id.
inline const QString kYarnMime = QStringLiteral("application/x-knittsim-yarn");

/// Roles that the lists of yarns and of carriers share.
enum YarnRole {
    TitleRole = Qt::UserRole + 1, ///< first line
    DetailRole,                   ///< second line
    ColourRole,                   ///< QColor
    PliesRole,                    ///< int
    BadgeRole,                    ///< short text in front, may be empty
    IdRole,                       ///< id in the library
};

QColor colourOf(const yarn::Yarn& yarn);

/// The yarns of a library that match a search text (name, id, fibre, count) and a filter.
class YarnModel : public QAbstractListModel {
    Q_OBJECT

public:
    explicit YarnModel(std::shared_ptr<const yarn::YarnLibrary> library, QObject* parent = nullptr);

    void setLibrary(std::shared_ptr<const yarn::YarnLibrary> library);
    void setSearch(const QString& text);
    /// Kinds of fibre in the library: the first word of each, in order of the alphabet.
    QStringList fibres() const;
    /// One of fibres(); empty: all.
    void setFibre(const QString& fibre);
    /// Only the person's own yarns.
    void setOnlyOwn(bool on);
    /// Invalid where it is not shown.
    QModelIndex indexOf(const std::string& id) const;
    const yarn::Yarn* yarnAt(const QModelIndex& index) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QStringList mimeTypes() const override { return {kYarnMime}; }
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    Qt::DropActions supportedDragActions() const override { return Qt::CopyAction; }

private:
    void find();

    std::shared_ptr<const yarn::YarnLibrary> m_library;
    QString m_search;
    QString m_fibre;
    bool m_onlyOwn = false;
    std::vector<const yarn::Yarn*> m_found;
};

} // namespace knittsim::ui
