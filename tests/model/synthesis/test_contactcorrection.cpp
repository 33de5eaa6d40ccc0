// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/contacts.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/synthesis/finishing/footpath.h"
#include "model/synthesis/finishing/legdeformation.h"
#include "tests/model/sequence/realtakes.h"
#include "tests/model/synthesis/clipof.h"
#include "tests/model/synthesis/errorcodeof.h"
#include "tests/model/synthesis/footskate.h"
#include "tests/model/synthesis/plainlegdeformation.h"
#include "tests/model/synthesis/stridingtube.h"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::clipOf;
using test::errorCodeOf;
using test::footSkate;
using test::largestDistance;
using test::movedBy;
using test::sampleTake;

FrameRange frames(std::int64_t first, std::int64_t last)
{
    return {FrameIndex(first), FrameIndex(last)};
}

/// A walk of the sample whose body is pushed along while its feet stand.
struct Slipping
{
    std::vector<ContactSpan> contacts = detectContacts(sampleTake("walk 1"));
    Clip clip = clipOf(sampleTake("walk 1"));
    Figure figure;

    Slipping()
    {
        for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
            for (Vec3f& p : clip.frame(f))
                p += static_cast<float>(f) * Vec3f(0.004F, 0, 0.006F);
        }
        const std::size_t vertices = clip.topology->vertexCount();
        figure = findFigure(*clip.topology, upright(clip.positions, vertices, UpAxis::Y), 0.07);
    }
};

const Slipping& slipping()
{
    static const Slipping only;
    return only;
}

double volumeOf(const Topology& topology, Positions p)
{
    double sum = 0;
    for (const Triangle& t : topology.triangles())
        sum += static_cast<double>(p[t[0].value].dot(p[t[1].value].cross(p[t[2].value]))) / 6;
    return sum;
}

TEST(FootPath, EasesToNothingAndFromContactToContact)
{
    std::vector<double> values(30, 9);
    values[10] = 2;
    values[11] = 2;
    const std::vector<FrameRange> one{frames(10, 11)};
    easeBetween(values, one, 4);
    const std::vector<double> fade{0, 0.3125, 1, 1.6875}; // smoothstep of 2
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_DOUBLE_EQ(values[6 + k], fade[k]);
        EXPECT_DOUBLE_EQ(values[15 - k], fade[k]);
    }
    EXPECT_DOUBLE_EQ(values[5], 0);
    EXPECT_DOUBLE_EQ(values[29], 0);
    // Less than two eases apart: straight from one to the other. At the rim nothing is read or written
    // beyond.
    std::vector<double> near{1, 1, 0, 0, 0, 3, 3};
    easeBetween(near, std::vector<FrameRange>{frames(0, 1), frames(5, 6)}, 4);
    EXPECT_DOUBLE_EQ(near[3], 2);
    // The pace at the end of a contact goes on into the ease.
    std::vector<double> sliding{0, 0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    easeBetween(sliding, std::vector<FrameRange>{frames(1, 3)}, 10);
    EXPECT_NEAR(sliding[4], 2.75, 0.05);
}

TEST(FootPath, TakesOutASlipByHand)
{
    // A flat foot of four vertices slips 1 cm a frame along x (z up), for five frames.
    const auto topology = std::make_shared<const Topology>(
        TopologyData{.vertexCount = 4,
                     .triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)},
                                   {VertexIndex(0), VertexIndex(2), VertexIndex(3)}}});
    Clip clip{.topology = topology, .fps = 25, .positions = {}, .origins = std::vector<FrameProvenance>(5)};
    for (int f = 0; f < 5; ++f) {
        const float x = 0.01F * static_cast<float>(f);
        clip.positions.insert(clip.positions.end(),
                              {{x, 0, 0}, {x + 0.3F, 0, 0}, {x + 0.3F, 0.1F, 0}, {x, 0.1F, 0}});
    }
    const FootContacts foot{.vertices = {0, 1, 2, 3}, .spans = {frames(0, 4)}};
    const auto shifts = footShifts(clip, foot, {}, 1.8, Ground(UpAxis::Z));
    for (int f = 0; f < 5; ++f) {
        EXPECT_LT((shifts[static_cast<std::size_t>(f)].shift - Vec2d(0.02 - 0.01 * f, 0)).norm(), 1e-6);
        EXPECT_NEAR(shifts[static_cast<std::size_t>(f)].turn, 0, 1e-6);
        EXPECT_NEAR(shifts[static_cast<std::size_t>(f)].lift, 0, 1e-6);
    }
    ContactCorrectionSettings half;
    half.strength = 0.5;
    EXPECT_NEAR(footShifts(clip, foot, half, 1.8, Ground(UpAxis::Z))[0].shift.x(), 0.01, 1e-6);
    ContactCorrectionSettings narrow;
    narrow.greatestShift = 0.005;
    EXPECT_LE(footShifts(clip, foot, narrow, 1.8, Ground(UpAxis::Z))[0].shift.x(), 0.009);
}

TEST(LegDeformation, IsThatOfTheTextbook)
{
    const Clip& clip = slipping().clip;
    const Legs legs =
        findLegs(*clip.topology, upright(clip.positions, clip.topology->vertexCount(), UpAxis::Y), 0.07);
    const Ground ground(UpAxis::Y);
    for (const std::size_t side : {0U, 1U}) {
        const std::vector<std::uint32_t>& foot = legs.feet[side].vertices;
        const LegDeformation deformation(*clip.topology, legs.vertices[side], foot, legs.reference);
        FootShift shift{.pivot = Vec2d::Zero(), .turn = 0.2, .shift = {0.05, -0.02}, .lift = 0.01};
        for (const std::uint32_t v : foot)
            shift.pivot += ground.of(clip.frame(7)[v].cast<double>()) / static_cast<double>(foot.size());
        std::vector<Vec3f> ours(clip.frame(7).begin(), clip.frame(7).end());
        std::vector<Vec3f> plain = ours;
        deformation.apply(shift, ground, ours);
        test::deformLegPlainly(*clip.topology, legs.vertices[side], foot, legs.reference, shift, ground,
                               plain);
        // Single precision of the result; a billionth part is added to the diagonal of ours.
        EXPECT_LT(largestDistance(ours, plain), 1e-5);
        EXPECT_GT(largestDistance(ours, clip.frame(7)), 0.04);
    }
}

TEST(ContactCorrection, MakesFeetStand)
{
    const Slipping& s = slipping();
    const Clip result = contactsCorrected(s.clip, s.contacts);
    ASSERT_EQ(s.figure.feet.size(), 2U);
    for (const Foot& foot : s.figure.feet) {
        const double before = test::meanOf(footSkate(s.clip, foot, s.contacts));
        const double after = test::meanOf(footSkate(result, foot, s.contacts));
        EXPECT_GT(before, 0.15) << foot.name;
        EXPECT_LT(after, 0.15 * before) << foot.name;
    }
    for (std::int64_t f = 0; f < result.frameCount(); ++f) {
        const double volume = volumeOf(*s.clip.topology, s.clip.frame(f));
        EXPECT_NEAR(volumeOf(*s.clip.topology, result.frame(f)) / volume, 1, 0.02) << f;
    }
}

TEST(ContactCorrection, CallsFeetAsTheLegsDoThatAreTrusted)
{
    // Who calls the feet the other way round calls the contacts so, too.
    const Slipping& s = slipping();
    Legs legs = findLegs(*s.clip.topology,
                         upright(s.clip.positions, s.clip.topology->vertexCount(), UpAxis::Y), 0.07);
    ASSERT_EQ(legs.feet.size(), 2U);
    std::swap(legs.feet[0].name, legs.feet[1].name);
    std::vector<ContactSpan> contacts(s.contacts.begin(), s.contacts.end());
    for (ContactSpan& contact : contacts)
        contact.foot = contact.foot == "left" ? "right" : "left";
    const Clip expected = contactsCorrected(s.clip, s.contacts);
    const auto distance = [&](const ContactScope& scope) {
        const Clip result = contactsCorrected(s.clip, contacts, {}, scope);
        return largestDistance(result.positions, expected.positions);
    };
    EXPECT_LT(distance({.legs = &legs, .trustsLegs = true}), 1e-6);
    EXPECT_GT(distance({.legs = &legs}), 0.01);
    // Without legs nobody can be trusted.
    const Legs none;
    EXPECT_GT(distance({.legs = &none, .trustsLegs = true}), 0.01);
}

TEST(ContactCorrection, ChangesNoLengthsMuchAndDoesNotPop)
{
    const Slipping& s = slipping();
    const Clip result = contactsCorrected(s.clip, s.contacts);
    std::vector<double> stretches;
    double before = 0;
    double after = 0;
    for (std::int64_t f = 0; f < result.frameCount(); ++f) {
        const Positions a = s.clip.frame(f);
        const Positions b = result.frame(f);
        for (const Triangle& t : s.clip.topology->triangles()) {
            const auto [i, j] = std::pair(t[0].value, t[1].value);
            if (a[i] != b[i] || a[j] != b[j])
                stretches.push_back(
                    std::abs(static_cast<double>((b[i] - b[j]).norm() / (a[i] - a[j]).norm()) - 1));
        }
        if (f == 0 || f + 1 == result.frameCount())
            continue;
        for (const Foot& foot : s.figure.feet) {
            for (const std::uint32_t v : foot.vertices) {
                const auto bend = [v, f](const Clip& c) {
                    return static_cast<double>(
                        (c.frame(f + 1)[v] - 2 * c.frame(f)[v] + c.frame(f - 1)[v]).norm());
                };
                before = std::max(before, bend(s.clip));
                after = std::max(after, bend(result));
            }
        }
    }
    std::ranges::sort(stretches);
    EXPECT_LT(stretches[stretches.size() * 95 / 100], 0.03);
    EXPECT_LT(stretches.back(), 0.25);
    EXPECT_LT(after, 1.5 * before);
}

TEST(ContactCorrection, LeavesFramesAloneThatNeedNone)
{
    const Slipping& s = slipping();
    const std::vector<ContactSpan> one{{"left", frames(20, 26)}};
    const Clip result = contactsCorrected(s.clip, one);
    int changed = 0;
    for (std::int64_t f = 0; f < result.frameCount(); ++f) {
        const bool isSame = largestDistance(result.frame(f), s.clip.frame(f)) == 0;
        changed += isSame ? 0 : 1;
        const bool isFar = f < 20 - 5 || f > 26 + 5;
        EXPECT_TRUE(isSame || !isFar) << f;
    }
    EXPECT_GE(changed, 7);
    // Above the hips nothing moves at all.
    const Positions before = s.clip.frame(20);
    const Positions after = result.frame(20);
    for (std::size_t v = 0; v < before.size(); ++v) {
        const bool isAbove = before[v].y() > 1.1F;
        EXPECT_TRUE(before[v] == after[v] || !isAbove) << v;
    }
    EXPECT_EQ(contactsCorrected(s.clip, {}).positions, s.clip.positions);
    ContactCorrectionSettings none;
    none.strength = 0;
    EXPECT_EQ(contactsCorrected(s.clip, s.contacts, none).positions, s.clip.positions);
    EXPECT_EQ(result.origins, s.clip.origins);
}

TEST(ContactCorrection, LeavesAStandingFigureAlone)
{
    Clip still = slipping().clip;
    const std::size_t vertices = still.topology->vertexCount();
    for (std::int64_t f = 1; f < still.frameCount(); ++f)
        std::copy_n(still.positions.begin(), vertices, still.frame(f).begin());
    const Clip result = contactsCorrected(still, std::vector<ContactSpan>{{"left", frames(0, 30)}});
    EXPECT_EQ(result.positions, still.positions);
}

TEST(ContactCorrection, CorrectsTheFramesAskedFor)
{
    const Slipping& s = slipping();
    const Clip whole = contactsCorrected(s.clip, s.contacts);
    const Clip part = contactsCorrected(s.clip, s.contacts, {}, {.frames = frames(10, 19)});
    for (std::int64_t f = 0; f < part.frameCount(); ++f)
        EXPECT_EQ(largestDistance(part.frame(f), (f >= 10 && f <= 19 ? whole : s.clip).frame(f)), 0) << f;
}

TEST(ContactCorrection, MovesWithItsClip)
{
    const Slipping& s = slipping();
    const GroundMotion elsewhere{1.9, Vec2d(3, -4)};
    Clip there = s.clip;
    there.positions = movedBy(elsewhere, s.clip.positions, UpAxis::Y);
    const Clip a = contactsCorrected(s.clip, s.contacts);
    const Clip b = contactsCorrected(there, s.contacts);
    EXPECT_LT(largestDistance(movedBy(elsewhere, a.positions, UpAxis::Y), b.positions), 1e-3);
    // With another axis upwards, too.
    Clip upended = s.clip;
    for (Vec3f& p : upended.positions)
        p = Vec3f(p.z(), p.x(), p.y());
    const Clip c = contactsCorrected(upended, s.contacts, {}, {.up = UpAxis::Z});
    for (std::size_t i = 0; i < c.positions.size(); ++i)
        EXPECT_LT((Vec3f(c.positions[i].y(), c.positions[i].z(), c.positions[i].x()) - a.positions[i]).norm(),
                  1e-3F);
}

TEST(ContactCorrection, GivesContactsWithOtherNamesToTheStillestFoot)
{
    const Slipping& s = slipping();
    std::vector<ContactSpan> renamed = s.contacts;
    for (ContactSpan& span : renamed)
        span.foot = "foot of " + span.foot;
    EXPECT_EQ(contactsCorrected(s.clip, renamed).positions, contactsCorrected(s.clip, s.contacts).positions);
}

TEST(ContactCorrection, KnowsTheLegsOfACharacterThatDoesNotStand)
{
    // Somebody upside down has no legs to stand on, unless they are known.
    Clip fallen = slipping().clip;
    for (Vec3f& p : fallen.positions)
        p = Vec3f(p.x(), -p.y(), -p.z());
    const std::vector<ContactSpan> contacts{{"left", frames(5, 15)}};
    EXPECT_EQ(errorCodeOf([&] { contactsCorrected(fallen, contacts); }), ErrorCode::NoFeet);
    const Clip& standing = slipping().clip;
    const Legs legs = findLegs(
        *standing.topology, upright(standing.positions, standing.topology->vertexCount(), UpAxis::Y), 0.07);
    const Clip result = contactsCorrected(fallen, contacts, {}, {.legs = &legs});
    EXPECT_GT(largestDistance(result.frame(5), fallen.frame(5)), 0.001);
}

TEST(ContactCorrection, SaysWhatItCannotDo)
{
    const Slipping& s = slipping();
    EXPECT_EQ(errorCodeOf([] { contactsCorrected(test::stridingTube({}), {}, {}, {.up = UpAxis::Z}); }),
              ErrorCode::NoFeet);
    for (double ContactCorrectionSettings::*field :
         {&ContactCorrectionSettings::strength, &ContactCorrectionSettings::easeSeconds,
          &ContactCorrectionSettings::greatestShift, &ContactCorrectionSettings::greatestTurn,
          &ContactCorrectionSettings::greatestLift}) {
        for (const double bad : {-0.1, std::numeric_limits<double>::quiet_NaN()}) {
            ContactCorrectionSettings settings;
            settings.*field = bad;
            EXPECT_EQ(errorCodeOf([&] { contactsCorrected(s.clip, {}, settings); }), ErrorCode::BadArgument);
        }
    }
    CancelToken token;
    token.cancel();
    EXPECT_EQ(errorCodeOf([&] { contactsCorrected(s.clip, s.contacts, {}, {}, Progress(token)); }),
              ErrorCode::Cancelled);
}

TEST(ContactCorrection, OfRealTakes)
{
    if (!test::realTake("walk_1"))
        GTEST_SKIP() << "no real takes";
    for (const char* take : {"walk_1", "run_1", "kick_1", "walk_turn_left_1"}) {
        const MeshSequence sequence = *test::realTake(take);
        const Clip clip = clipOf(sequence);
        const std::vector<ContactSpan> contacts = detectContacts(sequence);
        const Clip result = contactsCorrected(clip, contacts);
        const Figure figure = findFigure(
            *clip.topology, upright(clip.positions, clip.topology->vertexCount(), UpAxis::Y), 0.07);
        for (const Foot& foot : figure.feet) {
            EXPECT_LT(test::meanOf(footSkate(result, foot, contacts)), 0.03) << take << " " << foot.name;
            EXPECT_GT(test::meanOf(footSkate(clip, foot, contacts)), 0.1) << take << " " << foot.name;
        }
    }
}

} // namespace
} // namespace quadrille
