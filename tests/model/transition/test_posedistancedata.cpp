// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/registry.h"
#include "model/transition/posedistance.h"
#include "tests/model/transition/plainposedistance.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Takes of the real character; empty where its data are missing.
std::vector<MeshSequence> realTakes(const std::vector<std::string>& names)
{
    const std::filesystem::path folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/rb_m04";
    std::vector<MeshSequence> takes;
    if (!std::filesystem::exists(folder))
        return takes;
    ImportOptions options;
    options.mesh = folder / "mesh.obj";
    options.fps = 30;
    for (const std::string& name : names)
        takes.push_back(openSequences(folder / (name + ".pc2"), options).sequences.front());
    return takes;
}

} // namespace

TEST(PoseDistanceOfRealTakes, AgreesWithThePlainReference)
{
    const std::vector<MeshSequence> takes = realTakes({"walk_1", "stand_1", "kick_1", "sit_1"});
    if (takes.empty())
        GTEST_SKIP() << "no real takes";
    const CharacterFrames frames(takes);
    const PoseDistances surface = poseDistances(frames);
    const PoseDistances euclidean = poseDistances(frames, {.metric = PoseMetric::Euclidean});
    EXPECT_EQ(surface.trianglesLeftOut, 0);
    double worst = 0;
    const auto check = [&](NodeIndex i, NodeIndex j) {
        const Frame a = frames.frame(i);
        const Frame b = frames.frame(j);
        const double expected = plainSurfaceDistance(a.positions(), b.positions(), frames.triangles(), 0.01);
        EXPECT_NEAR(surface.distances(i, j), expected, 1e-5 * expected) << i << ", " << j;
        worst = std::max(worst, std::abs(surface.distances(i, j) / expected - 1));
        const double vertices = plainEuclideanDistance(a.positions(), b.positions());
        EXPECT_NEAR(euclidean.distances(i, j), vertices, 1e-5 * vertices) << i << ", " << j;
    };
    // A third of the neighbours, among them the slowest motion, and pairs far apart.
    for (NodeIndex i = 0; i + 1 < frames.frameCount(); i += 3)
        check(i, i + 1);
    for (NodeIndex i = 7; i < frames.frameCount(); i += 7)
        check((37 * i + 11) % i, i);
    std::ostringstream text;
    text << worst;
    RecordProperty("largestRelativeError", text.str());
}
