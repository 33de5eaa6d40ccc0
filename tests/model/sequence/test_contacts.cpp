// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sample/sample.h"
#include "model/sequence/contacts.h"

#include <gtest/gtest.h>
#include <set>

using namespace quadrille;

namespace {

/// Feet that stand in each frame.
std::vector<std::set<std::string>> standing(const std::vector<ContactSpan>& spans, std::int64_t frames)
{
    std::vector<std::set<std::string>> feet(static_cast<std::size_t>(frames));
    for (const ContactSpan& span : spans) {
        for (std::int64_t f = span.frames.first.value; f <= span.frames.last.value; ++f)
            feet.at(static_cast<std::size_t>(f)).insert(span.foot);
    }
    return feet;
}

/// Two flat feet with a shin each, facing +z; the left one (at +x) is lifted in frames 10 … 19.
MeshSequence stepping()
{
    TopologyData data;
    std::vector<Vec3f> rest;
    for (const float side : {-0.2F, 0.2F}) {
        const auto first = static_cast<std::uint32_t>(rest.size());
        for (const float z : {0.0F, 0.1F, 0.2F}) {
            rest.emplace_back(side - 0.05F, 0.0F, z);
            rest.emplace_back(side + 0.05F, 0.0F, z);
        }
        rest.emplace_back(side, 0.12F, 0.0F);
        rest.emplace_back(side, 1.7F, 0.0F);
        const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            data.triangles.push_back(
                {VertexIndex(first + a), VertexIndex(first + b), VertexIndex(first + c)});
        };
        triangle(0, 1, 2);
        triangle(2, 1, 3);
        triangle(2, 3, 4);
        triangle(4, 3, 5);
        triangle(0, 6, 1);
        triangle(0, 7, 6);
    }
    data.vertexCount = static_cast<std::uint32_t>(rest.size());
    std::vector<Vec3f> positions;
    for (int f = 0; f < 30; ++f) {
        for (std::size_t v = 0; v < rest.size(); ++v) {
            const bool lifted = f >= 10 && f < 20 && v >= rest.size() / 2;
            positions.push_back(rest[v] + Vec3f(0, lifted ? 0.2F : 0.0F, 0));
        }
    }
    return makeSequence(
        "step", std::make_shared<const Topology>(std::move(data)),
        std::make_shared<MemoryFrames>(std::move(positions), static_cast<std::uint32_t>(rest.size())), 25);
}

} // namespace

TEST(Contacts, ALiftedFootLosesItsContactAndFeetHaveTheirSides)
{
    const auto spans = detectContacts(stepping());
    const auto feet = standing(spans, 30);
    EXPECT_TRUE(feet[5].contains("left"));
    EXPECT_FALSE(feet[15].contains("left"));
    EXPECT_TRUE(feet[25].contains("left"));
    for (std::size_t f = 0; f < feet.size(); ++f)
        EXPECT_TRUE(feet[f].contains("right")) << "frame " << f;
}

TEST(Contacts, AgreeWithTheTruthOfTheSample)
{
    SampleOptions options;
    options.takesPerKind = 1;
    options.textureSize = 64;
    const SampleCharacter sample = makeSampleCharacter(options);
    std::int64_t agreed = 0;
    std::int64_t all = 0;
    for (const SampleTake& take : sample.takes) {
        const std::int64_t frames = take.sequence.frameCount();
        const auto truth = standing(take.sequence.contacts, frames);
        const auto found = standing(detectContacts(take.sequence), frames);
        for (std::size_t f = 0; f < truth.size(); ++f) {
            for (const char* foot : {"left", "right"}) {
                agreed += truth[f].contains(foot) == found[f].contains(foot) ? 1 : 0;
                ++all;
            }
        }
    }
    RecordProperty("agreement", std::to_string(static_cast<double>(agreed) / static_cast<double>(all)));
    // The truth is the skeleton's: a rolling foot comes and goes a frame or two apart, and a step in place
    // that lifts a foot by two centimetres is hard to see.
    EXPECT_GT(static_cast<double>(agreed), 0.93 * static_cast<double>(all));
}

TEST(Contacts, CanBeCancelled)
{
    CancelToken token;
    token.cancel();
    try {
        detectContacts(stepping(), {}, Progress(token));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    }
}
