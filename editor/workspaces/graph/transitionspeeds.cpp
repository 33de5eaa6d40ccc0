// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/transitionspeeds.h"

#include "editor/jobs/jobrunner.h"
#include "model/synthesis/clips/makeclip.h"
#include "model/synthesis/quality/junctionspeeds.h"

#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

constexpr NodeIndex framesAround = 3; // captured ones that speeds at the ends are taken over

TransitionSpeeds::Speeds measure(const OpenedCharacter& opened, const FramePair& pair, bool isGentle,
                                 const Progress& progress)
{
    const CharacterGraph& graph = opened.graph;
    const FrameLayout& layout = graph.layout();
    const NodeIndex first =
        std::max(pair.source - framesAround, layout.firstOf(layout.sequenceOf(pair.source)));
    const NodeIndex last =
        std::min(pair.destination + framesAround, layout.lastOf(layout.sequenceOf(pair.destination)));
    const Walk walk{{{first, pair.source}, {pair.destination, last}}};
    const ClipPlan plan =
        planClip(graph.roots(), layout, graph.paths(), walk,
                 {.start = {}, .blend = isGentle ? BlendSettings::gentle() : BlendSettings()});
    Clip clip = makeClip(opened.frames, plan, InterpolationMethod::Poisson, progress);
    clip.fps = opened.frames.sequences().front().fps;
    const ClipPlan::Junction& junction = plan.junctions.front();
    const double metres = graph.work().opener->project().settings.axes.metresPerUnit;
    const auto inMetres = [metres](std::optional<double> speed) {
        return speed ? std::optional(*speed * metres) : std::nullopt;
    };
    return {inMetres(footSlide(clip, junction, graph.roots(), stancesOf(clip, graph.roots().stances))),
            inMetres(speedJump(plan, junction, clip.fps))};
}

std::pair<NodeIndex, NodeIndex> keyOf(const FramePair& pair)
{
    return {pair.source, pair.destination};
}

} // namespace

TransitionSpeeds::TransitionSpeeds(JobRunner& jobs, QObject* parent) : QObject(parent), m_jobs(jobs) {}

void TransitionSpeeds::setCharacter(std::shared_ptr<const OpenedCharacter> opened)
{
    m_opened = std::move(opened);
    m_asked.clear();
    forget();
}

void TransitionSpeeds::setGentle(bool gentle)
{
    if (gentle == m_isGentle)
        return;
    m_isGentle = gentle;
    forget();
    measureNext();
}

void TransitionSpeeds::forget()
{
    ++m_generation;
    if (m_job)
        m_job->cancel();
    m_job.clear();
    m_known.clear();
    emit changed();
}

void TransitionSpeeds::ask(std::vector<FramePair> pairs)
{
    m_asked = std::move(pairs);
    measureNext();
}

const TransitionSpeeds::Speeds* TransitionSpeeds::of(const FramePair& pair) const
{
    const auto found = m_known.find(keyOf(pair));
    return found == m_known.end() ? nullptr : &found->second;
}

void TransitionSpeeds::measureNext()
{
    if (!m_opened || (m_job && !m_job->isOver()))
        return;
    const auto next =
        std::ranges::find_if(m_asked, [this](const FramePair& pair) { return of(pair) == nullptr; });
    if (next == m_asked.end())
        return;
    const auto take = [this, pair = *next](const Speeds& speeds) {
        m_job.clear();
        m_known[keyOf(pair)] = speeds;
        emit changed();
        measureNext();
    };
    m_job = m_jobs.start(
        {.name = tr("Measuring a transition"),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         // Why it cannot be blended is told where it is played.
         .failed = [take](const Error&) { take({}); },
         .background = true},
        [opened = m_opened, pair = *next, isGentle = m_isGentle](const Progress& progress) {
            return measure(*opened, pair, isGentle, progress);
        },
        take);
}

} // namespace quadrille

#include "moc_transitionspeeds.cpp"
