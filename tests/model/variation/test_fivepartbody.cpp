// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// A body in five parts as users have it: cut as proposed, learned, drawn, stitched with children that are
// moved onto their parent and keep their shape, laid by its torso, put on its feet.
#include "model/evaluation/variationmeasures.h"
#include "model/sequence/contacts.h"
#include "model/synthesis/clips/characterlegs.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/variation/parts/proposedparts.h"
#include "model/variation/quality.h"
#include "model/variation/variations.h"
#include "tests/model/synthesis/clipof.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <set>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr std::array names{"walk 1", "jog 1", "left turn 1", "right turn 1"};
constexpr int count = 4;

std::shared_ptr<const Movement> makeFiveParts()
{
    std::vector<TrainingTake> takes;
    for (const char* name : names)
        takes.push_back({sampleTake(name), {}, {}});
    const SampleBody& body = sample().body;
    const ProposedParts proposed = proposeParts(body.topology, body.rest);
    return std::make_shared<const Movement>(
        makeMovement(takes, 0, cutIntoParts(*body.topology, body.rest, proposed.curves, proposed.parts), {}));
}

const std::shared_ptr<const Movement>& fiveParts()
{
    static const std::shared_ptr<const Movement> only = makeFiveParts();
    return only;
}

std::vector<GpdmState> statesOfParts()
{
    std::vector<GpdmState> states;
    for (GpdmLearning& learning : learnParts(*fiveParts(), {.restarts = 0}))
        states.push_back(std::move(learning.state));
    return states;
}

const LearnedMovement& learnedParts()
{
    static const LearnedMovement only(fiveParts(), statesOfParts());
    return only;
}

/// What is drawn of it.
class FivePartBody
{
public:
    FivePartBody()
        : character(sequences())
        , drawn(sampleLatents(learnedParts(), {}, count, 1))
        , standing{character, findSupports(character, UpAxis::Y)}
        , contacts{character, legsOf(character, UpAxis::Y)}
    {
    }

    Clip clip(const LatentVariation& latents, std::uint64_t seed) const
    {
        return makeVariation(
            learnedParts(), {}, latents, character.layout(),
            {.seed = seed, .up = UpAxis::Y, .standing = &standing, .tempo = 0.7, .contacts = &contacts});
    }

    CharacterFrames character;
    LatentVariations drawn;
    CapturedStanding standing;
    VariationContacts contacts;

private:
    static std::vector<MeshSequence> sequences()
    {
        std::vector<MeshSequence> all;
        for (std::size_t t = 0; t < names.size(); ++t) {
            all.push_back(sampleTake(names[t]));
            all.back().contacts = fiveParts()->alignment.reports[t].contacts;
        }
        return all;
    }
};

const FivePartBody& body()
{
    static const FivePartBody only;
    return only;
}

double meanDistance(Positions a, Positions b)
{
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        sum += static_cast<double>((a[v] - b[v]).norm());
    return sum / static_cast<double>(a.size());
}

/// How much longer or shorter an edge is than in any captured frame, as a share of its length: the greatest
/// of all edges of some triangles.
double stretchBeyondTakes(const Clip& clip, const std::vector<TriangleIndex>& triangles)
{
    double most = 0;
    for (const TriangleIndex t : triangles) {
        const Triangle& triangle = clip.topology->triangles()[t.value];
        for (std::size_t c = 0; c < 3; ++c) {
            const auto lengthIn = [&](Positions pose) {
                return static_cast<double>(
                    (pose[triangle[c].value] - pose[triangle[(c + 1) % 3].value]).norm());
            };
            double least = 1e9;
            double longest = 0;
            for (NodeIndex node = 0; node < body().character.frameCount(); ++node) {
                const double length = lengthIn(body().character.frame(node).positions());
                least = std::min(least, length);
                longest = std::max(longest, length);
            }
            for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
                const double length = lengthIn(clip.frame(f));
                most = std::max({most, length / longest - 1, least / length - 1});
            }
        }
    }
    return most;
}

} // namespace

TEST(FivePartBody, IsLaidByItsTorsoAndMadeOfItsParts)
{
    const Movement& moved = *fiveParts();
    ASSERT_EQ(moved.parts.parts.size(), 5U);
    ASSERT_EQ(moved.training.size(), 5U);
    EXPECT_EQ(moved.parts.parts.front().name, "torso");
    EXPECT_FALSE(moved.training.front().blocks.empty());
    EXPECT_TRUE(moved.alignment.cycle.has_value());
    // What it is laid by is the torso alone, and lies still while limbs swing.
    const std::vector<VertexIndex>& anchor = moved.alignment.takes.front().laidOnto->anchor;
    EXPECT_EQ(anchor, anchorVertices(moved.parts));
    ASSERT_FALSE(anchor.empty());
    for (std::size_t p = 1; p < 5; ++p) {
        EXPECT_EQ(moved.parts.parts[p].parent, 0);
        for (const VertexIndex v : moved.parts.parts[p].vertices)
            EXPECT_FALSE(std::ranges::binary_search(anchor, v));
    }
    const AlignedTake& walk = moved.take(0);
    double swing = 0;
    for (const VertexIndex v : anchor)
        swing += static_cast<double>(
            (walk.pose(0)[v.value] - walk.pose(walk.placements.size() / 2)[v.value]).norm());
    EXPECT_LT(swing / static_cast<double>(anchor.size()), 0.03);
}

TEST(FivePartBody, IsStitchedAsItWasLearned)
{
    // Nothing is drawn: the learned trajectories of all parts.
    LatentVariation latents;
    for (std::size_t p = 0; p < 5; ++p)
        latents.push_back(learnedParts().trajectory(p, 0));
    const std::vector<Vec3f> poses = variationPoses(learnedParts(), latents);
    const AlignedTake& walk = fiveParts()->take(0);
    const std::size_t vertices = sample().body.topology->vertexCount();
    for (std::size_t f = 0; f < walk.placements.size(); ++f)
        EXPECT_LT(meanDistance(Positions(poses).subspan(f * vertices, vertices), walk.pose(f)), 0.012) << f;
}

TEST(FivePartBody, VariesInAllPartsWithoutSeamsAndInStep)
{
    const Movement& moved = *fiveParts();
    const Stances stances = findStances(body().character, UpAxis::Y);
    std::set<std::int64_t> lengths;
    std::vector<Clip> clips;
    for (int v = 0; v < count; ++v) {
        const Clip clip =
            body().clip(body().drawn.variations[static_cast<std::size_t>(v)], static_cast<std::uint64_t>(v));
        lengths.insert(clip.frameCount());
        const FollowedTake take = followedTake(clip, body().character);
        const VariationComparison comparison =
            compared(measureMoved(clip, moved, stances, UpAxis::Y),
                     measureMoved(take.clip, moved, stances, UpAxis::Y), take.frames, UpAxis::Y);
        EXPECT_LT(comparison.acceleration, 1.3) << v;
        EXPECT_LT(comparison.slide.value_or(0), 1.2) << v;
        EXPECT_LT(comparison.sink, 0.005) << v;
        EXPECT_GT(comparison.step, comparison.takeStep - 0.1) << v;
        EXPECT_LT(comparison.closing, 0.01) << v;
        // Where parts meet nothing is torn or crushed that is not in takes.
        for (std::size_t p = 1; p < 5; ++p)
            EXPECT_LT(stretchBeyondTakes(clip, moved.parts.parts[p].overlapTriangles), 0.25)
                << v << " " << moved.parts.parts[p].name;
        clips.push_back(clip);
    }
    EXPECT_GT(lengths.size(), 1U);
    // Each part differs from one to the next.
    for (std::size_t p = 0; p < 5; ++p) {
        for (int v = 1; v < count; ++v)
            EXPECT_GT((body().drawn.variations[static_cast<std::size_t>(v)][p] -
                       body().drawn.variations[static_cast<std::size_t>(v) - 1][p])
                          .norm(),
                      1e-3);
    }
    for (int v = 1; v < count; ++v)
        EXPECT_GT(meanDistance(clips[static_cast<std::size_t>(v)].frame(clips.front().frameCount() / 2),
                               clips.front().frame(clips.front().frameCount() / 2)),
                  0.005);
}
