// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/transitionpreview.h"

#include "editor/jobs/jobrunner.h"
#include "model/synthesis/clips/makeclip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {

namespace {

constexpr double previewSeconds = 0.6; ///< that is shown before and behind a transition

} // namespace

TransitionPreview::Blended TransitionPreview::blend(const OpenedCharacter& character,
                                                    const FramePair& transition, const AnimationEntry& entry,
                                                    const Progress& progress)
{
    const FrameLayout& layout = character.graph.layout();
    const double fps = character.frames.sequences().front().fps;
    const auto around = static_cast<NodeIndex>(std::lround(previewSeconds * fps));
    const NodeIndex first =
        std::max(transition.source - around, layout.firstOf(layout.sequenceOf(transition.source)));
    const NodeIndex last =
        std::min(transition.destination + around, layout.lastOf(layout.sequenceOf(transition.destination)));
    const Walk walk{{{first, transition.source}, {transition.destination, last}}};
    const ClipPlan plan = animationPlan(entry, character.graph, {.walk = walk}, {});
    return {toSequence({}, makeClip(character.frames, plan, entry.interpolation, progress), character.frames),
            static_cast<int>(transition.source - first)};
}

TransitionPreview::TransitionPreview(JobRunner& jobs, QObject* parent) : QObject(parent), m_jobs(jobs) {}

TransitionPreview::~TransitionPreview() = default;

void TransitionPreview::show(const std::shared_ptr<const OpenedCharacter>& character,
                             const FramePair& transition, const AnimationEntry& entry)
{
    const Asked asked{character, transition, entry.interpolation, entry.gentleBlend};
    if (m_asked == asked)
        return;
    if (m_job)
        m_job->cancel();
    m_asked = asked;
    m_job = m_jobs.start(
        {.name = tr("Preview of a transition"),
         .receiver = this,
         .stillStands = [this, asked] { return m_asked == asked; },
         .background = true},
        [character, transition, entry](const Progress& progress) {
            return blend(*character, transition, entry, progress);
        },
        [this](Blended clip) {
            m_clip = std::move(clip);
            emit changed();
        });
    connect(m_job, &Job::ended, this, [this, asked](Job::State state) {
        if (state == Job::State::Failed && m_asked == asked)
            m_asked.reset(); // may be tried again
    });
}

void TransitionPreview::end()
{
    m_asked.reset();
    if (m_job)
        m_job->cancel();
    if (std::exchange(m_clip, std::nullopt))
        emit changed();
}

} // namespace quadrille

#include "moc_transitionpreview.cpp"
