// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/sample.h"
#include "model/sequence/io/registry.h"
#include "model/variation/alignment.h"
#include "tests/model/variation/footahead.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <map>

namespace quadrille {
namespace {

using test::agreement;
using test::footAhead;

const SampleCharacter& sample()
{
    static const SampleCharacter character = makeSampleCharacter({.textureSize = 64});
    return character;
}

/// \param contacts  those that the generator knows; otherwise none at all.
TrainingTake sampleTake(const std::string& name, bool contacts)
{
    for (const SampleTake& take : sample().takes) {
        if (take.sequence.name == name) {
            TrainingTake training{take.sequence, {}};
            if (!contacts)
                training.sequence.contacts = {{"nothing", FrameRange::all(1)}};
            return training;
        }
    }
    ADD_FAILURE() << "the sample has no " << name;
    return {};
}

std::vector<TrainingTake> sampleTakes(const std::vector<std::string>& names, bool contacts)
{
    std::vector<TrainingTake> takes;
    for (const std::string& name : names)
        takes.push_back(sampleTake(name, contacts));
    return takes;
}

/// Reference frames by which the landings of a take's feet miss those of the reference's at most.
double greatestMiss(const TrainingTake& reference, const TakeWarp& referenceWarp, const TrainingTake& take,
                    const TakeWarp& warp)
{
    const auto cycle = static_cast<double>(referenceWarp.positions.size());
    const auto landings = [](const TrainingTake& of, const TakeWarp& at, const std::string& foot) {
        std::vector<double> phases;
        for (const ContactSpan& span : of.sequence.contacts) {
            if (span.foot == foot && span.frames.first.value > 0 && at.frames.contains(span.frames.first))
                phases.push_back(
                    at.playback[static_cast<std::size_t>(span.frames.first.value - at.frames.first.value)]);
        }
        return phases;
    };
    double greatest = 0;
    int compared = 0;
    for (const std::string foot : {"left", "right"}) {
        for (const double phase : landings(take, warp, foot)) {
            for (const double expected : landings(reference, referenceWarp, foot)) {
                const double difference = phase - expected;
                greatest = std::max(greatest, std::abs(difference - cycle * std::round(difference / cycle)));
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 1);
    return greatest;
}

TEST(AlignmentOfSample, CyclesOfLocomotionAgreeWithTheGeneratorWithoutItsContacts)
{
    for (const std::string number : {" 1", " 2"}) {
        const std::vector<std::string> names = {"walk" + number, "jog" + number, "left turn" + number,
                                                "right turn" + number};
        const std::vector<TrainingTake> truth = sampleTakes(names, true);
        const Alignment alignment = alignTakes(sampleTakes(names, false), 0);
        ASSERT_TRUE(alignment.cycle);
        const std::vector<double> reference = footAhead(truth[0].sequence, sample().body.rest);
        for (std::size_t t = 0; t < names.size(); ++t) {
            const TakeWarp& warp = alignment.takes[t].warp;
            EXPECT_EQ(alignment.reports[t].use, TakeUse::Cycle) << names[t];
            const double miss = greatestMiss(truth[0], alignment.takes[0].warp, truth[t], warp);
            const double agree = agreement(reference, alignment.takes[0].warp,
                                           footAhead(truth[t].sequence, sample().body.rest), warp);
            std::printf("%-12s frames %2ld-%2ld  landings within %.1f frames  feet agree by %.3f\n",
                        names[t].c_str(), static_cast<long>(warp.frames.first.value),
                        static_cast<long>(warp.frames.last.value), miss, agree);
            // Who jogs lands with the foot below him, a seventh of a cycle after the foot was ahead.
            const bool jogs = names[t].starts_with("jog");
            EXPECT_LE(miss, jogs ? 4.5 : 1.6) << names[t];
            EXPECT_GT(agree, jogs ? 0.7 : 0.97) << names[t];
        }
    }
}

TEST(AlignmentOfSample, FlightsOfJumpsMeet)
{
    for (const std::string number : {" 1", " 2"}) {
        const std::vector<TrainingTake> takes = sampleTakes(
            {"short jump" + number, "long jump" + number, "low jump" + number, "high jump" + number}, true);
        const Alignment alignment = alignTakes(takes, 0);
        EXPECT_FALSE(alignment.cycle);
        std::vector<FrameRange> flights;
        for (const TrainingTake& take : takes) {
            for (const SampleTake& known : sample().takes) {
                if (known.sequence.name == take.sequence.name)
                    flights.push_back(known.flight);
            }
        }
        for (std::size_t t = 0; t < takes.size(); ++t) {
            EXPECT_EQ(alignment.reports[t].use, TakeUse::Whole);
            const auto& playback = alignment.takes[t].warp.playback;
            const double from = playback[static_cast<std::size_t>(flights[t].first.value)];
            const double to = playback[static_cast<std::size_t>(flights[t].last.value)];
            std::printf("%-12s flight %2ld-%2ld is at %.1f-%.1f of the reference's %ld-%ld\n",
                        takes[t].sequence.name.c_str(), static_cast<long>(flights[t].first.value),
                        static_cast<long>(flights[t].last.value), from, to,
                        static_cast<long>(flights[0].first.value), static_cast<long>(flights[0].last.value));
            EXPECT_NEAR(from, static_cast<double>(flights[0].first.value), 2);
            EXPECT_NEAR(to, static_cast<double>(flights[0].last.value), 2);
        }
    }
}

class RealTakes
{
public:
    RealTakes() : m_folder(std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/rb_m04") {}
    bool exist() const { return std::filesystem::exists(m_folder / "mesh.obj"); }
    std::vector<TrainingTake> get(const std::vector<std::string>& names) const
    {
        std::vector<TrainingTake> takes;
        for (const std::string& name : names)
            takes.push_back({open(name + ".pc2"), {}});
        return takes;
    }
    MeshSequence open(const std::string& file) const
    {
        ImportOptions options;
        if (file != "mesh.obj")
            options.mesh = m_folder / "mesh.obj";
        options.fps = 30;
        return openSequences(m_folder / file, options).sequences.front();
    }

private:
    std::filesystem::path m_folder;
};

/// Of each take how well its feet agree with those of the first over the reference frames.
std::vector<double> agreements(const RealTakes& real, const std::vector<TrainingTake>& takes,
                               const Alignment& alignment)
{
    const Frame rest = real.open("mesh.obj").frame(FrameIndex(0));
    const std::vector<double> reference = footAhead(takes[0].sequence, rest.positions());
    std::vector<double> agreements;
    for (std::size_t t = 0; t < takes.size(); ++t) {
        const AlignedTake& take = alignment.takes[t];
        agreements.push_back(agreement(reference, alignment.takes[0].warp,
                                       footAhead(takes[t].sequence, rest.positions()), take.warp));
        std::printf("%-18s frames %2ld-%2ld of %2ld  feet agree by %.3f\n", take.name.c_str(),
                    static_cast<long>(take.warp.frames.first.value),
                    static_cast<long>(take.warp.frames.last.value),
                    static_cast<long>(takes[t].sequence.frameCount()), agreements.back());
    }
    return agreements;
}

TEST(AlignmentOfRealTakes, SameFootIsAheadAtTheSamePhase)
{
    const RealTakes real;
    if (!real.exist())
        GTEST_SKIP() << "no real data";
    const std::vector<TrainingTake> takes =
        real.get({"walk_1", "jog_1", "walk_turn_left_1", "walk_turn_right_1"});
    const Alignment alignment = alignTakes(takes, 0);
    EXPECT_EQ(alignment.cycle, 34);
    const std::vector<double> agree = agreements(real, takes, alignment);
    for (std::size_t t = 0; t < 3; ++t) {
        EXPECT_EQ(alignment.reports[t].use, TakeUse::Cycle);
        EXPECT_GT(agree[t], 0.95);
    }
    // The turn to the right does not come back to where it began: its ends are no phase of the cycle.
    EXPECT_EQ(alignment.reports[3].use, TakeUse::NoCycle);
    EXPECT_GT(agree[3], 0.7);
}

TEST(AlignmentOfRealTakes, WalksAndRunsOfSeveralPeopleAreCutToCycles)
{
    const RealTakes real;
    if (!real.exist())
        GTEST_SKIP() << "no real data";
    const std::vector<TrainingTake> takes =
        real.get({"walk_1", "walk_slow", "walk_fast", "run_1", "run_2", "walk_turn_right_2"});
    const Alignment alignment = alignTakes(takes, 0);
    for (const double agree : agreements(real, takes, alignment))
        EXPECT_GT(agree, 0.85);
    for (const WarpReport& report : alignment.reports)
        EXPECT_EQ(report.use, TakeUse::Cycle);
}

TEST(AlignmentOfRealTakes, JumpsAreUsedWhole)
{
    const RealTakes real;
    if (!real.exist())
        GTEST_SKIP() << "no real data";
    std::vector<TrainingTake> takes = real.get({"jump_short", "jump_long", "jump_high", "jump_low"});
    // He jumps twice.
    takes[3].range = FrameRange{FrameIndex(0), FrameIndex(38)};
    const Alignment alignment = alignTakes(takes, 0);
    EXPECT_FALSE(alignment.cycle);
    // Of each take the frame in the middle of its flight, read from the heights of its feet.
    const std::vector<double> flights = {34, 40, 35, 23};
    for (std::size_t t = 0; t < takes.size(); ++t) {
        EXPECT_EQ(alignment.reports[t].use, t == 3 ? TakeUse::Given : TakeUse::Whole);
        const double at = alignment.takes[t].warp.playback[static_cast<std::size_t>(flights[t])];
        std::printf("%-12s middle of flight at %.1f of the reference\n", takes[t].sequence.name.c_str(), at);
        EXPECT_NEAR(at, flights[0], 6) << takes[t].sequence.name;
    }
}

} // namespace
} // namespace quadrille
