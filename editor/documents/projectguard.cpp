// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/projectguard.h"

#include "model/core/contenthash.h"
#include "model/core/error.h"
#include "model/core/filestamp.h"

#include <QDateTime>
#include <QLocale>
#include <mutex>
#include <optional>

namespace quadrille {

namespace {

constexpr int lookMilliseconds = 2000;
constexpr int looksBetweenSigns = 15;

QDateTime toDateTime(std::chrono::system_clock::time_point time)
{
    using std::chrono::milliseconds;
    return QDateTime::fromMSecsSinceEpoch(
        std::chrono::duration_cast<milliseconds>(time.time_since_epoch()).count());
}

/// Today's times without their day.
QString inWords(const QDateTime& time)
{
    return time.date() == QDate::currentDate() ? QLocale().toString(time.time(), QLocale::ShortFormat)
                                               : QLocale().toString(time, QLocale::ShortFormat);
}

/// Empty where there is no file, or it cannot be read now.
std::string contentOf(const std::filesystem::path& file)
{
    try {
        return hashFile(file);
    } catch (const Error&) {
        return {};
    }
}

} // namespace

/// What the looking thread and the interface both ask.
struct ProjectGuard::Shared
{
    std::mutex mutex;
    std::filesystem::path file;
    std::shared_ptr<ProjectLock> lock;
    std::optional<FileStamp> stamp; ///< of the content that is known
    std::string content;
    std::optional<FileStamp> lastStamp; ///< as it was when it was looked at last
    std::string told;                   ///< content that was told of
    int looks = 0;

    void note()
    {
        stamp = lastStamp = stampOf(file);
        content = contentOf(file);
        told.clear();
    }

    /// Whether the file has another content than is known. \param settled  only if it is not being written.
    bool isChanged(bool settled)
    {
        const auto now = stampOf(file);
        const bool isStill = now == std::exchange(lastStamp, now);
        if (!now || (stamp && now->hasContentOf(*stamp)) || (settled && !isStill))
            return false;
        const std::string other = contentOf(file);
        if (other == content)
            stamp = now; // written again as it was
        if (other.empty() || other == content || (settled && other == told))
            return false;
        if (settled)
            told = other;
        return true;
    }
};

struct ProjectGuard::Seen
{
    std::shared_ptr<Shared> of;
    ProjectLock::State state = ProjectLock::State::None;
    QString holder;
    bool isChanged = false;
};

ProjectGuard::ProjectGuard(QObject* parent) : QObject(parent)
{
    m_looker.setMaxThreadCount(1);
    m_timer.setInterval(lookMilliseconds);
    connect(&m_timer, &QTimer::timeout, this, &ProjectGuard::poll);
}

ProjectGuard::~ProjectGuard()
{
    m_looker.waitForDone();
}

std::shared_ptr<ProjectLock> ProjectGuard::lockOf(const std::filesystem::path& file)
{
    return std::make_shared<ProjectLock>(file, "quadrille-editor");
}

void ProjectGuard::watch(const std::filesystem::path& file, std::shared_ptr<ProjectLock> lock)
{
    m_file = file;
    m_lock = std::move(lock);
    m_shared = std::make_shared<Shared>();
    m_shared->file = file;
    m_shared->lock = m_lock;
    m_shared->note();
    m_wantsReadOnly = m_lock->state() == ProjectLock::State::Foreign;
    setAccess(m_lock->state(), m_lock->holder() ? describe(*m_lock->holder()) : QString());
    m_timer.start();
}

void ProjectGuard::release()
{
    m_timer.stop();
    m_file.clear();
    m_lock.reset();
    m_shared.reset();
    m_wantsReadOnly = false;
    setAccess(ProjectLock::State::None, {});
}

void ProjectGuard::setAccess(ProjectLock::State state, const QString& holder)
{
    Access access = Access::Full;
    if (m_wantsReadOnly)
        access = Access::ReadOnly;
    else if (state == ProjectLock::State::Foreign)
        access = Access::TakenOver;
    else if (state == ProjectLock::State::ReadOnly)
        access = Access::NotWritable;
    const bool isOther = access != m_access || holder != m_holder;
    m_access = access;
    m_holder = holder;
    if (isOther)
        emit accessChanged();
}

void ProjectGuard::lookNow()
{
    if (!m_shared)
        return;
    const std::scoped_lock guard(m_shared->mutex);
    const auto state = m_lock->look();
    setAccess(state, m_lock->holder() ? describe(*m_lock->holder()) : QString());
}

void ProjectGuard::takeOver()
{
    if (!m_shared)
        return;
    const std::scoped_lock guard(m_shared->mutex);
    m_lock->takeOver();
    m_wantsReadOnly = false;
    setAccess(m_lock->state(), {});
}

bool ProjectGuard::isChanged()
{
    if (!m_shared)
        return false;
    const std::scoped_lock guard(m_shared->mutex);
    return m_shared->isChanged(false);
}

void ProjectGuard::noteContent()
{
    if (!m_shared)
        return;
    const std::scoped_lock guard(m_shared->mutex);
    m_shared->note();
}

void ProjectGuard::poll()
{
    if (std::exchange(m_isLooking, true))
        return;
    m_looker.start([this, shared = m_shared] {
        Seen seen;
        {
            const std::scoped_lock guard(shared->mutex);
            ProjectLock& lock = *shared->lock;
            seen.of = shared;
            seen.state = lock.look();
            if (lock.holder())
                seen.holder = describe(*lock.holder());
            if (shared->looks++ % looksBetweenSigns == 0)
                lock.keepAlive();
            seen.isChanged = shared->isChanged(true);
        }
        QMetaObject::invokeMethod(
            this, [this, seen] { take(seen); }, Qt::QueuedConnection);
    });
}

void ProjectGuard::take(const Seen& seen)
{
    m_isLooking = false;
    if (seen.of != m_shared)
        return;
    setAccess(seen.state, seen.holder);
    if (seen.isChanged)
        emit changed();
}

QString describe(const LockHolder& holder)
{
    const QString user = QString::fromStdString(holder.user);
    const QString host = QString::fromStdString(holder.host);
    const QString since = inWords(toDateTime(holder.since));
    if (user.isEmpty() || host.isEmpty())
        return ProjectGuard::tr("somebody, since %1").arg(since);
    constexpr std::chrono::minutes silence(5);
    if (std::chrono::system_clock::now() - holder.seen > silence)
        return ProjectGuard::tr("%1 on %2, not heard of since %3")
            .arg(user, host, inWords(toDateTime(holder.seen)));
    return ProjectGuard::tr("%1 on %2, since %3").arg(user, host, since);
}

} // namespace quadrille

#include "moc_projectguard.cpp"
