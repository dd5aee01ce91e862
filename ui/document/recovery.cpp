#include "ui/document/recovery.h"

#include "core/base/file.h"
#include "ui/document/document.h"
#include "ui/document/session.h"

#include <QDir>
#include <QFileInfo>
#include <QLockFile>
#include <QUrl>
#include <QUuid>

namespace knittsim::document {

namespace {

const QString kPattern = QStringLiteral("*.knitt");

/// "ID_TITLE.knitt": the title stands in the name, percent-encoded.
QString fileName(const QString& id, const QString& title) {
    return id + u'_' + QString::fromLatin1(QUrl::toPercentEncoding(title.left(20))) +
           QString::fromUtf8(pattern::kProjectExtension.data());
}

QString lockOf(const QString& id) {
    return Recovery::folder() + u'/' + id + QStringLiteral(".lock");
}

QString idOf(const QString& name) {
    return name.section(u'_', 0, 0);
}

} // namespace

QString Recovery::folder() {
    return QFileInfo(Session::filePath()).absolutePath() + QStringLiteral("/recovery");
}

Recovery::Recovery(Document& document)
    : QObject(&document), m_document(document), m_id(QUuid::createUuid().toString(QUuid::Id128)) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(kDelayMs);
    connect(&m_timer, &QTimer::timeout, this, &Recovery::write);
    connect(&m_document, &Document::chartChanged, this, &Recovery::takeChange);
    connect(&m_document, &Document::saved, this, &Recovery::takeChange);
    connect(m_document.undoStack(), &QUndoStack::cleanChanged, this, &Recovery::takeChange);
}

/// Left in peace: the person was asked.
Recovery::~Recovery() {
    remove();
}

void Recovery::takeChange() {
    if (!m_document.isModified()) {
        m_timer.stop();
        remove();
    } else if (!m_timer.isActive()) {
        m_timer.start();
    }
}

void Recovery::write() {
    if (!m_document.isModified() || !QDir().mkpath(folder())) {
        return;
    }
    if (!m_lock) {
        m_lock = std::make_unique<QLockFile>(lockOf(m_id));
        m_lock->setStaleLockTime(0); // held as long as the program lives
        m_lock->tryLock(0);
    }
    const QString path = folder() + u'/' + fileName(m_id, m_document.title());
    const auto written = writeFileAtomically(std::filesystem::path(path.toStdString()),
                                             pattern::writeProject(*m_document.project()));
    if (!written) {
        return; // the copy of before is better than none
    }
    if (!m_path.isEmpty() && m_path != path) {
        QFile::remove(m_path);
    }
    m_path = path;
}

void Recovery::remove() {
    if (!m_path.isEmpty()) {
        QFile::remove(m_path);
        m_path.clear();
    }
    m_lock.reset();
}

std::vector<Recovery::Leftover> Recovery::leftovers() {
    std::vector<Leftover> found;
    const QDir dir(folder());
    for (const QFileInfo& file : dir.entryInfoList({kPattern}, QDir::Files, QDir::Time)) {
        QLockFile lock(lockOf(idOf(file.fileName())));
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0)) {
            continue; // another window works on it
        }
        const QString title = file.completeBaseName().section(u'_', 1);
        found.push_back(
            {file.absoluteFilePath(), QUrl::fromPercentEncoding(title.toLatin1()), file.lastModified()});
    }
    return found;
}

void Recovery::discard(const Leftover& leftover) {
    QFile::remove(leftover.path);
    QFile::remove(lockOf(idOf(QFileInfo(leftover.path).fileName())));
}

} // namespace knittsim::document
