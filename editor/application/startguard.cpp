// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/startguard.h"

#include <QDir>
#include <QEvent>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QTimer>
#include <QUuid>
#include <QWidget>
#include <QWindow>
#include <utility>

namespace quadrille {

namespace {

const QString prefix = QStringLiteral("starting-");
/// A window that is shown still gets its final size, and docks theirs, in this time.
constexpr int settlingMilliseconds = 1000;

/// Locks lie beside markers, and so do locks of locks while a stale one is removed: what was killed just then
/// leaves one behind.
bool isMarker(const QString& name)
{
    return !name.contains(QLatin1Char('.'));
}

std::unique_ptr<QLockFile> lockOf(const QString& marker)
{
    auto lock = std::make_unique<QLockFile>(marker + QStringLiteral(".lock"));
    lock->setStaleLockTime(0); // only the end of a program frees its lock
    return lock;
}

} // namespace

StartGuard::StartGuard(const QString& folder, QObject* parent) : QObject(parent)
{
    const QDir dir(folder);
    dir.mkpath(QStringLiteral("."));
    for (const QString& name : dir.entryList({prefix + QLatin1Char('*')}, QDir::Files)) {
        const QString marker = dir.filePath(name);
        if (isMarker(name) && lockOf(marker)->tryLock(0))
            m_failed += marker;
    }
    m_marker = dir.filePath(prefix + QUuid::createUuid().toString(QUuid::WithoutBraces));
    m_lock = lockOf(m_marker);
    m_lock->tryLock(0);
    QFile file(m_marker);
    if (!file.open(QIODevice::WriteOnly))
        m_marker.clear();
}

StartGuard::~StartGuard()
{
    succeed();
}

void StartGuard::watch(QWidget& window)
{
    window.windowHandle()->installEventFilter(this);
    followExposure(*window.windowHandle());
}

bool StartGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (auto* window = qobject_cast<QWindow*>(watched); window != nullptr && event->type() == QEvent::Expose)
        followExposure(*window);
    return false;
}

void StartGuard::followExposure(const QWindow& window)
{
    if (!window.isExposed() || std::exchange(m_isExposed, true))
        return;
    // Timers have their turn when everything else is done: also a long first second is waited for.
    QTimer::singleShot(settlingMilliseconds, this,
                       [this] { QTimer::singleShot(0, this, &StartGuard::succeed); });
}

void StartGuard::succeed()
{
    if (m_marker.isEmpty())
        return;
    QFile::remove(m_marker);
    m_marker.clear();
    for (const QString& marker : std::as_const(m_failed))
        QFile::remove(marker);
    m_failed.clear();
    m_lock->unlock();
    emit succeeded();
}

QString settingsFolder()
{
    return QFileInfo(QSettings().fileName()).absolutePath();
}

} // namespace quadrille

#include "moc_startguard.cpp"
