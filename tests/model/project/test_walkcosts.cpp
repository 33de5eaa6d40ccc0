// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What walks cost: the same in every unit, and in parts.
#include "model/project/document/lengthunit.h"
#include "tests/model/project/stripproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// An animation of the two strips.
class WalkCosts : public StripProject
{
protected:
    WalkCosts()
    {
        project.graphs.resize(1);
        AnimationEntry entry;
        entry.name = "dance";
        entry.walk = WalkEntry{
            .spans = {{"slow", {FrameIndex(0), FrameIndex(5)}}, {"quick", {FrameIndex(4), FrameIndex(8)}}}};
        project.animations = {entry};
    }
    AnimationEntry& animation() { return project.animations.front(); }
};

} // namespace

TEST_F(WalkCosts, AreTheSameInWhateverUnitTheProjectIs)
{
    for (int f = 0; f < 30; ++f)
        folder.write("gone/f_" + std::to_string(100 + f) + ".obj",
                     bentStrip(0.3 * std::sin(0.35 * f), 0.2 * f));
    project.sequences.push_back(sequenceOf("gone", "gone"));
    animation().walk.reset();
    animation().search.mu = 0.02;
    PathEntry path;
    path.points = {{0, 0, 0}, {1, 0, 0.3}, {2, 0, -0.1}, {3.5, 0, 0.5}};
    path.obstacles = {{.corners = {{1.5, -2.5}}, .radius = 0.4}};
    path.clearance = 0.1;
    path.spans = {{.from = 0.5, .to = 2, .duration = 2}};
    struct Found
    {
        std::vector<std::string> sequences;
        std::vector<std::int64_t> frames;
        std::vector<double> report;
        std::vector<std::string> units;
        std::vector<double> places;
    };
    const auto found = [&](const std::string& unit) {
        const double metres = metresPerUnit(unit).value();
        project.settings.axes.metresPerUnit = metres;
        PathEntry own = path;
        for (Vec3d& point : own.points)
            point /= metres;
        own.obstacles[0].corners[0] /= metres;
        own.obstacles[0].radius /= metres;
        own.clearance /= metres;
        own.spans[0].from /= metres;
        own.spans[0].to /= metres;
        animation().constraints = {own};
        computed(run("animations"));
        Found result{column<std::string>("animations/dance/frames", "sequence"),
                     column<std::int64_t>("animations/dance/frames", "source-frame"),
                     column<double>("animations/dance/report", "obtained"),
                     column<std::string>("animations/dance/report", "unit"),
                     column<double>("animations/dance/frames", "centre-x")};
        for (double& place : result.places)
            place *= metres;
        return result;
    };
    const Found metres = found("m");
    ASSERT_GT(metres.frames.size(), 10U);
    for (const char* unit : {"cm", "mm", "ft", "km"}) {
        const Found other = found(unit);
        EXPECT_EQ(other.sequences, metres.sequences) << unit;
        EXPECT_EQ(other.frames, metres.frames) << unit;
        EXPECT_EQ(other.units, metres.units) << unit;
        EXPECT_THAT(other.report,
                    ::testing::Pointwise(::testing::NanSensitiveDoubleNear(1e-3), metres.report))
            << unit;
        EXPECT_THAT(other.places, ::testing::Pointwise(::testing::DoubleNear(1e-3), metres.places)) << unit;
    }
}

TEST_F(WalkCosts, OfTransitionsAreShownInParts)
{
    project.sequences[0].contacts = {{"left", {FrameIndex(0), FrameIndex(13)}}};
    project.sequences[1].contacts = {{"right", {FrameIndex(0), FrameIndex(8)}}};
    const auto part = [&](const char* name) { return column<double>("animations/dance/walk", name).front(); };
    for (const double weight : {0.0, 0.2}) {
        project.graphs[0].steps.contacts = weight;
        computed(run("animations"));
        EXPECT_GT(part("pose-cost"), 0);
        EXPECT_EQ(part("contact-cost") > 0, weight > 0) << "other feet stand";
        EXPECT_GE(part("velocity-cost"), 0);
        EXPECT_NEAR(part("pose-cost") + part("contact-cost") + part("velocity-cost"), part("transition-cost"),
                    1e-6);
    }
    project.graphs[0] = GraphEntry::paper();
    computed(run("animations"));
    EXPECT_NEAR(part("pose-cost"), part("transition-cost"), 1e-6);
    EXPECT_EQ(part("contact-cost") + part("velocity-cost"), 0);
}
