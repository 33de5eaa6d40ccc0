// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/ratebeside.h"
#include "tests/model/onejoint.h"
#include "tests/model/project/testproject.h"

using namespace quadrille;
using namespace quadrille::test;
using Evidence = RateBeside::Evidence;

namespace {

class RateOfATake : public ::testing::Test
{
protected:
    void writeMotion(const std::string& name, int frames, const char* frameTime) const
    {
        folder.write(name, test::oneJointBvh(frames, frameTime));
    }
    std::optional<RateBeside> rate(const std::string& name = "jog.pc2", std::int64_t frames = 40) const
    {
        return rateBeside(folder / name, frames);
    }
    void expect(double fps, Evidence evidence, const std::string& file,
                const std::optional<RateBeside>& found) const
    {
        ASSERT_TRUE(found);
        EXPECT_DOUBLE_EQ(found->fps, fps);
        EXPECT_EQ(found->evidence, evidence);
        EXPECT_EQ(found->file, folder / file);
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(RateOfATake, IsUnknownWhereNothingSaysIt)
{
    EXPECT_FALSE(rate());
    folder.write("readme.txt", "Captured with love, 40 frames.");
    folder.write("jog.json", "{ \"fps\": \"fast\" }");
    folder.write("broken.json", "{ \"fps\": ");
    folder.write("other.bvh", "no motion");
    EXPECT_FALSE(rate());
}

TEST_F(RateOfATake, IsThatOfTheMotionOfItsName)
{
    writeMotion("jog.bvh", 40, "0.0333333");
    writeMotion("kick.bvh", 9, "0.02");
    folder.write("readme.txt", "All takes have 60 fps.");
    expect(30, Evidence::OwnMotion, "jog.bvh", rate());
    EXPECT_EQ(rate()->toString(), "30 fps, as in jog.bvh beside it");
}

TEST_F(RateOfATake, IsAPartOfAFinerMotion)
{
    writeMotion("jog.bvh", 160, "0.00833333");
    expect(30, Evidence::OwnMotion, "jog.bvh", rate());
    // A motion of another length says nothing of this take, but its rate may be that of all motions.
    writeMotion("jog.bvh", 100, "0.04");
    expect(25, Evidence::OtherMotions, "jog.bvh", rate());
}

TEST_F(RateOfATake, IsThatOfOtherMotionsWhichAgree)
{
    writeMotion("kick.bvh", 9, "0.02");
    writeMotion("run.bvh", 12, "0.02");
    expect(50, Evidence::OtherMotions, "kick.bvh", rate());
    writeMotion("walk.bvh", 12, "0.04");
    EXPECT_FALSE(rate());
}

TEST_F(RateOfATake, IsInItsNotesOrThoseOfItsFolder)
{
    folder.write("README.md", "# Takes\n\nThe *takes* have 29.97 fps.");
    expect(29.97, Evidence::Notes, "README.md", rate());
    folder.write("takes.json", "{ \"camera\": { \"frame_rate\": 24 } }");
    EXPECT_FALSE(rate()); // the two contradict each other
    folder.write("jog.json", "{ \"frame_time\": 0.01 }");
    expect(100, Evidence::Notes, "jog.json", rate());
    // The notes of another take say nothing of this one.
    folder.write("kick.pc2", "a take");
    folder.write("kick.json", "{ \"fps\": 12 }");
    expect(100, Evidence::Notes, "jog.json", rate());
}

TEST_F(RateOfATake, OfASeriesLiesInItsFolderOrBesideIt)
{
    folder.write("takes/jog/f_0001.obj", "v 0 0 0");
    writeMotion("takes/jog.bvh", 40, "0.02");
    expect(50, Evidence::OwnMotion, "takes/jog.bvh", rate("takes/jog"));
    expect(50, Evidence::OwnMotion, "takes/jog.bvh", rate("takes/jog/f_####.obj"));
    writeMotion("takes/jog/f.bvh", 40, "0.01");
    expect(100, Evidence::OwnMotion, "takes/jog/f.bvh", rate("takes/jog/f_####.obj"));
    folder.write("takes/run/f_0001.obj", "v 0 0 0");
    folder.write("takes/README.txt", "Captured at 59.94 frames per second.");
    expect(59.94, Evidence::Notes, "takes/README.txt", rate("takes/run/f_####.obj"));
}
