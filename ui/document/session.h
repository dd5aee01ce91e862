#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>
#include <QStringList>

namespace knittsim::document {

enum class Appearance { System, Light, Dark };

/// What is remembered between runs: an INI file in $KNITTSIM_CONFIG_DIR, else in the user's configuration
/// folder.
class Session {
public:
    static constexpr int kMaxRecentFiles = 10;

    Session();

    static QString filePath();

    /// Key in the group of what is remembered with a file; empty for an empty path.
    static QString keyOf(const QString& group, const QString& path);

    QStringList recentFiles() const;
    void addRecentFile(const QString& path); ///< to the front; once only
    void removeRecentFile(const QString& path);
    void clearRecentFiles();

    QString lastFolder() const;
    void setLastFolder(const QString& folder);

    Appearance appearance() const;
    void setAppearance(Appearance appearance);

    QString language() const; ///< id as of ui/views/style/language.h; empty: the system's
    void setLanguage(const QString& id);

    QByteArray value(const QString& key) const;
    void setValue(const QString& key, const QByteArray& bytes);

    /// Forgets everything.
    void clear();

private:
    QSettings m_settings;
};

} // namespace knittsim::document
