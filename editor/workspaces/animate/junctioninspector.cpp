// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/junctioninspector.h"

#include "editor/jobs/jobrunner.h"

#include <utility>

namespace quadrille {

JunctionInspector::JunctionInspector(JobRunner& jobs, QObject* parent) : QObject(parent), m_jobs(jobs) {}

JunctionInspector::~JunctionInspector() = default;

JunctionInspector::Inspected JunctionInspector::measure(const Request& asked,
                                                        std::shared_ptr<const FrameMeasures> frames,
                                                        const Progress& progress)
{
    const CharacterGraph& graph = asked.character->graph;
    const RootPoses& roots = graph.roots();
    constexpr double measuringFrames = 0.8;
    if (frames == nullptr)
        frames = std::make_shared<const FrameMeasures>(frameMeasures(
            asked.character->frames, roots.supports, roots.up, progress.part(0, measuringFrames)));
    progress.report(measuringFrames);
    const FramePair& pair = asked.transition;
    const Walk walk{{{pair.source, pair.source}, {pair.destination, pair.destination}}};
    const Transition transition = transitionsOf(walk, graph.layout(), graph.paths()).front();
    const JunctionJudge judge(asked.character->frames, roots, *frames);
    return {frames, judge.judge(transition, asked.isGentle ? BlendSettings::gentle() : BlendSettings(),
                                asked.interpolation)};
}

void JunctionInspector::inspect(const std::shared_ptr<const OpenedCharacter>& character,
                                const FramePair& transition, const AnimationEntry& entry)
{
    const Request asked{character, transition, entry.gentleBlend, entry.interpolation};
    if (m_asked == asked)
        return;
    clear();
    if (character->graph.roots().supports.empty())
        return; // nothing to measure the slip of feet by
    m_asked = asked;
    m_job = m_jobs.start(
        {.name = tr("Measuring a transition"),
         .receiver = this,
         .stillStands = [this, asked] { return m_asked == asked; },
         .failed = [](const Error&) { /* told when the clip is made */ },
         .background = true},
        [asked, frames = m_character == character ? m_frames : nullptr](const Progress& progress) {
            return measure(asked, frames, progress);
        },
        [this, character](const Inspected& inspected) {
            m_character = character;
            m_frames = inspected.frames;
            m_measures = inspected.measures;
            emit changed();
        });
}

void JunctionInspector::clear()
{
    if (m_job)
        m_job->cancel();
    m_asked.reset();
    if (std::exchange(m_measures, std::nullopt))
        emit changed();
}

} // namespace quadrille

#include "moc_junctioninspector.cpp"
