// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/exports/playerexport.h"

#include "model/core/badargument.h"
#include "model/core/stagedfiles.h"
#include "model/live/bakedplayer.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/steps/livework.h"
#include "model/sequence/io/files/exporttexture.h"
#include "model/sequence/io/playerformat.h"

#include <map>

namespace quadrille {

namespace {

/// The textures that a player shows, each once.
class BakedPictures
{
public:
    /// \return its number; BakedFrame::noPicture where the frame has none.
    std::int32_t numberOf(const std::string& name, const MeshSequence& sequence, FrameIndex frame)
    {
        const TextureSet& textures = sequence.textures;
        const int index = textures.indexFor(sequence.sourceFrame(frame));
        if (index < 0 || textures.textures()[static_cast<std::size_t>(index)].isEmpty())
            return BakedFrame::noPicture;
        const auto [known, isNew] =
            m_numbers.try_emplace({name, index}, static_cast<std::int32_t>(m_textures.size()));
        if (isNew)
            m_textures.push_back(textures.textures()[static_cast<std::size_t>(index)]);
        return known->second;
    }
    const std::vector<Texture>& textures() const { return m_textures; }

private:
    std::map<std::pair<std::string, int>, std::int32_t> m_numbers;
    std::vector<Texture> m_textures;
};

void refuseWhatPlayersHaveNot(const ExportEntry& entry)
{
    if (entry.range || entry.fps || entry.axes)
        refuse("A player has no range, no rate and no axes of its own",
               "Leave “range”, “fps”, “axes” and “unit” out of the export.");
}

void addFrames(BakedPlayer& player, const LiveEntry& live, SequenceOpener& opener, bool hasTextures,
               BakedPictures& pictures, const Progress& progress)
{
    for (std::size_t s = 0; s < live.spaces.size(); ++s) {
        const MotionSpace& space = *player.graph->spaces[s];
        const MotionSpaceEntry& entry = *findMotionSpace(opener.project(), live.spaces[s]);
        std::vector<std::vector<BakedFrame>>& takes = player.frames.emplace_back();
        for (std::size_t t = 0; t < space.takes.size(); ++t) {
            const SpaceTakeEntry& take = entry.takes[t];
            const auto opened = opener.open(take.sequence, Progress(progress.token()));
            const MeshSequence& sequence = opened->sequence;
            std::vector<BakedFrame>& frames = takes.emplace_back();
            frames.reserve(space.frameCount());
            for (std::size_t f = 0; f < space.frameCount(); ++f) {
                const FrameIndex frame = capturedFrame(take, space.takes[t], f, sequence.frameCount());
                frames.push_back({.sequence = take.sequence,
                                  .frame = frame.value,
                                  .isMirrored = take.isMirrored,
                                  .picture = hasTextures ? pictures.numberOf(take.sequence, sequence, frame)
                                                         : BakedFrame::noPicture});
            }
        }
    }
}

} // namespace

bool isPlayer(const ExportEntry& entry)
{
    try {
        return exporterOf(entry).format().id == playerFormat;
    } catch (const Error&) {
        return false; // of a format that is not known: writing it says so
    }
}

std::vector<std::string> playerSteps(const Project& project, const ExportEntry& entry)
{
    // The clip stands for the entry of the performance: what changes it changes the player.
    std::vector<std::string> steps = clipStepsOf(project, entry.what);
    if (const LiveEntry* live = liveOfClip(project, entry.what)) {
        const std::vector<std::string> graph = liveGraphSteps(live->spaces);
        steps.insert(steps.end(), graph.begin(), graph.end());
    }
    return steps;
}

std::vector<std::string> shownByPlayer(const Project& project, const ExportEntry& entry)
{
    const LiveEntry* live = liveOfClip(project, entry.what);
    return live == nullptr || !entry.textures || !isPlayer(entry) ? std::vector<std::string>()
                                                                  : takesOfSpaces(project, live->spaces);
}

ExportResult writePlayer(const ExportEntry& entry, const std::shared_ptr<SequenceOpener>& opener,
                         const StepContext& context, WriteGuard* guard, const Progress& progress)
{
    const Project& project = opener->project();
    const LiveEntry* live = liveOfClip(project, entry.what);
    if (live == nullptr)
        refusePlayerOfClip(entry.path);
    refuseWhatPlayersHaveNot(entry);
    BakedPlayer player;
    player.graph = liveGraphFrom(opener, live->spaces, context, progress.part(0, 0.3));
    player.settings = settingsOf(*live);
    player.start = startOf(*live, project.settings.axes);
    player.inputs = inputsOf(*live);
    player.from = live->from;
    player.metresPerUnit = project.settings.axes.metresPerUnit;
    BakedPictures pictures;
    addFrames(player, *live, *opener, entry.textures, pictures, progress.part(0.3, 0.4));
    player.pictureCount = pictures.textures().size();
    player.picture = [&](std::size_t picture) { return encodeTexture(pictures.textures()[picture]).bytes; };
    const std::filesystem::path path = resolvePath(entry.path, opener->folder());
    writeGuarded(
        path,
        [&](const std::filesystem::path& file) { writeBakedPlayer(player, file, progress.part(0.4, 1)); },
        guard);
    return {.files = {path}, .issues = {}};
}

} // namespace quadrille
