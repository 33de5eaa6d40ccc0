// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/comparison.h"
#include "model/project/projectdata.h"
#include "model/project/rebuild.h"
#include "model/transition/posedistance.h"
#include "model/transition/transitiontable.h"
#include "tests/model/project/testproject.h"

#include <cmath>
#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::UnorderedElementsAre;

namespace {

/// A strip of eight triangles that bends to and fro.
std::string bentStrip(double angle)
{
    std::string text;
    double x = 0;
    double y = 0;
    double direction = 0;
    for (int row = 0; row < 5; ++row) {
        for (const int z : {0, 1})
            text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
        x += std::cos(direction);
        y += std::sin(direction);
        direction += angle;
    }
    for (int row = 1; row < 8; row += 2) {
        const auto corner = [&](int i) { return std::to_string(row + i) + " "; };
        text += "f " + corner(0) + corner(1) + corner(3) + "\nf " + corner(0) + corner(3) + corner(2) + "\n";
    }
    return text;
}

class GraphStages : public ::testing::Test
{
protected:
    GraphStages()
    {
        for (int f = 0; f < 14; ++f)
            folder.write("slow/f_" + std::to_string(f) + ".obj", bentStrip(0.3 * std::sin(0.35 * f)));
        for (int f = 0; f < 9; ++f)
            folder.write("quick/f_" + std::to_string(f) + ".obj", bentStrip(0.35 * std::sin(0.7 * f + 0.1)));
        project.settings.fps = 6; // windows of 2 to 12 frames
        project.sequences = {sequenceOf("slow", "slow"), sequenceOf("quick", "quick")};
        project.graphs.resize(1);
    }
    RebuildReport run() { return rebuild(project, folder / "p.quadrille", {.targets = {"graph"}}); }
    DataItem item(const std::string& name)
    {
        for (const DataItem& found : projectData(project, folder / "p.quadrille")) {
            if (found.name == name)
                return found;
        }
        ADD_FAILURE() << "no data " << name;
        return {};
    }
    Table<float> matrix(const std::string& name)
    {
        const DataItem found = item(name);
        const auto& array = std::get<DataArray>(found.content);
        const auto& values = std::get<std::vector<float>>(array.values);
        return Eigen::Map<const Table<float>>(values.data(), array.shape[0], array.shape[1]);
    }
    std::vector<std::string> computed(const RebuildReport& report)
    {
        std::vector<std::string> names;
        for (const StageReport& stage : report.stages) {
            EXPECT_NE(stage.state, StageState::Failed) << stage.error->what();
            if (stage.state == StageState::Computed)
                names.push_back(stage.stage);
        }
        return names;
    }
    CharacterFrames frames()
    {
        SequenceOpener opener(project, folder.path());
        const std::vector<MeshSequence> sequences{opener.open("slow", {})->sequence,
                                                  opener.open("quick", {})->sequence};
        return CharacterFrames(sequences);
    }

    TemporaryFolder folder;
    Project project;
};

} // namespace

TEST_F(GraphStages, HoldWhatTheFunctionsCompute)
{
    run();
    const PoseDistances poses = poseDistances(frames());
    EXPECT_TRUE((matrix("pose-distance") == poses.distances).all());
    EXPECT_TRUE(
        (matrix("euclidean-distance") == poseDistances(frames(), {.metric = PoseMetric::Euclidean}).distances)
            .all());
    const TransitionTable transitions = transitionTable(poses.distances, poses.layout, {.fps = 6});
    EXPECT_TRUE((matrix("transition-cost") == transitions.cost).all());
    const Table<float> lengths = matrix("transition-length");
    EXPECT_TRUE((lengths.isFinite() == (transitions.length > 0)).all());
    EXPECT_EQ(lengths(0, 22), static_cast<float>(transitions.length(0, 22)));

    const TransitionCosts costs(transitions.cost, transitions.length, poses.distances.maxCoeff(),
                                poses.layout);
    const Digraph essential = essentialGraph(costs, 0.01).graph;
    const DataItem found = item("essential-graph-edges");
    const auto& table = std::get<DataTable>(found.content);
    const auto& from = std::get<std::vector<std::int64_t>>(table.columns[0].values);
    const auto& weights = std::get<std::vector<double>>(table.columns[2].values);
    ASSERT_EQ(from.size(), essential.edges().size());
    for (std::size_t e = 0; e < from.size(); ++e) {
        EXPECT_EQ(from[e], essential.edges()[e].from);
        EXPECT_EQ(weights[e], essential.edges()[e].weight);
    }
}

TEST_F(GraphStages, OnlyWhatASettingReachesIsComputedAgain)
{
    EXPECT_EQ(computed(run()).size(), 4U);
    EXPECT_TRUE(computed(run()).empty());
    project.graphs[0].alpha = 0.1;
    EXPECT_THAT(computed(run()), UnorderedElementsAre("graph/graphs"));
    project.graphs[0].slope = 2;
    EXPECT_THAT(computed(run()), UnorderedElementsAre("graph/transitions", "graph/graphs"));
    project.graphs[0].durations = {0.5, 1.0};
    EXPECT_THAT(computed(run()), UnorderedElementsAre("graph/transitions", "graph/graphs"));
    project.graphs[0].pose.stretchWeight = 0.5;
    EXPECT_THAT(computed(run()),
                UnorderedElementsAre("graph/pose-distance", "graph/transitions", "graph/graphs"));
    folder.write("slow/f_3.obj", bentStrip(-0.2));
    EXPECT_EQ(computed(run()).size(), 4U);
}

TEST_F(GraphStages, WindowsComeFromDurationsAtTheRateOfTheProject)
{
    GraphEntry entry;
    EXPECT_EQ(transitionSettings(entry, 25).shortest(), 9);
    EXPECT_EQ(transitionSettings(entry, 25).longest(), 50);
    entry.durations = {0.2, 1.0};
    EXPECT_EQ(transitionSettings(entry, 25).shortest(), 5);
    EXPECT_EQ(transitionSettings(entry, 25).longest(), 25);
    EXPECT_EQ(transitionSettings(entry, 29.97).shortest(), 6);
    EXPECT_EQ(transitionSettings(entry, 29.97).longest(), 29);
}

TEST_F(GraphStages, AProjectWithoutTheSectionHasNone)
{
    project.graphs.clear();
    EXPECT_THROW(run(), Error);
}
