// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/file.h"
#include "model/project/document/project.h"
#include "model/project/file/projectfile.h"
#include "model/project/results/openmotionspace.h"
#include "sampletest.h"
#include "tests/model/core/temporaryfolder.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <string>

namespace quadrille {
namespace {

namespace fs = std::filesystem;

class WriteSample : public ::testing::Test
{
protected:
    static std::map<std::string, std::string> contents(const fs::path& folder)
    {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.is_regular_file())
                files[fs::relative(entry.path(), folder).string()] =
                    std::string(readFile(entry.path()).text());
        return files;
    }

    test::TemporaryFolder m_own;
    fs::path m_folder = m_own / "sample"; ///< does not exist yet
};

TEST_F(WriteSample, everythingThatTheProjectNamesIsThere)
{
    const fs::path file = writeSample(m_folder, {.textureSize = 128, .takesPerKind = 1});
    const Project project = loadProject(file);
    EXPECT_EQ(project.characters.size(), 2U);
    ASSERT_EQ(project.sequences.size(), 14U);
    EXPECT_FALSE(project.exports.empty());
    EXPECT_FALSE(project.evaluations.empty());
    for (const CharacterEntry& character : project.characters) {
        EXPECT_TRUE(fs::exists(m_folder / character.mesh));
        EXPECT_FALSE(readImage(m_folder / character.texture.paths.at(0)).isEmpty());
    }
    for (const SequenceEntry& sequence : project.sequences) {
        EXPECT_TRUE(fs::exists(m_folder / sequence.source)) << sequence.source;
        if (sequence.character != project.characters[0].name)
            continue;
        EXPECT_TRUE(fs::exists(m_folder / sequence.jointAngles)) << sequence.jointAngles;
        EXPECT_FALSE(sequence.contacts.empty()) << sequence.name;
        EXPECT_FALSE(sequence.labels.empty()) << sequence.name;
    }
    ASSERT_EQ(project.transfers.size(), 1U);
    EXPECT_EQ(project.transfers[0].target.sequence, project.sequences[13].name);
    EXPECT_EQ(project.sequences[13].character, project.characters[1].name);
    EXPECT_EQ(project.sequences[13].source, project.characters[1].mesh);
    ASSERT_EQ(project.variations.size(), 2U);
    EXPECT_EQ(project.variations[0].name, "walking");
    EXPECT_EQ(project.variations[1].name, "jumping");
    ASSERT_EQ(project.variations[1].training.size(), 4U);
    for (const TrainingEntry& take : project.variations[1].training) {
        // A flight of a third to three quarters of a second, and ten frames on both sides of it.
        ASSERT_TRUE(take.range) << take.sequence;
        EXPECT_GE(take.range->count(), 26) << take.sequence;
        EXPECT_LE(take.range->count(), 40) << take.sequence;
    }
    ASSERT_EQ(project.motionSpaces.size(), 3U);
    EXPECT_EQ(project.motionSpaces[0].name, "walking");
    EXPECT_TRUE(project.motionSpaces[2].takes[1].range);
    for (const char* truth : {"skeleton.json", "takes.json", "landmarks.json", "warps_walk_1.npy"})
        EXPECT_GT(fs::file_size(m_folder / "groundtruth" / truth), 100U) << truth;
    EXPECT_TRUE(fs::exists(m_folder / "textures/walk_1/0000.jpg"));
}

TEST_F(WriteSample, itsMotionSpacesCanBeSteeredAndGoOverToEachOther)
{
    const fs::path file = writeSample(m_folder, {.textureSize = 128, .takesPerKind = 1});
    const Project project = loadProject(file);
    const ProjectResults results({project, file});
    const std::map<std::string, double> spans{{"walking", 0.8}, {"turning", 80}, {"jumping", 0.4}};
    for (const MotionSpaceEntry& entry : project.motionSpaces) {
        const auto space = openMotionSpace(results, entry.name);
        EXPECT_EQ(space->isCyclic, entry.name != "jumping");
        const double span = space->map.greatest[0] - space->map.least[0];
        EXPECT_GT(span, spans.at(entry.name)) << entry.name;
        EXPECT_LT(space->map.worstResidual[0], 0.02 * span) << entry.name;
    }
    EXPECT_GT(openSimilarities(results, "walking", "jumping")->greatest, 0);
}

TEST_F(WriteSample, givesTheSameBytesTwice)
{
    const SampleOptions options{.textureSize = 128, .takesPerKind = 1};
    writeSample(m_folder / "one", options);
    writeSample(m_folder / "two", options);
    const auto one = contents(m_folder / "one");
    const auto two = contents(m_folder / "two");
    ASSERT_EQ(one.size(), two.size());
    for (const auto& [name, bytes] : one)
        EXPECT_TRUE(two.contains(name) && two.at(name) == bytes) << name;
}

TEST_F(WriteSample, leavesNoProjectWhenCancelled)
{
    CancelToken token;
    const Progress progress(token, [&token](double fraction) {
        if (fraction > 0.7)
            token.cancel();
    });
    EXPECT_THROW(writeSample(m_folder, {.textureSize = 128, .takesPerKind = 1}, progress), Error);
    EXPECT_FALSE(fs::exists(m_folder / "sample.quadrille"));
}

} // namespace
} // namespace quadrille
