// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/openlive.h"

#include "model/core/message.h"
#include "model/project/document/findentry.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/steps/livework.h"

#include <algorithm>

namespace quadrille {

namespace {

/// The same pose in all frames.
class StillFrames : public FrameSource
{
public:
    StillFrames(std::vector<Vec3f> pose, std::int64_t frames) : m_pose(std::move(pose)), m_frames(frames) {}

    std::int64_t frameCount() const override { return m_frames; }
    std::uint32_t vertexCount() const override { return static_cast<std::uint32_t>(m_pose.size()); }
    std::optional<Positions> view(FrameIndex /*frame*/) const override { return m_pose; }
    void read(FrameIndex /*frame*/, MutablePositions out) const override
    {
        std::ranges::copy(m_pose, out.begin());
    }

private:
    std::vector<Vec3f> m_pose;
    std::int64_t m_frames;
};

MeshSequence lookOfSpaces(const LiveGraph& graph, const std::vector<std::string>& spaces,
                          SequenceOpener& opener, const Progress& progress)
{
    std::vector<MeshSequence> takes;
    std::vector<Texture> textures;
    for (std::size_t s = 0; s < spaces.size(); ++s) {
        const MotionSpace& space = *graph.spaces[s];
        const std::vector<SpaceTakeEntry>& entries = findMotionSpace(opener.project(), spaces[s])->takes;
        for (std::size_t t = 0; t < entries.size(); ++t) {
            takes.push_back(opener.open(entries[t].sequence, Progress(progress.token()))->sequence);
            const MeshSequence& take = takes.back();
            for (std::size_t f = 0; f < space.frameCount(); ++f) {
                const FrameIndex frame = capturedFrame(entries[t], space.takes[t], f, take.frameCount());
                const int index = take.textures.indexFor(take.sourceFrame(frame));
                textures.push_back(index < 0 ? Texture()
                                             : take.textures.textures()[static_cast<std::size_t>(index)]);
            }
        }
    }
    MeshSequence look = takes.front().cutTo({FrameIndex(0), FrameIndex(0)});
    look.source = std::make_shared<StillFrames>(loadFrames(look), std::ssize(textures));
    look.range = FrameRange::all(std::ssize(textures));
    if (look.textures.kind() != TextureSet::Kind::PerMaterial &&
        std::ranges::any_of(textures, [](const Texture& texture) { return !texture.isEmpty(); }))
        look.textures = TextureSet::perFrame(std::move(textures));
    return look;
}

} // namespace

FrameIndex OpenedLiveGraph::lookOf(const LiveProvenance& provenance) const
{
    std::size_t frame = provenance.frame;
    for (std::size_t s = 0; s < provenance.space; ++s)
        frame += graph->spaces[s]->takes.size() * graph->spaces[s]->frameCount();
    return FrameIndex(frame + provenance.take * graph->spaces[provenance.space]->frameCount());
}

std::vector<std::string> playableSpaces(const Project& project, const std::string& character)
{
    std::vector<std::string> names;
    for (const MotionSpaceEntry& entry : project.motionSpaces) {
        if (!entry.takes.empty() && characterNameOf(project, entry) == character)
            names.push_back(entry.name);
    }
    return names;
}

OpenedLiveGraphPointer openLiveGraph(const ProjectResults& results, const std::string& character,
                                     const Progress& progress)
{
    auto opened = std::make_shared<OpenedLiveGraph>();
    opened->character = character;
    opened->spaces = playableSpaces(results.project(), character);
    if (opened->spaces.empty())
        throwInvalid("There is no motion space to play", QUADRILLE_MESSAGE("Make one of some takes."));
    opened->metresPerUnit = results.project().settings.axes.metresPerUnit;
    const std::vector<std::string> steps = liveGraphSteps(opened->spaces);
    const FreshResults fresh = results.get(steps, progress.part(0, 0.9));
    for (const std::string& step : steps)
        opened->content += fresh.keyOf(step) + '\n';
    opened->graph = liveGraphFrom(results.opener(), opened->spaces, fresh.context(), progress.part(0.9, 1));
    opened->look = lookOfSpaces(*opened->graph, opened->spaces, *results.opener(), progress);
    progress.report(1);
    return opened;
}

} // namespace quadrille
