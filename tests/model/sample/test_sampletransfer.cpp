// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"
#include "model/geometry/procrustes.h"
#include "model/project/file/projectfile.h"
#include "model/project/media/opensequence.h"
#include "model/project/results/opentransfer.h"
#include "model/project/results/projectdata.h"
#include "model/project/results/rebuild.h"
#include "model/project/store/dataitem.h"
#include "model/project/store/resultplaces.h"
#include "sampletest.h"
#include "tests/model/core/temporaryfolder.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace quadrille {
namespace {

/// The vertices of the triangles around a place.
std::vector<VertexIndex> around(const Topology& mesh, const SurfacePoint& place)
{
    const Triangle& middle = mesh.triangles()[place.triangle.value];
    const auto touches = [&](VertexIndex v) { return std::ranges::find(middle, v) != middle.end(); };
    std::set<VertexIndex> found;
    for (const Triangle& t : mesh.triangles()) {
        if (std::ranges::any_of(t, touches))
            found.insert(t.begin(), t.end());
    }
    return {found.begin(), found.end()};
}

/// How some vertices have turned from one pose to another.
Eigen::Quaterniond turnOf(const std::vector<VertexIndex>& vertices, Positions from, Positions onto)
{
    const auto some = [&](Positions pose) {
        std::vector<Vec3f> positions;
        for (const VertexIndex v : vertices)
            positions.push_back(pose[v.value]);
        return positions;
    };
    return rigidProcrustes(some(from), some(onto)).rotation;
}

/// The transfer that the sample has, and two more of its takes onto the same body.
class SampleTransfer : public ::testing::Test
{
protected:
    SampleTransfer()
        : m_file(writeSample(m_own / "sample", {.textureSize = 64, .takesPerKind = 1}))
        , m_project(loadProject(m_file))
    {
        for (const char* take : {"dance 1", "left turn 1"}) {
            TransferEntry entry = m_project.transfers.front();
            entry.name = take;
            entry.clip = std::string("sequences/") + take;
            m_project.transfers.push_back(entry);
        }
    }

    void SetUp() override
    {
        const RebuildReport report = rebuild(m_project, m_file, {.targets = {"transfers"}});
        ASSERT_EQ(report.count(StepState::Computed), m_project.transfers.size());
    }

    std::vector<double> reported(const TransferEntry& entry, const std::string& name) const
    {
        const auto items = projectData(m_project, m_file);
        const auto item = std::ranges::find(items, "transfers/" + entry.name + "/report", &DataItem::name);
        if (item == items.end())
            return {};
        const auto& columns = std::get<DataTable>(item->content).columns;
        const auto column = std::ranges::find(columns, name, &DataArray::name);
        return column == columns.end() ? std::vector<double>()
                                       : std::get<std::vector<double>>(column->values);
    }

    MeshSequence madeBy(const TransferEntry& entry) const
    {
        SequenceOpener opener(m_project, m_file.parent_path(), cacheFolder(m_file));
        return opener.openClip("transfers/" + entry.name)->sequence;
    }

    void keepsTheFeetOnTheGround() const;
    void pointsLimbsAndFeetAsTheTemplateDoes() const;
    void keepsTheVolumeOfTheBody() const;
    void turnsPlacesAsTheCharacterTurnsThem() const;
    void keepsTheLikenessOfProposedPairsOnceTheyAreTheProjects() const;

    test::TemporaryFolder m_own;
    std::filesystem::path m_file;
    Project m_project;
};

void SampleTransfer::keepsTheFeetOnTheGround() const
{
    for (const TransferEntry& entry : m_project.transfers) {
        SCOPED_TRACE(entry.name);
        const MeshSequence made = madeBy(entry);
        // In all three takes some foot is always down. Measured: 0.9 cm under the ground, 0.4 cm above it.
        for (FrameIndex f(0); f.value < made.frameCount(); ++f) {
            const double lowest = boundsOf(made.frame(f).positions()).min.y();
            EXPECT_GT(lowest, -0.02) << f.value;
            EXPECT_LT(lowest, 0.015) << f.value;
        }
        const std::vector<double> skate = reported(entry, "skate");
        ASSERT_EQ(std::ssize(skate), made.frameCount());
        std::size_t standing = 0;
        for (const double slide : skate) {
            if (std::isnan(slide))
                continue;
            EXPECT_LT(slide, 0.01); // measured: less than 0.0001 m/s
            ++standing;
        }
        EXPECT_GT(standing, skate.size() / 2);
    }
}

void SampleTransfer::pointsLimbsAndFeetAsTheTemplateDoes() const
{
    for (const TransferEntry& entry : m_project.transfers) {
        SCOPED_TRACE(entry.name);
        for (const char* name : {"limb-error", "foot-error"}) {
            const std::vector<double> errors = reported(entry, name);
            ASSERT_EQ(std::ssize(errors), madeBy(entry).frameCount());
            double sum = 0;
            for (const double error : errors)
                sum += error / static_cast<double>(errors.size());
            EXPECT_LT(sum, 5) << name; // measured: 3°
        }
    }
}

void SampleTransfer::keepsTheVolumeOfTheBody() const
{
    for (const TransferEntry& entry : m_project.transfers) {
        SCOPED_TRACE(entry.name);
        const std::vector<double> volume = reported(entry, "volume");
        ASSERT_FALSE(volume.empty());
        // Rotations that are spread over joints take some of it, most where knees are bent. Measured: 0.95 to
        // 0.98 of that at rest.
        EXPECT_GT(std::ranges::min(volume), 0.93);
        EXPECT_LT(std::ranges::max(volume), 1.01);
    }
}

/// Both bodies stand alike at rest, so that the same places on them have the same turns in all frames.
void SampleTransfer::turnsPlacesAsTheCharacterTurnsThem() const
{
    const SampleCharacter sample = makeSampleCharacter({.textureSize = 64, .takesPerKind = 1});
    SequenceOpener opener(m_project, m_file.parent_path(), cacheFolder(m_file));
    for (const TransferEntry& entry : m_project.transfers) {
        SCOPED_TRACE(entry.name);
        const MeshSequence take = opener.openClip(entry.clip)->sequence;
        const MeshSequence made = opener.openClip("transfers/" + entry.name)->sequence;
        ASSERT_EQ(made.frameCount(), take.frameCount());
        double sum = 0;
        int count = 0;
        for (const LandmarkPair& pair : sample.landmarks) {
            const auto source = around(*sample.body.topology, pair.source);
            const auto target = around(*sample.target.topology, pair.target);
            for (FrameIndex f(0); f.value < made.frameCount(); f.value += 8, ++count) {
                const auto expected = turnOf(source, sample.body.rest, take.frame(f).positions());
                const auto turn = turnOf(target, sample.target.rest, made.frame(f).positions());
                sum += expected.angularDistance(turn) * 180 / std::numbers::pi;
            }
        }
        // Measured: 3 to 5 degrees; 8 where the reference pose is the most alike of the takes alone.
        EXPECT_LT(sum / count, 6);
        RecordProperty(entry.name, std::to_string(sum / count));
    }
}

void SampleTransfer::keepsTheLikenessOfProposedPairsOnceTheyAreTheProjects() const
{
    const ProjectResults results({m_project, m_file});
    const TransferPreviewPointer preview = previewTransfer(results, m_project.transfers[0].name, nullptr);
    ASSERT_TRUE(preview->posed);
    ASSERT_TRUE(preview->alignment);
    EXPECT_GT(preview->pairs.size(), 100U);
    for (const ProposedPair& each : preview->pairs)
        EXPECT_NEAR(preview->alignment->likeness(each.pair), each.quality, 1e-6);
}

// One test, because the clips are computed anew for each program that runs.
TEST_F(SampleTransfer, movesTheOtherBodyAsTheCharacterMoves)
{
    keepsTheFeetOnTheGround();
    pointsLimbsAndFeetAsTheTemplateDoes();
    keepsTheVolumeOfTheBody();
    turnsPlacesAsTheCharacterTurnsThem();
    keepsTheLikenessOfProposedPairsOnceTheyAreTheProjects();
}

} // namespace
} // namespace quadrille
