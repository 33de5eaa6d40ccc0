// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/findentry.h"
#include "model/project/file/projectfile.h"
#include "model/project/media/importsequences.h"
#include "model/project/media/media.h"
#include "model/project/media/opensequence.h"
#include "model/project/results/check.h"
#include "model/sequence/io/registry.h"
#include "tests/model/project/testproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;
using ::testing::HasSubstr;

namespace {

constexpr std::int64_t frameCount = 11;

std::shared_ptr<const Topology> tetrahedron(bool turned = false)
{
    const auto triangle = [](int a, int b, int c) {
        return Triangle{VertexIndex(a), VertexIndex(b), VertexIndex(c)};
    };
    TopologyData data;
    data.vertexCount = 4;
    data.triangles = {triangle(0, 2, 1), triangle(0, 1, 3), triangle(1, 2, 3), triangle(0, 3, 2)};
    if (turned)
        std::swap(data.triangles[0], data.triangles[1]);
    return std::make_shared<const Topology>(std::move(data));
}

/// A tetrahedron that moves one unit along x in each frame.
MeshSequence moving()
{
    std::vector<Vec3f> positions;
    for (std::int64_t f = 0; f < frameCount; ++f) {
        const auto x = static_cast<float>(f);
        positions.insert(positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}});
    }
    return makeSequence("walk", tetrahedron(), std::make_shared<MemoryFrames>(std::move(positions), 4U), 25);
}

constexpr const char* meshText = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
constexpr const char* otherText = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 4\nf 1 3 2\nf 2 3 4\nf 1 4 3\n";

class OpenSequence : public ::testing::Test
{
protected:
    OpenSequence()
    {
        folder.write("mesh.obj", meshText);
        exportSequence(moving(), folder / "walk.pc2");
        project.characters = {characterOf("tetra", "mesh.obj")};
        project.sequences = {sequenceOf("walk", "walk.pc2")};
    }
    MeshSequence open(const std::string& name = "walk")
    {
        const SequenceEntry* entry = findSequence(project, name);
        auto opened = openSequence(project, folder.path(), *entry);
        issues = opened.issues;
        return opened.sequence;
    }
    ErrorCode failure(const std::string& name = "walk")
    {
        try {
            open(name);
        } catch (const Error& error) {
            return error.code();
        }
        return ErrorCode::Cancelled;
    }

    TemporaryFolder folder;
    Project project;
    std::vector<Issue> issues;
};

} // namespace

TEST_F(OpenSequence, TakesTheProjectsRateWhereTheSourceNamesNone)
{
    project.settings.fps = 40;
    const MeshSequence sequence = open();
    EXPECT_EQ(sequence.fps, 40);
    EXPECT_EQ(sequence.frameCount(), frameCount);
    EXPECT_TRUE(issues.empty());
}

TEST_F(OpenSequence, ResamplesAnotherRateAndSaysSo)
{
    project.sequences[0].sourceFps = 50;
    const MeshSequence sequence = open();
    EXPECT_EQ(sequence.frameCount(), 6);
    EXPECT_FLOAT_EQ(sequence.frame(FrameIndex(2)).positions()[0].x(), 4);
    ASSERT_EQ(issues.size(), 1U);
    EXPECT_EQ(issues[0].code, Issue::Code::FpsResampled);
    EXPECT_THAT(issues[0].toString(), HasSubstr("from 50 to 25"));
}

TEST_F(OpenSequence, CutsToTheRangeInSourceFrames)
{
    project.sequences[0].range = FrameRange{FrameIndex(3), FrameIndex(5)};
    const MeshSequence sequence = open();
    EXPECT_EQ(sequence.frameCount(), 3);
    EXPECT_FLOAT_EQ(sequence.frame(FrameIndex(0)).positions()[0].x(), 3);
    project.sequences[0].range = FrameRange{FrameIndex(3), FrameIndex(11)};
    EXPECT_EQ(failure(), ErrorCode::RangeOutside);
}

TEST_F(OpenSequence, ConvertsAxesAndUnit)
{
    project.settings.axes = {UpAxis::Z, 1.0};
    project.sequences[0].sourceAxes = CoordinateSystem{UpAxis::Y, 0.01};
    const MeshSequence sequence = open();
    const Vec3f top = sequence.frame(FrameIndex(0)).positions()[2];
    EXPECT_NEAR(top.z(), 0.01, 1e-7);
    EXPECT_NEAR(top.y(), 0, 1e-7);
}

TEST_F(OpenSequence, ClipsOfClipsKeepTheirFrames)
{
    project.sequences[0].range = FrameRange{FrameIndex(2), FrameIndex(8)};
    SequenceEntry part = sequenceOf("part", "clip:sequences/walk");
    part.range = FrameRange{FrameIndex(1), FrameIndex(2)};
    project.sequences.push_back(part);
    const MeshSequence sequence = open("part");
    EXPECT_EQ(sequence.name, "part");
    EXPECT_EQ(sequence.frameCount(), 2);
    EXPECT_FLOAT_EQ(sequence.frame(FrameIndex(0)).positions()[0].x(), 3);
}

TEST_F(OpenSequence, SpansThatLeaveTheSequenceAreCutAndReported)
{
    project.sequences[0].labels = {{"walk", {FrameIndex(4), FrameIndex(99)}}};
    const MeshSequence sequence = open();
    ASSERT_EQ(sequence.labels.size(), 1U);
    EXPECT_EQ(sequence.labels[0].frames.last.value, frameCount - 1);
    ASSERT_EQ(issues.size(), 1U);
    EXPECT_THAT(issues[0].toString(), HasSubstr("only 11 frames"));
}

TEST_F(OpenSequence, SequencesOfOneCharacterShareOneTopology)
{
    project.sequences.push_back(sequenceOf("again", "walk.pc2"));
    SequenceOpener opener(project, folder.path());
    EXPECT_EQ(opener.open("walk")->sequence.topology, opener.open("again")->sequence.topology);
    folder.write("still.obj", otherText);
    project.sequences.push_back(sequenceOf("still", "still.obj"));
    try {
        open("still");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::TopologyMismatch);
        EXPECT_THAT(error.what(), HasSubstr("still.obj"));
    }
}

TEST_F(OpenSequence, OneTextureForEachFrameOrNone)
{
    for (std::int64_t f = 0; f < frameCount; ++f)
        writeImage(Image(2, 2), folder / ("textures/t_" + std::to_string(f) + ".png"));
    project.sequences[0].texture = textureOf(TextureReference::Kind::PerFrame, {"textures"});
    const MeshSequence sequence = open();
    EXPECT_EQ(sequence.textures.kind(), TextureSet::Kind::PerFrame);
    EXPECT_EQ(sequence.textures.textures().size(), static_cast<std::size_t>(frameCount));
    fs::remove(folder / "textures/t_10.png");
    EXPECT_EQ(failure(), ErrorCode::ImageCountMismatch);
}

TEST_F(OpenSequence, CheckNamesTheProblemsWithTheirLines)
{
    saveProject(project, folder / "p.quadrille");
    EXPECT_TRUE(checkProject(folder / "p.quadrille").problems.empty());
    project.sequences.push_back(sequenceOf("lost", "lost.pc2"));
    project.sequences[0].range = FrameRange{FrameIndex(0), FrameIndex(50)};
    ExportEntry entry;
    entry.name = "e";
    entry.what = "sequences/walk";
    entry.path = "e.unheardof";
    project.exports = {entry};
    saveProject(project, folder / "p.quadrille");
    const CheckReport report = checkProject(folder / "p.quadrille");
    ASSERT_EQ(report.problems.size(), 3U);
    EXPECT_EQ(report.problems[0].code, ErrorCode::ProjectMissingMedia);
    EXPECT_THAT(report.problems[0].toString(), HasSubstr("lost.pc2"));
    EXPECT_EQ(report.problems[0].context.place.line, 24);
    EXPECT_THAT(report.problems[1].toString(), HasSubstr("only 11"));
    EXPECT_THAT(report.problems[2].toString(), HasSubstr("format"));
}

TEST_F(OpenSequence, ImportMakesAProjectAndNumbersNames)
{
    ImportRequest request;
    request.sources = {folder / "walk.pc2"};
    request.mesh = folder / "mesh.obj";
    request.sourceFps = 48;
    const auto file = folder / "new.quadrille";
    const ImportReport first = importSequences(file, request);
    EXPECT_TRUE(first.isNewProject);
    const ImportReport second = importSequences(file, request);
    EXPECT_FALSE(second.isNewProject);
    EXPECT_THAT(second.names, ::testing::ElementsAre("walk-2"));
    const Project made = loadProject(file);
    EXPECT_EQ(made.settings.fps, 48);
    EXPECT_EQ(made.characters.size(), 1U);
    EXPECT_EQ(made.characters[0].mesh, "mesh.obj");
    EXPECT_EQ(made.sequences.size(), 2U);
    EXPECT_EQ(made.sequences[0].source, "walk.pc2");
    EXPECT_FALSE(made.sequences[0].sourceFps);
}

TEST_F(OpenSequence, AnImportThatDoesNotFitChangesNothing)
{
    saveProject(project, folder / "p.quadrille");
    const std::string before = textOf(folder / "p.quadrille");
    folder.write("other.obj", otherText);
    ImportRequest request;
    request.sources = {folder / "walk.pc2", folder / "other.obj"};
    EXPECT_THROW(importSequences(folder / "p.quadrille", request), Error);
    EXPECT_EQ(textOf(folder / "p.quadrille"), before);
}

TEST_F(OpenSequence, ASecondCharacterLeavesTheFirstOnesSequencesAlone)
{
    saveProject(project, folder / "p.quadrille");
    folder.write("other.obj", otherText);
    ImportRequest request;
    request.sources = {folder / "other.obj"};
    request.character = "second";
    importSequences(folder / "p.quadrille", request);
    const Project two = loadProject(folder / "p.quadrille");
    EXPECT_EQ(two.sequences[0].character, "tetra");
    EXPECT_EQ(two.sequences[1].character, "second");
}
