#include "ui/document/named_views.h"

#include <QDataStream>
#include <QIODevice>

#include <algorithm>

namespace knittsim::document {

namespace {

constexpr quint32 kMagic = 0x4b535631; // "KSV1"

QByteArray toBytes(const std::vector<NamedView>& views) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_6_0);
    stream << kMagic << static_cast<quint32>(views.size());
    for (const NamedView& view : views) {
        stream << view.name << view.camera;
    }
    return bytes;
}

/// None for bytes that toBytes() did not make.
std::vector<NamedView> fromBytes(const QByteArray& bytes) {
    QDataStream stream(bytes);
    stream.setVersion(QDataStream::Qt_6_0);
    quint32 magic = 0;
    quint32 count = 0;
    stream >> magic >> count;
    std::vector<NamedView> views;
    for (quint32 i = 0; magic == kMagic && i < count; ++i) {
        NamedView view;
        stream >> view.name >> view.camera;
        if (stream.status() != QDataStream::Ok) {
            return {};
        }
        views.push_back(std::move(view));
    }
    return views;
}

const QString kGroup = QStringLiteral("views");

} // namespace

void NamedViews::setFile(const QString& path) {
    m_open = true;
    m_key = Session::keyOf(kGroup, path);
    m_views = m_key.isEmpty() ? std::vector<NamedView>() : fromBytes(m_session.value(m_key));
}

void NamedViews::moveTo(const QString& path) {
    const QString key = Session::keyOf(kGroup, path);
    if (key != m_key) {
        m_key = key;
        write();
    }
}

const NamedView* NamedViews::find(const QString& name) const {
    const auto found = std::ranges::find(m_views, name.trimmed(), &NamedView::name);
    return found == m_views.end() ? nullptr : &*found;
}

bool NamedViews::save(const QString& name, const QByteArray& camera) {
    const QString wanted = name.trimmed();
    if (wanted.isEmpty() || !m_open) {
        return false;
    }
    const auto found = std::ranges::find(m_views, wanted, &NamedView::name);
    if (found != m_views.end()) {
        found->camera = camera;
    } else {
        m_views.push_back({wanted, camera});
    }
    write();
    return true;
}

bool NamedViews::rename(const QString& name, const QString& next) {
    const QString wanted = next.trimmed();
    const auto found = std::ranges::find(m_views, name, &NamedView::name);
    if (found == m_views.end() || wanted.isEmpty() || (wanted != name && find(wanted))) {
        return false;
    }
    found->name = wanted;
    write();
    return true;
}

void NamedViews::remove(const QString& name) {
    std::erase_if(m_views, [&](const NamedView& view) { return view.name == name; });
    write();
}

void NamedViews::write() {
    if (!m_key.isEmpty()) {
        m_session.setValue(m_key, toBytes(m_views));
    }
}

} // namespace knittsim::document
