#pragma once

#include <QByteArray>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

namespace knittsim::document {

/// Tells when somebody else writes the file that is open. What counts is its content: a touch, a copy of the
/// same and what was taken as known are not told.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(QObject* parent = nullptr);

    /// The file as it is now; an empty path ends it.
    void watch(const QString& path);
    QString path() const { return m_path; }
    bool hasChanged() const { return m_changed; } ///< since watch()

signals:
    void changed();

private:
    void look();
    QByteArray fingerprint() const; ///< empty while there is no file

    QFileSystemWatcher m_watcher;
    QTimer m_timer; ///< writers need a moment, and replace rather than write
    QString m_path;
    QByteArray m_known;
    bool m_changed = false;
};

} // namespace knittsim::document
