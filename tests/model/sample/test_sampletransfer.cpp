// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"
#include "model/project/file/projectfile.h"
#include "model/project/media/opensequence.h"
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
#include <string>

namespace quadrille {
namespace {

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

    test::TemporaryFolder m_own;
    std::filesystem::path m_file;
    Project m_project;
};

TEST_F(SampleTransfer, keepsTheFeetOnTheGround)
{
    for (const TransferEntry& entry : m_project.transfers) {
        SCOPED_TRACE(entry.name);
        const MeshSequence made = madeBy(entry);
        // In all three takes some foot is always down. Measured: 1.2 cm under the ground, 0.7 cm above it.
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
            EXPECT_LT(slide, 0.04); // measured: 0.024 m/s, a millimetre from frame to frame
            ++standing;
        }
        EXPECT_GT(standing, skate.size() / 2);
    }
}

TEST_F(SampleTransfer, keepsTheVolumeOfTheBody)
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

} // namespace
} // namespace quadrille
