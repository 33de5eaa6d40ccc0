// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/livework.h"

#include "model/core/error.h"
#include "model/project/document/findentry.h"
#include "model/project/document/groundpoint.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/steps/motionspacesteps.h"
#include "model/sequence/contacts.h"
#include "model/synthesis/clips/characterlegs.h"
#include "model/synthesis/clips/frameprovenance.h"
#include "model/synthesis/finishing/contactcorrection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

const MotionSpaceEntry& spaceEntry(const Project& project, const std::string& name)
{
    const MotionSpaceEntry* entry = findMotionSpace(project, name);
    if (entry == nullptr)
        throwInvalid("There is no motion space “" + name + "”", "Correct the name.");
    return *entry;
}

/// Feet of the frames as the takes have them.
Clip withStandingFeet(Clip clip, const LiveTakes& takes, UpAxis up, const Progress& progress)
{
    const std::vector<ContactSpan> contacts = contactsOf(clip, takes.frames());
    if (contacts.empty())
        return clip;
    try {
        const Legs legs = legsOf(takes.frames(), up, progress.part(0, 0.3));
        return contactsCorrected(clip, contacts, {},
                                 {.up = up, .frames = {}, .legs = &legs, .trustsLegs = true},
                                 progress.part(0.3, 1));
    } catch (const Error& error) {
        if (error.code() != ErrorCode::NoFeet)
            throw;
        return clip;
    }
}

} // namespace

std::vector<std::string> liveGraphSteps(const std::vector<std::string>& spaces)
{
    std::vector<std::string> steps;
    steps.reserve(spaces.size() * spaces.size());
    for (const std::string& space : spaces)
        steps.push_back(motionSpaceStepOf(space));
    for (const std::string& source : spaces) {
        for (const std::string& target : spaces) {
            if (source != target)
                steps.push_back(similarityStepOf(source, target));
        }
    }
    return steps;
}

std::shared_ptr<const LiveGraph> liveGraphFrom(const std::shared_ptr<SequenceOpener>& opener,
                                               const std::vector<std::string>& spaces,
                                               const StepContext& context, const Progress& progress)
{
    auto graph = std::make_shared<LiveGraph>();
    graph->fps = opener->project().settings.fps;
    const auto count = static_cast<double>(spaces.size());
    for (const std::string& space : spaces) {
        const auto done = static_cast<double>(graph->spaces.size());
        graph->spaces.push_back(
            sharedMotionSpace(MotionSpaceWork(opener, spaceEntry(opener->project(), space)), context,
                              progress.part(done / count, (done + 1) / count)));
    }
    graph->tables.resize(spaces.size(), std::vector<std::shared_ptr<const SimilarityTable>>(spaces.size()));
    for (std::size_t source = 0; source < spaces.size(); ++source) {
        for (std::size_t target = 0; target < spaces.size(); ++target) {
            if (source != target)
                graph->tables[source][target] = sharedSimilarities(spaces[source], spaces[target], context);
        }
    }
    return graph;
}

LiveSettings settingsOf(const LiveEntry& entry)
{
    LiveSettings settings;
    settings.ticksPerFrame = entry.ticksPerFrame;
    settings.search.depth = entry.depth;
    settings.search.latencyWeight = entry.latencyWeight;
    settings.responsiveWeight = entry.responsiveWeight;
    settings.fadeSeconds = entry.fadeSeconds;
    settings.secondsAcross = entry.secondsAcross;
    return settings;
}

LiveStart startOf(const LiveEntry& entry, const CoordinateSystem& axes)
{
    LiveStart start;
    if (!entry.inputs.empty()) {
        start.space = entry.inputs.front().input.space;
        start.parameters = entry.inputs.front().input.parameters;
    }
    const Ground ground(axes.up);
    if (entry.position)
        start.root.shift = ground.of(pointOnGround(*entry.position, axes.up)) * axes.metresPerUnit;
    start.root.turn = entry.heading * std::numbers::pi / 180;
    return start;
}

std::int64_t performedFrames(const LiveEntry& entry)
{
    return (entry.ticks - entry.from) / entry.ticksPerFrame + 1;
}

std::vector<LiveInput> inputsOf(const LiveEntry& entry)
{
    std::vector<LiveInput> inputs;
    inputs.reserve(static_cast<std::size_t>(entry.ticks));
    auto next = entry.inputs.begin();
    LiveInput wanted;
    for (std::int64_t tick = 0; tick < entry.ticks; ++tick) {
        for (; next != entry.inputs.end() && next->tick <= tick; ++next)
            wanted = next->input;
        inputs.push_back(wanted);
    }
    return inputs;
}

std::vector<LiveChange> changesOf(std::span<const LiveInput> inputs)
{
    std::vector<LiveChange> changes;
    for (std::size_t tick = 0; tick < inputs.size(); ++tick) {
        if (changes.empty() || changes.back().input != inputs[tick])
            changes.push_back({static_cast<std::int64_t>(tick), inputs[tick]});
    }
    return changes;
}

FrameIndex capturedFrame(const SpaceTakeEntry& entry, const SpaceTake& take, std::size_t frame,
                         std::int64_t frames)
{
    std::int64_t captured = std::lround(take.warp.positions[frame]);
    if (entry.isReversed)
        captured = frames - 1 - captured;
    return FrameIndex(std::clamp<std::int64_t>(captured, 0, frames - 1));
}

LiveTakes::LiveTakes(SequenceOpener& opener, const std::vector<std::string>& spaces, const Progress& progress)
    : m_names(takesOfSpaces(opener.project(), spaces))
{
    const auto metres = static_cast<float>(opener.project().settings.axes.metresPerUnit);
    std::vector<MeshSequence> sequences;
    const auto count = static_cast<double>(m_names.size());
    for (const std::string& name : m_names) {
        const auto done = static_cast<double>(sequences.size());
        sequences.push_back(transformed(opener.open(name, Progress(progress.token()))->sequence,
                                        metres * Eigen::Matrix3f::Identity()));
        if (sequences.back().contacts.empty())
            sequences.back().contacts =
                detectContacts(sequences.back(), {.up = opener.project().settings.axes.up},
                               progress.part(done / count, (done + 1) / count));
    }
    m_frames.emplace(sequences);
}

FrameProvenance LiveTakes::of(const LiveProvenance& provenance, const LiveGraph& graph,
                              const std::vector<const MotionSpaceEntry*>& spaces) const
{
    const SpaceTakeEntry& entry = spaces[provenance.space]->takes[provenance.take];
    const SpaceTake& take = graph.spaces[provenance.space]->takes[provenance.take];
    const auto sequence = static_cast<int>(std::ranges::find(m_names, entry.sequence) - m_names.begin());
    const FrameLayout& layout = m_frames->layout();
    const auto frame =
        static_cast<NodeIndex>(layout.firstOf(sequence) +
                               capturedFrame(entry, take, provenance.frame, layout.countOf(sequence)).value);
    return {.source = frame, .destination = frame, .lambda = 0, .mirrored = entry.isMirrored};
}

FrameProvenance LiveTakes::of(const LiveLook& look, const LiveGraph& graph,
                              const std::vector<const MotionSpaceEntry*>& spaces) const
{
    return originBetween(of(look.first, graph, spaces), of(look.second, graph, spaces), look.weight);
}

PerformedLive performLive(const std::shared_ptr<const LiveGraph>& graph, const LiveEntry& entry,
                          const Project& project, const LiveTakes& takes, const Progress& progress)
{
    std::vector<const MotionSpaceEntry*> spaces;
    for (const std::string& space : entry.spaces)
        spaces.push_back(&spaceEntry(project, space));
    const std::vector<LiveInput> inputs = inputsOf(entry);
    LivePlayer player(graph, settingsOf(entry), startOf(entry, project.settings.axes));
    PerformedLive made;
    made.clip.topology = takes.frames().sequences().front().topology;
    made.clip.fps = project.settings.fps;
    const std::size_t vertices = graph->vertexCount();
    made.clip.positions.reserve(static_cast<std::size_t>(performedFrames(entry)) * vertices);
    std::vector<FrameProvenance> looks;
    const auto take = [&](LivePlayer& played) {
        if (played.state().decisions != static_cast<std::int64_t>(made.decisions.size()))
            made.decisions.push_back(played.decision());
        const std::int64_t shown = played.state().tick - entry.from;
        if (shown < 0 || shown % entry.ticksPerFrame != 0)
            return;
        const std::size_t begin = made.clip.positions.size();
        made.clip.positions.resize(begin + vertices);
        played.pose(MutablePositions(made.clip.positions).subspan(begin, vertices));
        made.clip.origins.push_back(takes.of(played.provenance(), *graph, spaces));
        looks.push_back(takes.of(played.look(), *graph, spaces));
        made.states.push_back(played.state());
    };
    perform(player, inputs, take, progress.part(0, 0.4));
    if (entry.correctsContacts)
        made.clip = withStandingFeet(std::move(made.clip), takes, graph->up(), progress.part(0.4, 1));
    made.clip.looks = std::move(looks);
    return made;
}

} // namespace quadrille
