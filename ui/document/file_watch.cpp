#include "ui/document/file_watch.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

namespace knittsim::document {

namespace {

constexpr int kQuietMs = 300;

} // namespace

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(kQuietMs);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, &m_timer, qOverload<>(&QTimer::start));
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_timer, [this] {
        if (!m_timer.isActive()) { // a busy folder must not put the look off for ever
            m_timer.start();
        }
    });
    connect(&m_timer, &QTimer::timeout, this, &FileWatch::look);
}

void FileWatch::watch(const QString& path) {
    if (!m_watcher.files().isEmpty()) {
        m_watcher.removePaths(m_watcher.files());
    }
    if (!m_watcher.directories().isEmpty()) {
        m_watcher.removePaths(m_watcher.directories());
    }
    m_path = path;
    m_known = fingerprint();
    m_changed = false;
    if (!m_path.isEmpty()) {
        m_watcher.addPath(m_path);
        // A file that is replaced is a new one to the system; its folder tells when it comes.
        m_watcher.addPath(QFileInfo(m_path).absolutePath());
    }
}

QByteArray FileWatch::fingerprint() const {
    QFile file(m_path);
    QCryptographicHash hash(QCryptographicHash::Sha1);
    return !m_path.isEmpty() && file.open(QIODevice::ReadOnly) && hash.addData(&file) ? hash.result()
                                                                                      : QByteArray();
}

void FileWatch::look() {
    const QByteArray now = fingerprint();
    if (now.isEmpty()) {
        return; // away for now; the folder tells when it is back
    }
    m_watcher.addPath(m_path);
    if (now != m_known) {
        m_known = now;
        m_changed = true;
        emit changed();
    }
}

} // namespace knittsim::document
