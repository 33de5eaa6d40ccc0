// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/contacts.h"
#include "model/synthesis/clips/characterlegs.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/variation/variations.h"
#include "tests/model/largestdistance.h"
#include "tests/model/synthesis/clipof.h"
#include "tests/model/synthesis/footskate.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A walk of the sample, its body learned as a whole, with longer strides than were captured.
struct LongStrides
{
    CharacterFrames character;
    LearnedMovement learned;
    LatentVariation latents;
    CapturedStanding standing;
    VariationContacts contacts;

    LongStrides()
        : character(std::vector{walk()})
        , learned(movement(), states(*movement()))
        , latents{learned.trajectory(0, 0) * 1.2}
        , standing{character, findSupports(character, UpAxis::Y)}
        , contacts{character, legsOf(character, UpAxis::Y)}
    {
    }

    Clip clip(const VariationContacts* corrected) const
    {
        return makeVariation(learned, {}, latents, character.layout(),
                             {.up = UpAxis::Y, .standing = &standing, .contacts = corrected});
    }
    double skate(const Clip& clip) const
    {
        std::vector<double> speeds;
        const std::vector<ContactSpan> spans = contactsOf(clip, character);
        for (const Foot& foot : contacts.legs.feet) {
            const auto own = footSkate(clip, foot, spans);
            speeds.insert(speeds.end(), own.begin(), own.end());
        }
        return meanOf(speeds);
    }

private:
    static MeshSequence walk()
    {
        MeshSequence take = sampleTake("walk 1");
        take.contacts = detectContacts(take);
        return take;
    }
    static const std::shared_ptr<const Movement>& movement()
    {
        static const auto only = [] {
            const std::vector<TrainingTake> takes{{walk(), std::nullopt}};
            const MeshSequence& take = takes.front().sequence;
            const BodyParts whole =
                cutIntoParts(*take.topology, take.frame(FrameIndex(0)).positions(), {}, {});
            return std::make_shared<const Movement>(
                makeMovement(takes, 0, whole, {}, {.alignment = {.up = UpAxis::Y}}));
        }();
        return only;
    }
    static std::vector<GpdmState> states(const Movement& movement)
    {
        std::vector<GpdmState> states;
        for (GpdmLearning& part : learnParts(movement, {.restarts = 0, .greatestIterations = 30}))
            states.push_back(std::move(part.state));
        return states;
    }
};

const LongStrides& strides()
{
    static const LongStrides only;
    return only;
}

} // namespace

TEST(VariationContacts, KeepStandingFeetStill)
{
    const Clip slipping = strides().clip(nullptr);
    const Clip still = strides().clip(&strides().contacts);
    EXPECT_EQ(still.origins, slipping.origins);
    EXPECT_GT(strides().skate(slipping), 0.05);
    EXPECT_LT(strides().skate(still), 0.5 * strides().skate(slipping));
    // Only legs follow, and not far: a walker of 1.75 m moves a foot by 0.12 of that at most.
    EXPECT_LT(largestDistance(still.positions, slipping.positions), 0.25);
}

TEST(VariationContacts, StayAsTheyAreWithoutLegs)
{
    const VariationContacts none{strides().character, {}};
    EXPECT_TRUE(strides().clip(&none).positions == strides().clip(nullptr).positions);
}
