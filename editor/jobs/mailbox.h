// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <mutex>

namespace quadrille {

/// Takes what comes before the end of a job from its thread to an object of the interface, for as long as
/// that lives. The object holds it; jobs get addresses.
class Mailbox
{
public:
    /// Where an object's messages go; copies mean the same.
    class Address
    {
    public:
        /// Has `take` called on the interface thread, unless the object has gone by then. From any thread.
        void post(std::function<void()> take) const
        {
            const std::scoped_lock lock(m_box->mutex);
            if (m_box->owner != nullptr)
                QMetaObject::invokeMethod(m_box->owner, std::move(take), Qt::QueuedConnection);
        }

    private:
        friend class Mailbox;
        struct Box
        {
            std::mutex mutex;
            QObject* owner = nullptr;
        };
        std::shared_ptr<Box> m_box = std::make_shared<Box>();
    };

    explicit Mailbox(QObject* owner) { m_address.m_box->owner = owner; }
    ~Mailbox()
    {
        const std::scoped_lock lock(m_address.m_box->mutex);
        m_address.m_box->owner = nullptr;
    }
    Mailbox(const Mailbox&) = delete;
    Mailbox& operator=(const Mailbox&) = delete;

    /// To be copied into a job; it may live longer than the mailbox.
    const Address& address() const { return m_address; }

private:
    Address m_address;
};

} // namespace quadrille
