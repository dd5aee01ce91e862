#pragma once

#include "ui/document/session.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace knittsim::document {

/// A camera that a person has kept. The bytes are the view's own.
struct NamedView {
    QString name;
    QByteArray camera;
};

/// The views of one file, remembered between runs. Names are never empty and differ from each other; spaces
/// around them do not count.
class NamedViews {
public:
    explicit NamedViews(Session& session) : m_session(session) {}

    /// `path` of the file, else its title. Empty: no file, no views.
    void setFile(const QString& path);

    const std::vector<NamedView>& views() const { return m_views; }
    const NamedView* find(const QString& name) const;

    bool save(const QString& name, const QByteArray& camera); ///< replaces one of that name; false: no name
    bool rename(const QString& name, const QString& next);    ///< false where that is empty or taken
    void remove(const QString& name);

private:
    void write();

    Session& m_session;
    QString m_key;
    std::vector<NamedView> m_views;
};

} // namespace knittsim::document
