// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/references.h"
#include "model/project/store/resultplaces.h"
#include "tests/model/project/transferproject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <sstream>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

namespace {

class TransferSteps : public TransferProject
{
};

constexpr int legRows = 30;

/// Two flat legs of a metre, the right one first, under a flat trunk; the left one kicked forwards.
/// \param x  where the figure stands.
std::string kicker(double angle, double x)
{
    std::string text;
    const auto vertex = [&](double across, double y, double z) {
        text += "v " + std::to_string(x + across) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    };
    for (const double kicked : {0.0, angle}) {
        const double side = text.empty() ? -0.15 : 0.15;
        for (int row = 0; row <= legRows; ++row) {
            const double down = static_cast<double>(row) / legRows;
            for (const double edge : {-0.05, 0.05})
                vertex(side + edge, 1 - down * std::cos(kicked), down * std::sin(kicked));
        }
    }
    vertex(-0.2, 1.7, 0);
    vertex(0.2, 1.7, 0);
    const auto triangle = [&](int a, int b, int c) {
        for (const int corner : {a, b, c})
            text += (corner == a ? "f " : " ") + std::to_string(corner + 1);
        text += "\n";
    };
    constexpr int leg = 2 * (legRows + 1);
    for (int first = 0; first < 2 * leg; first += first % leg == leg - 4 ? 4 : 2) {
        triangle(first, first + 2, first + 1);
        triangle(first + 1, first + 2, first + 3);
    }
    triangle(0, 1, 2 * leg);
    triangle(1, leg, 2 * leg);
    triangle(leg, 2 * leg + 1, 2 * leg);
    triangle(leg, leg + 1, 2 * leg + 1);
    return text;
}

} // namespace

TEST_F(TransferSteps, MakeAClipOfTheTarget)
{
    EXPECT_THAT(computed(run("transfers")), ElementsAre("transfers/slowly/clip"));
    SequenceOpener opened = opener();
    const auto made = opened.openClip("transfers/slowly");
    const auto slow = opened.open("slow");
    ASSERT_EQ(made->sequence.frameCount(), 14);
    // All triangles are paired, and they only turn; at rest the scan is bent a little.
    for (FrameIndex f(0); f.value < 14; ++f) {
        const Frame a = made->sequence.frame(f);
        const Frame b = slow->sequence.frame(f);
        for (std::size_t v = 1; v < 10; ++v)
            EXPECT_LT(((a.positions()[v] - a.positions()[0]) - (b.positions()[v] - b.positions()[0])).norm(),
                      0.07F);
    }
    EXPECT_THAT(column<std::string>("transfers/slowly/frames", "sequence"), ::testing::Each("scan"));
    EXPECT_THAT(column<double>("transfers/slowly/report", "mark-error"), ::testing::Each(::testing::Lt(2)));
    // It has no arms and legs.
    EXPECT_THAT(column<double>("transfers/slowly/report", "limb-error"), ::testing::Each(::testing::IsNan()));
}

TEST_F(TransferSteps, AreFreshUntilSomethingTheyNeedChanges)
{
    run("transfers");
    EXPECT_THAT(computed(run("transfers")), IsEmpty());
    transfer().pairs.pop_back();
    EXPECT_THAT(computed(run("transfers")), ElementsAre("transfers/slowly/clip"));
    folder.write("scan.obj", bentStrip(0.02, 2));
    EXPECT_THAT(computed(run("transfers")), ElementsAre("transfers/slowly/clip"));
    project.sequences[0].contacts = {{"left", {FrameIndex(0), FrameIndex(3)}}};
    EXPECT_THAT(computed(run("transfers")), ElementsAre("transfers/slowly/clip"));
}

TEST_F(TransferSteps, FollowTheNameOfTheTarget)
{
    run("transfers");
    renameEntry(project, NamedKind::Sequence, "scan", "body");
    run("transfers");
    EXPECT_THAT(column<std::string>("transfers/slowly/frames", "sequence"), ::testing::Each("body"));
    EXPECT_EQ(opener().openClip("transfers/slowly")->sequence.frameCount(), 14);
}

TEST_F(TransferSteps, TakeTheMeshOfTheTemplateForAPoseOfIt)
{
    folder.write("mesh.obj", bentStrip(0.01));
    const auto said = [&] {
        std::string text;
        for (const StepReport& step : run("transfers").steps) {
            for (const Issue& issue : step.issues)
                text += issue.context.values.front().second;
        }
        return text;
    };
    const auto heights = [&] {
        SequenceOpener opener(project, folder.path(), cacheFolder(folder / "p.quadrille"));
        const Frame last = opener.openClip("transfers/slowly")->sequence.frame(FrameIndex(13));
        return last.positions()[9].y() - last.positions()[0].y();
    };
    EXPECT_THAT(said(), HasSubstr("is frame 0 of “slow”"));
    const float byTake = heights();
    project.characters[0].mesh = "mesh.obj";
    EXPECT_THAT(said(), HasSubstr("is frame 0 of “mesh.obj”"));
    EXPECT_GT(std::abs(heights() - byTake), 1e-3F);
    // The same in millimetres would spoil the scale of the way.
    std::istringstream mesh(bentStrip(0.01));
    std::string large;
    for (std::string kind; mesh >> kind;) {
        std::array<double, 3> numbers{};
        for (double& number : numbers)
            mesh >> number;
        large += kind;
        for (const double number : numbers)
            large +=
                kind == "v" ? " " + std::to_string(1000 * number) : " " + std::to_string(std::lround(number));
        large += "\n";
    }
    folder.write("mesh.obj", large);
    EXPECT_THAT(said(), HasSubstr("is frame 0 of “slow”"));
}

TEST_F(TransferSteps, SayWhereAllPairsLieOnOnePart)
{
    const auto texts = [this] {
        std::string all;
        for (const StepReport& step : run("transfers").steps) {
            for (const Issue& issue : step.issues)
                all += issue.context.values.front().second;
        }
        return all;
    };
    EXPECT_THAT(texts(), Not(HasSubstr("on one part of the template")));
    transfer().pairs.resize(3);
    EXPECT_THAT(texts(), HasSubstr("All pairs lie on one part of the template"));
}

TEST_F(TransferSteps, DoNotDependOnATruth)
{
    run("transfers");
    transfer().truth = "sequences/slow";
    EXPECT_THAT(computed(run("transfers")), IsEmpty());
}

TEST_F(TransferSteps, TakeWhatTransfersMade)
{
    TransferEntry back = transfer();
    back.name = "back";
    back.clip = "transfers/slowly";
    back.target = {"slow", FrameIndex(0)};
    project.transfers.insert(project.transfers.begin(), back);
    SequenceEntry shown = sequenceOf("shown", "clip:transfers/back");
    shown.character = "strip";
    project.sequences.push_back(shown);
    EXPECT_THAT(computed(run("transfers")), ElementsAre("transfers/slowly/clip", "transfers/back/clip"));
    EXPECT_EQ(opener().open("shown")->sequence.frameCount(), 14);
}

TEST_F(TransferSteps, CarryLabelsAndContactsOfTheClip)
{
    project.sequences[0].contacts = {{"left", {FrameIndex(2), FrameIndex(5)}}};
    project.sequences[0].labels = {{"bend", {FrameIndex(0), FrameIndex(9)}}};
    run("transfers");
    const auto made = opener().openClip("transfers/slowly");
    EXPECT_EQ(made->sequence.contacts, project.sequences[0].contacts);
    EXPECT_EQ(made->sequence.labels, project.sequences[0].labels);
}

TEST_F(TransferSteps, SayWhatIsWrong)
{
    const TransferEntry whole = transfer();
    transfer().pairs.clear();
    EXPECT_THAT(failure(), HasSubstr("No two arms and two legs were found on the template"));
    transfer() = whole;
    transfer().pairs[3].onTarget = TriangleIndex(99);
    EXPECT_THAT(failure(), HasSubstr("Pair 4 names triangle 99 of the target, which has only 8"));
    transfer() = whole;
    transfer().target.frame = FrameIndex(5);
    EXPECT_THAT(failure(), HasSubstr("“scan” has no frame 5"));
    transfer() = whole;
    transfer().reference = NamedFrame{"slow", FrameIndex(14)};
    EXPECT_THAT(failure(), HasSubstr("“slow” has no frame 14"));
    EXPECT_THAT(failure(), HasSubstr("from 0 to 13"));
}

/// No frame of the clip shows two feet on the ground; the pose of the target does.
TEST_F(TransferSteps, KeepFeetStandingThatOnlyTheTargetsOwnPoseShows)
{
    constexpr int frames = 6;
    constexpr double slide = 0.02;
    for (int f = 0; f < frames; ++f)
        folder.write("kick/f_" + std::to_string(f) + ".obj", kicker(1.5 + 0.05 * f, slide * f));
    folder.write("stand.obj", kicker(0, 0));
    folder.write("scan.obj", kicker(0, 2));
    project.sequences = {sequenceOf("kick", "kick"), sequenceOf("stand", "stand.obj"),
                         sequenceOf("scan", "scan.obj")};
    project.sequences[0].contacts = {{"foot", {FrameIndex(0), FrameIndex(frames - 1)}}};
    project.sequences[2].character = "scan";
    transfer().clip = "sequences/kick";
    transfer().reference = NamedFrame{"stand", FrameIndex(0)};
    transfer().pairs.clear();
    for (std::uint32_t t = 0; t < 4 * legRows + 4; ++t)
        transfer().pairs.push_back({TriangleIndex(t), TriangleIndex(t)});
    const auto footAt = [this](std::int64_t frame) {
        const auto made = opener().openClip("transfers/slowly");
        return made->sequence.frame(FrameIndex(frame)).positions()[2 * legRows].x();
    };
    run("transfers");
    EXPECT_NEAR(footAt(frames - 1) - footAt(0), slide * (frames - 1), 0.01);
    transfer().correctsContacts = true;
    // Toes say nothing here, and one of both names would be that of the other foot.
    for (const char* foot : {"foot", "left", "right"}) {
        project.sequences[0].contacts[0].foot = foot;
        EXPECT_THAT(computed(run("transfers")), ElementsAre("transfers/slowly/clip"));
        EXPECT_NEAR(footAt(frames - 1), footAt(0), 0.005) << foot;
        const std::vector<double> slides = column<double>("transfers/slowly/report", "skate");
        EXPECT_LT(*std::max_element(slides.begin(), slides.end() - 1), 0.1) << foot;
    }
}
