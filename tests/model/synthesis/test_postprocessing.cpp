// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/procrustes.h"
#include "model/sequence/contacts.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/synthesis/finishing/mirror.h"
#include "model/synthesis/finishing/postprocessing.h"
#include "model/synthesis/finishing/retime.h"
#include "tests/model/sequence/realtakes.h"
#include "tests/model/synthesis/clipof.h"
#include "tests/model/synthesis/errorcodeof.h"
#include "tests/model/synthesis/footskate.h"
#include "tests/model/synthesis/stridingtube.h"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::clipOf;
using test::errorCodeOf;
using test::footSkate;
using test::largestDistance;
using test::sampleTake;

const Clip& walk()
{
    static const Clip clip = clipOf(sampleTake("walk 1"));
    return clip;
}

std::vector<ContactSpan> contactsOf(const Clip& clip)
{
    return detectContacts(
        makeSequence("clip", clip.topology,
                     std::make_shared<MemoryFrames>(clip.positions, clip.topology->vertexCount()), clip.fps));
}

std::vector<double> skateOf(const Clip& clip)
{
    const std::vector<ContactSpan> contacts = contactsOf(clip);
    const Figure figure =
        findFigure(*clip.topology, upright(clip.positions, clip.topology->vertexCount(), UpAxis::Y), 0.07);
    std::vector<double> speeds;
    for (const Foot& foot : figure.feet) {
        const std::vector<double> found = footSkate(clip, foot, contacts);
        speeds.insert(speeds.end(), found.begin(), found.end());
    }
    return speeds;
}

double largestFrameStep(const Clip& clip)
{
    double largest = 0;
    for (std::int64_t f = 1; f < clip.frameCount(); ++f)
        largest = std::max(largest, largestDistance(clip.frame(f - 1), clip.frame(f)));
    return largest;
}

TEST(PostProcessing, OfNothingChangesNothing)
{
    EXPECT_TRUE(PostProcessing().isEmpty());
    const PostProcessed result = postProcessed(walk(), {}, {});
    EXPECT_EQ(result.clip.positions, walk().positions);
    EXPECT_EQ(result.clip.origins, walk().origins);
    EXPECT_FALSE(result.travel);
}

TEST(PostProcessing, FollowsItsOrder)
{
    PostProcessing settings{.loop = LoopSettings(), .contacts = ContactCorrectionSettings(), .mirror = true};
    settings.repeats = 2;
    settings.retime = RetimeSettings{.time = RetimeFactor{1.5}, .keepsRootSpeed = false};
    const PostProcessingInputs inputs;
    const PostProcessed result = postProcessed(walk(), settings, inputs);
    Loop loop = contactsCorrected(seamlessLoop(walk(), {}, {}), {}, inputs);
    const Symmetry symmetry = findSymmetry(*walk().topology, test::sample().body.rest);
    loop = mirrored(loop, symmetry, mirrorLine(loop.cycle, symmetry, UpAxis::Y), UpAxis::Y);
    const Loop twice{repeated(loop, 2, UpAxis::Y), repeatedTravel(loop.travel, 2), {}};
    const Loop expected = retimed(twice, *settings.retime, UpAxis::Y);
    EXPECT_EQ(result.clip.positions, expected.cycle.positions);
    EXPECT_EQ(result.clip.origins, expected.cycle.origins);
    EXPECT_EQ(result.clip.frameCount(), std::llround(1.5 * 2 * static_cast<double>(loop.cycle.frameCount())));
    ASSERT_TRUE(result.travel);
    EXPECT_EQ(*result.travel, expected.travel);
    EXPECT_TRUE(result.clip.origins.front().mirrored);
    ASSERT_TRUE(result.closure);
}

TEST(PostProcessing, WithoutALoopDoesTheRest)
{
    PostProcessing settings{.contacts = ContactCorrectionSettings(), .mirror = true};
    settings.retime = RetimeSettings{.time = Seconds{1}, .keepsRootSpeed = true};
    int asked = 0;
    PostProcessingInputs inputs;
    inputs.contactsOf = [&asked](const Clip& clip) {
        ++asked;
        return contactsOf(clip);
    };
    inputs.symmetry = [&asked](const Progress&) {
        ++asked;
        return findSymmetry(*walk().topology, test::sample().body.rest);
    };
    const PostProcessed result = postProcessed(walk(), settings, inputs);
    EXPECT_EQ(asked, 2);
    EXPECT_EQ(result.clip.frameCount(), std::llround(walk().fps) + 1);
    EXPECT_FALSE(result.travel);
    EXPECT_FALSE(result.closure);
}

TEST(PostProcessing, OfALoopCorrectsContactsAcrossItsSeam)
{
    const PostProcessingInputs inputs;
    const Loop loop = seamlessLoop(walk(), {}, {});
    const Loop corrected = contactsCorrected(loop, {}, inputs);
    EXPECT_EQ(corrected.travel, loop.travel);
    const Clip before = repeated(loop, 3, UpAxis::Y);
    const Clip after = repeated(corrected, 3, UpAxis::Y);
    EXPECT_LT(test::meanOf(skateOf(after)), 0.5 * test::meanOf(skateOf(before)));
    EXPECT_LT(largestFrameStep(after), 1.1 * largestFrameStep(before));
}

TEST(PostProcessing, OfAStandingLoopDoesNotTravel)
{
    // Somebody who stands and drifts a little.
    Clip clip = clipOf(sampleTake("idle 1"));
    for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
        for (Vec3f& p : clip.frame(f))
            p += static_cast<float>(f) * Vec3f(0.0005F, 0, 0.0002F);
    }
    PostProcessing settings{.loop = LoopSettings()};
    const PostProcessed drifting = postProcessed(clip, settings, {});
    EXPECT_GT(drifting.travel->shift.norm(), 0.005);
    settings.contacts = ContactCorrectionSettings();
    const PostProcessed result = postProcessed(clip, settings, {});
    EXPECT_EQ(*result.travel, GroundMotion());
    const double before = largestFrameStep(repeated({drifting.clip, *drifting.travel, {}}, 2, UpAxis::Y));
    EXPECT_LT(largestFrameStep(repeated({result.clip, {}, {}}, 2, UpAxis::Y)), 1.02 * before);
}

TEST(PostProcessing, InPlaceStaysAfterTheContactsWereCorrected)
{
    PostProcessing settings{.loop = LoopSettings{.cutStart = {}, .cutEnd = {}, .inPlace = true},
                            .contacts = ContactCorrectionSettings()};
    settings.repeats = 3;
    const PostProcessed result = postProcessed(walk(), settings, {});
    EXPECT_EQ(*result.travel, GroundMotion());
    const Vec3d first = centroid(result.clip.frame(0));
    const Vec3d last = centroid(result.clip.frame(result.clip.frameCount() - 1));
    EXPECT_LT((first - last).norm(), 0.1);
}

TEST(PostProcessing, ByACurveThatDoesNotGoRoundIsNoLoop)
{
    PostProcessing settings{.loop = LoopSettings()};
    const PostProcessed whole = postProcessed(walk(), settings, {});
    const double duration = static_cast<double>(whole.clip.frameCount()) / walk().fps;
    settings.retime = RetimeSettings{.time = RetimeSettings::Curve{{{0}, {0}}, {{1}, {duration / 2}}},
                                     .keepsRootSpeed = false};
    EXPECT_FALSE(postProcessed(walk(), settings, {}).travel);
    settings.retime =
        RetimeSettings{.time = RetimeSettings::Curve{{{0}, {0}}, {{2}, {duration}}}, .keepsRootSpeed = false};
    EXPECT_TRUE(postProcessed(walk(), settings, {}).travel);
}

TEST(PostProcessing, LooksForTheLegsOfAFallenFigureInItsCharacter)
{
    Clip fallen = walk();
    for (Vec3f& p : fallen.positions)
        p = Vec3f(p.x(), -p.y(), -p.z());
    PostProcessingInputs inputs;
    inputs.contactsOf = [](const Clip&) {
        return std::vector<ContactSpan>{{"left", {FrameIndex(5), FrameIndex(15)}}};
    };
    const PostProcessing settings{.contacts = ContactCorrectionSettings()};
    EXPECT_EQ(errorCodeOf([&] { postProcessed(fallen, settings, inputs); }), ErrorCode::NoFeet);
    inputs.character = CharacterFrames(std::vector{sampleTake("walk 1")});
    EXPECT_NE(postProcessed(fallen, settings, inputs).clip.positions, fallen.positions);
}

TEST(PostProcessing, SaysWhatItCannotDo)
{
    const auto code = [](const Clip& clip, const PostProcessing& settings, const Progress& progress = {}) {
        PostProcessingInputs inputs;
        inputs.method.up = UpAxis::Z;
        return errorCodeOf([&] { postProcessed(clip, settings, inputs, progress); });
    };
    const Clip tube = test::stridingTube({});
    PostProcessing repeats;
    repeats.repeats = 2;
    EXPECT_EQ(code(tube, repeats), ErrorCode::BadArgument);
    EXPECT_EQ(code(tube, {.contacts = ContactCorrectionSettings()}), ErrorCode::NoFeet);
    PostProcessing none{.loop = LoopSettings()};
    none.repeats = 0;
    EXPECT_EQ(code(tube, none), ErrorCode::BadArgument);
    CancelToken token;
    token.cancel();
    EXPECT_EQ(code(tube, {.loop = LoopSettings()}, Progress(token)), ErrorCode::Cancelled);
}

TEST(PostProcessing, OfRealWalks)
{
    if (!test::realTake("walk_1"))
        GTEST_SKIP() << "no real takes";
    for (const char* take : {"walk_1", "walk_fast", "jog_1", "run_1"}) {
        const Clip clip = clipOf(*test::realTake(take));
        const PostProcessed plain = postProcessed(clip, {.loop = LoopSettings()}, {});
        const PostProcessed result =
            postProcessed(clip, {.loop = LoopSettings(), .contacts = ContactCorrectionSettings()}, {});
        const Clip around = repeated({result.clip, *result.travel, {}}, 3, UpAxis::Y);
        EXPECT_LT(largestFrameStep(around), 1.3 * largestFrameStep(clip)) << take;
        const std::vector<double> before = skateOf(clip);
        EXPECT_LT(test::meanOf(skateOf(around)), 0.3 * test::meanOf(before)) << take;
        EXPECT_GT(result.travel->shift.norm(), 0.5) << take;
        EXPECT_EQ(plain.clip.frameCount(), result.clip.frameCount());
    }
}

} // namespace
} // namespace quadrille
