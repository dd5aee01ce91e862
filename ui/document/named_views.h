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

    /// Empty: of what is not in a file, for which no views are remembered; moveTo() does.
    void setFile(const QString& path);
    /// The same views, of what was saved there. Another file that they come from keeps its own.
    void moveTo(const QString& path);

    const std::vector<NamedView>& views() const { return m_views; }
    const NamedView* find(const QString& name) const;

    bool save(const QString& name, const QByteArray& camera); ///< replaces one of that name; false: no name
    bool rename(const QString& name, const QString& next);    ///< false where that is empty or taken
    void remove(const QString& name);

private:
    void write();

    Session& m_session;
    QString m_key;       ///< empty: not remembered
    bool m_open = false; ///< there was a setFile(); before it nothing is saved
    std::vector<NamedView> m_views;
};

} // namespace knittsim::document
