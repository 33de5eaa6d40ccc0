// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/autosave.h"

#include "editor/application/recoveries.h"
#include "editor/documents/projectpaths.h"

#include <QUuid>
#include <utility>

namespace quadrille {

Autosave::Autosave(ProjectDocument& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_id(QUuid::createUuid().toString(QUuid::WithoutBraces))
    , m_lock(recoveryLockFile(m_id))
{
    m_writer.setMaxThreadCount(1);
    m_lock.setStaleLockTime(0);
    m_lock.tryLock(0);
    m_timer.setSingleShot(true);
    connect(&document, &ProjectDocument::changed, this, &Autosave::follow);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::copyNow);
}

Autosave::~Autosave()
{
    removeCopy();
    m_writer.waitForDone();
}

void Autosave::setDelay(int seconds)
{
    m_delay = seconds * 500; // so that the copy is whole in time
    if (m_delay == 0)
        m_timer.stop();
    else if (m_isDirty)
        m_timer.start(m_delay);
}

void Autosave::follow()
{
    m_isDirty = m_document.isModified();
    if (!m_isDirty) {
        m_timer.stop();
        removeCopy();
    } else if (m_delay > 0 && !m_timer.isActive()) {
        m_timer.start(m_delay); // not anew by each edit: the first of them waits no longer
    }
}

void Autosave::copyNow()
{
    if (!std::exchange(m_isDirty, false))
        return;
    m_hasCopy = true;
    const QString file = m_document.isUntitled() ? QString() : toQString(m_document.file());
    m_writer.start([this, project = m_document.project(), file, adopted = std::exchange(m_adopted, {})] {
        write(project, file, adopted);
    });
}

/// On the writer's thread.
void Autosave::write(const Project& project, const QString& file, const QString& adopted)
{
    try {
        writeRecovery(project, m_id, file);
        discardRecovery(adopted);
    } catch (const Error& error) {
        QMetaObject::invokeMethod(
            this,
            [this, error, adopted] {
                m_adopted = adopted;
                emit failed(error);
            },
            Qt::QueuedConnection);
    }
}

void Autosave::adopt(const QString& recovery)
{
    m_adopted = recovery;
    copyNow();
}

void Autosave::removeCopy()
{
    if (!std::exchange(m_hasCopy, false) && m_adopted.isEmpty())
        return;
    m_writer.start([own = m_id, adopted = std::exchange(m_adopted, {})] {
        discardRecovery(own);
        discardRecovery(adopted);
    });
}

} // namespace quadrille

#include "moc_autosave.cpp"
