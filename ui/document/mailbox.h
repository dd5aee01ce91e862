#pragma once

#include <QMetaObject>
#include <QObject>

#include <functional>
#include <mutex>
#include <utility>

namespace knittsim::document {

/// Brings results of background work to an object's thread. Work holds it by shared_ptr and may outlive the
/// object: what is posted after close() is dropped.
class Mailbox {
public:
    explicit Mailbox(QObject* receiver) : m_receiver(receiver) {}

    /// Any thread. `action` runs later on the receiver's thread.
    void post(std::function<void()> action) {
        const std::lock_guard lock(m_mutex);
        if (m_receiver) {
            QMetaObject::invokeMethod(m_receiver, std::move(action), Qt::QueuedConnection);
        }
    }

    /// Call in the receiver's destructor.
    void close() {
        const std::lock_guard lock(m_mutex);
        m_receiver = nullptr;
    }

private:
    std::mutex m_mutex;
    QObject* m_receiver;
};

} // namespace knittsim::document
