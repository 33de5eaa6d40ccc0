// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/synthesis/realcharacter.h"

#include "model/sequence/io/registry.h"
#include "model/transition/posedistance.h"

#include <array>
#include <filesystem>
#include <memory>
#include <string>

namespace quadrille::test {

namespace {

constexpr std::array takesOfTests{
    "dance_1", "jump_long", "jump_low", "kick_1",    "kick_2",           "reach_high",       "run_1",
    "run_2",   "sit_1",     "walk_1",   "walk_slow", "walk_turn_left_1", "walk_turn_right_1"};

std::vector<std::string> allTakes(const std::filesystem::path& folder)
{
    std::vector<std::string> takes;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        if (file.path().extension() == ".pc2")
            takes.push_back(file.path().stem().string());
    }
    std::ranges::sort(takes);
    return takes;
}

std::unique_ptr<RealCharacter> readRealCharacter(bool whole)
{
    const std::filesystem::path folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/rb_m04";
    if (!std::filesystem::exists(folder))
        return nullptr;
    ImportOptions options;
    options.mesh = folder / "mesh.obj";
    options.fps = 30;
    std::vector<MeshSequence> sequences;
    std::map<std::string, WalkSpan> takes;
    NodeIndex frames = 0;
    const std::vector<std::string> names =
        whole ? allTakes(folder) : std::vector<std::string>(takesOfTests.begin(), takesOfTests.end());
    for (const std::string& take : names) {
        sequences.push_back(openSequences(folder / (take + ".pc2"), options).sequences.front());
        const auto count = static_cast<NodeIndex>(sequences.back().frameCount());
        takes[take] = {frames, frames + count - 1};
        frames += count;
    }
    const CharacterFrames character(sequences);
    PoseDistances poses = poseDistances(character);
    const TransitionSettings settings{.fps = 30};
    TransitionTable table = transitionTable(poses.distances, character.layout(), settings);
    TransitionCosts costs(*table.cost, *table.length, poses.distances.maxCoeff(), character.layout());
    EssentialGraph essential = essentialGraph(costs, RealCharacter::alpha);
    return std::make_unique<RealCharacter>(RealCharacter{.settings = settings,
                                                         .takes = std::move(takes),
                                                         .distances = std::move(poses.distances),
                                                         .layout = character.layout(),
                                                         .table = std::move(table),
                                                         .costs = std::move(costs),
                                                         .essential = std::move(essential),
                                                         .roots = rootPoses(character, UpAxis::Y)});
}

} // namespace

FrameSet RealCharacter::framesOf(const std::string& name) const
{
    FrameSet set{.name = name, .spans = {}};
    for (const auto& [take, span] : takes) {
        if (take.starts_with(name))
            set.spans.push_back(span);
    }
    return set;
}

const RealCharacter* realCharacter()
{
    static const std::unique_ptr<RealCharacter> character = readRealCharacter(false);
    return character.get();
}

const RealCharacter* wholeRealCharacter()
{
    static const std::unique_ptr<RealCharacter> character = readRealCharacter(true);
    return character.get();
}

} // namespace quadrille::test
