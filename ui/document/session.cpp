#include "ui/document/session.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace knittsim::document {

namespace {

const QString kRecent = QStringLiteral("session/recentFiles");
const QString kFolder = QStringLiteral("session/lastFolder");
const QString kLanguage = QStringLiteral("preferences/language");
const QString kAppearance = QStringLiteral("preferences/appearance");

} // namespace

QString Session::filePath() {
    const QString folder = qEnvironmentVariable("KNITTSIM_CONFIG_DIR");
    const QString base = folder.isEmpty()
                             ? QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
                                   QStringLiteral("/knittsim")
                             : folder;
    return QDir(base).filePath(QStringLiteral("knittsim.ini"));
}

QString Session::keyOf(const QString& group, const QString& path) {
    if (path.isEmpty()) {
        return {};
    }
    const QByteArray name = QFileInfo(path).absoluteFilePath().toUtf8();
    const QByteArray hash = QCryptographicHash::hash(name, QCryptographicHash::Sha1);
    return group + u'/' + QString::fromLatin1(hash.toHex());
}

Session::Session() : m_settings(filePath(), QSettings::IniFormat) {
    m_settings.setValue(QStringLiteral("version"), 1);
}

QStringList Session::recentFiles() const {
    return m_settings.value(kRecent).toStringList();
}

void Session::addRecentFile(const QString& path) {
    QStringList files = recentFiles();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    files.removeAll(absolute);
    files.prepend(absolute);
    m_settings.setValue(kRecent, QStringList(files.mid(0, kMaxRecentFiles)));
}

void Session::removeRecentFile(const QString& path) {
    QStringList files = recentFiles();
    files.removeAll(path);
    m_settings.setValue(kRecent, files);
}

void Session::clearRecentFiles() {
    m_settings.remove(kRecent);
}

QString Session::lastFolder() const {
    return m_settings.value(kFolder, QDir::homePath()).toString();
}

void Session::setLastFolder(const QString& folder) {
    m_settings.setValue(kFolder, folder);
}

Appearance Session::appearance() const {
    const int stored = m_settings.value(kAppearance, 0).toInt();
    return stored == 1 ? Appearance::Light : stored == 2 ? Appearance::Dark : Appearance::System;
}

void Session::setAppearance(Appearance appearance) {
    m_settings.setValue(kAppearance, static_cast<int>(appearance));
}

QString Session::language() const {
    return m_settings.value(kLanguage).toString();
}

void Session::setLanguage(const QString& id) {
    m_settings.setValue(kLanguage, id);
}

QByteArray Session::value(const QString& key) const {
    return m_settings.value(key).toByteArray();
}

void Session::setValue(const QString& key, const QByteArray& bytes) {
    m_settings.setValue(key, bytes);
}

void Session::clear() {
    m_settings.clear();
}

} // namespace knittsim::document
