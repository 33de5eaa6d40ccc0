// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/sceneghosts.h"

#include "editor/jobs/jobrunner.h"

#include <QLocale>
#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

constexpr std::int64_t maximalGhosts = 24;
constexpr int ghostAlpha = 70;
constexpr int pinnedAlpha = 120;

} // namespace

SceneGhosts::SceneGhosts(widgets::Viewport& viewport, JobRunner& jobs, ColorOf colorOf, QObject* parent)
    : QObject(parent), m_viewport(viewport), m_jobs(jobs), m_colorOf(std::move(colorOf))
{
}

void SceneGhosts::show(const QString& clip, int figure, const MeshSequence& sequence)
{
    Shown& shown = m_shown[clip];
    shown.figure = figure;
    shown.sequence = sequence;
    update(clip);
}

void SceneGhosts::remove(const QString& clip)
{
    m_shown.erase(clip);
}

void SceneGhosts::rename(const QString& before, const QString& after)
{
    if (auto node = m_shown.extract(before)) {
        node.key() = after;
        m_shown.insert(std::move(node));
    }
    if (auto node = m_pinned.extract(before)) {
        node.key() = after;
        m_pinned.insert(std::move(node));
    }
}

void SceneGhosts::setInterval(int interval)
{
    if (std::exchange(m_interval, interval) != interval)
        updateAll();
}

void SceneGhosts::setPinned(const QString& clip, FrameIndex frame, bool pinned)
{
    if (pinned == isPinned(clip, frame))
        return;
    if (pinned)
        m_pinned[clip].insert(frame.value);
    else if (m_pinned[clip].erase(frame.value); m_pinned[clip].empty())
        m_pinned.erase(clip);
    update(clip);
    emit pinnedChanged();
}

bool SceneGhosts::isPinned(const QString& clip, FrameIndex frame) const
{
    const auto found = m_pinned.find(clip);
    return found != m_pinned.end() && found->second.contains(frame.value);
}

void SceneGhosts::unpinAll()
{
    if (m_pinned.empty())
        return;
    m_pinned.clear();
    updateAll();
    emit pinnedChanged();
}

void SceneGhosts::updateAll()
{
    for (const auto& [clip, shown] : m_shown)
        update(clip);
}

std::vector<SceneGhosts::Wish> SceneGhosts::wishes(const QString& clip, const Shown& shown) const
{
    std::vector<Wish> wishes;
    const std::int64_t count = shown.sequence.frameCount();
    if (const auto pinned = m_pinned.find(clip); pinned != m_pinned.end()) {
        for (const std::int64_t frame : pinned->second) {
            if (frame < count)
                wishes.push_back({frame, true});
        }
    }
    if (m_interval <= 0)
        return wishes;
    const std::int64_t interval = std::max<std::int64_t>(m_interval, count / maximalGhosts);
    for (std::int64_t frame = 0; frame < count; frame += interval) {
        if (!isPinned(clip, FrameIndex(frame)))
            wishes.push_back({frame, false});
    }
    return wishes;
}

void SceneGhosts::update(const QString& clip)
{
    const auto found = m_shown.find(clip);
    if (found == m_shown.end())
        return;
    Shown& shown = found->second;
    const int run = ++shown.run;
    std::vector<Wish> wanted = wishes(clip, shown);
    if (wanted.empty()) {
        m_viewport.setGhosts(shown.figure, {});
        return;
    }
    std::vector<widgets::Ghost> ghosts;
    for (const Wish& wish : wanted) {
        QColor color = m_colorOf(clip, wish.frame);
        color.setAlpha(wish.isPinned ? pinnedAlpha : ghostAlpha);
        ghosts.push_back({.positions = {},
                          .color = color,
                          .label = wish.isPinned ? QLocale().toString(wish.frame) : QString()});
    }
    m_jobs.start(
        {.name = tr("Ghosts of “%1”").arg(clip),
         .receiver = this,
         .failed = [](const Error&) { /* told when the frame is shown */ },
         .background = true},
        [sequence = shown.sequence, wanted, ghosts = std::move(ghosts)](const Progress& progress) mutable {
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                progress.report(static_cast<std::int64_t>(i), static_cast<std::int64_t>(wanted.size()));
                const Frame frame = sequence.frame(FrameIndex(wanted[i].frame));
                const auto* first = reinterpret_cast<const float*>(frame.positions().data());
                ghosts[i].positions.assign(first, first + 3 * frame.positions().size());
            }
            return std::move(ghosts);
        },
        [this, figure = shown.figure, run](const std::vector<widgets::Ghost>& made) {
            const auto current = std::ranges::find_if(m_shown, [&](const auto& each) {
                return each.second.figure == figure && each.second.run == run;
            });
            if (current != m_shown.end())
                m_viewport.setGhosts(figure, made);
        });
}

} // namespace quadrille

#include "moc_sceneghosts.cpp"
