// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/mediawatch.h"

#include "model/project/media/media.h"

#include <QElapsedTimer>
#include <algorithm>

namespace quadrille {

namespace {

constexpr int pollMilliseconds = 3000;
/// While something changes.
constexpr int settlingMilliseconds = 700;
/// A look takes at most this part of the time.
constexpr int rarity = 20;

std::map<std::string, FileStamp> stampsOf(const Project& project)
{
    std::map<std::string, FileStamp> stamps;
    std::set<std::filesystem::path> seen;
    for (const MediaUse& use : mediaOf(project, {})) {
        if (!seen.insert(use.file).second)
            continue;
        for (const auto& file : filesOfMedium(use.file)) {
            if (const auto stamp = stampOf(file))
                stamps.try_emplace(file.string(), *stamp);
        }
    }
    return stamps;
}

} // namespace

MediaWatch::MediaWatch(ProjectDocument& document, QObject* parent)
    : QObject(parent), m_document(document), m_interval(pollMilliseconds)
{
    m_looker.setMaxThreadCount(1);
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &MediaWatch::look);
    connect(&document, &ProjectDocument::changed, this, &MediaWatch::follow);
    m_timer.start(m_interval);
}

MediaWatch::~MediaWatch()
{
    m_looker.waitForDone();
}

QStringList MediaWatch::changedFiles() const
{
    QStringList files;
    for (const std::string& file : m_changed)
        files += QString::fromStdString(file);
    return files;
}

bool MediaWatch::isWatching() const
{
    return m_isWatching;
}

void MediaWatch::setInterval(int milliseconds)
{
    m_interval = milliseconds;
    m_timer.start(m_interval);
}

void MediaWatch::follow(const ChangeEvent& event)
{
    const bool isOther = event.kind == ChangeEvent::Kind::Reset;
    if (!isOther && event.kind != ChangeEvent::Kind::List)
        return;
    ++m_generation;
    m_isWatching = false;
    if (isOther) {
        m_known.clear();
        m_last.clear();
        m_found.clear();
        if (!m_changed.empty()) {
            m_changed.clear();
            emit changed();
        }
    }
    look(); // media are being opened now: what is written later differs from what is there
}

void MediaWatch::look()
{
    m_timer.stop();
    if (m_isLooking)
        return; // take() looks again
    m_isLooking = true;
    m_looker.start([this, project = m_document.project(), generation = m_generation] {
        QElapsedTimer time;
        time.start();
        Stamps now = stampsOf(project);
        QMetaObject::invokeMethod(
            this,
            [this, now = std::move(now), generation, milliseconds = time.elapsed()] {
                m_isLooking = false;
                if (generation == m_generation)
                    take(now, milliseconds);
                else
                    look();
            },
            Qt::QueuedConnection);
    });
}

void MediaWatch::take(const Stamps& now, qint64 milliseconds)
{
    m_isWatching = true;
    bool isSettling = false;
    for (const auto& [file, stamp] : now) {
        const auto [known, isNew] = m_known.try_emplace(file, stamp);
        if (isNew || stamp.hasContentOf(known->second))
            continue;
        const auto last = m_last.find(file);
        isSettling = isSettling || last == m_last.end() || last->second != stamp;
        m_found.insert(file);
    }
    m_last = now;
    const auto pause = std::max<qint64>(m_interval, milliseconds * rarity);
    m_timer.start(static_cast<int>(isSettling ? std::min<qint64>(pause, settlingMilliseconds) : pause));
    // All at once, when the last of them is done.
    if (isSettling || m_found == m_changed)
        return;
    m_changed = m_found;
    emit changed();
}

} // namespace quadrille

#include "moc_mediawatch.cpp"
