// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// How a session follows a path.
#include "editor/workspaces/live/livesession.h"
#include "model/project/document/groundpoint.h"

#include <numbers>

namespace quadrille {

void LiveSession::followPath(const std::optional<PathConstraint>& path)
{
    if (!path) {
        leavePath();
        return;
    }
    auto follower =
        std::make_unique<LivePathFollower>(m_graph->graph, LiveSettings(m_player->settings()), *path);
    m_start = follower->start();
    const UpAxis up = m_graph->graph->up();
    m_entry.position = pointOfFile(Ground(up).at(m_start.root.shift / m_graph->metresPerUnit, 0), up);
    m_entry.heading = m_start.root.turn * 180 / std::numbers::pi;
    m_follower = std::move(follower);
    m_walked = {0};
    restart();
}

void LiveSession::leavePath()
{
    if (m_follower == nullptr)
        return;
    m_follower.reset();
    emit changed();
}

bool LiveSession::followOn()
{
    const auto tick = static_cast<std::size_t>(state().tick);
    if (m_followedTick != state().tick)
        m_follower->resume(state(), m_walked[tick]);
    m_walked.resize(tick);
    m_walked.push_back(m_follower->walked());
    const LiveInput input = m_follower->next(state());
    m_followedTick = state().tick + 1;
    if (m_follower->isDone())
        return false;
    const bool isOther = m_wanted != input.space || m_isResponsive != input.isResponsive;
    m_isResponsive = input.isResponsive;
    m_wanted = input.space;
    if (isOther)
        followSpace();
    m_steering.setValues(input.parameters);
    if (isOther)
        emit changed();
    return true;
}

} // namespace quadrille
