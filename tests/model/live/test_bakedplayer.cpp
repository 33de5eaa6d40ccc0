// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "livefixture.h"
#include "model/live/bakedparts.h"
#include "model/live/bakedplayer.h"
#include "model/live/bakedstate.h"
#include "tests/model/core/temporaryfolder.h"

#include <fstream>
#include <gmock/gmock.h>

namespace quadrille {
namespace {

using test::swingingGraph;
using ::testing::HasSubstr;

PictureBytes pictureOf(std::size_t number)
{
    return PictureBytes(10 + number, static_cast<std::byte>(number));
}

BakedPlayer bakedPlayer()
{
    BakedPlayer player;
    player.graph = swingingGraph();
    player.settings.fadeSeconds = 0.25;
    player.start = {.space = test::turning, .parameters = {20}, .root = {0.5, {1, 2}}};
    for (int t = 0; t < 300; ++t)
        player.inputs.push_back({.space = static_cast<std::size_t>(t / 100),
                                 .parameters = {0.5 + 0.01 * t},
                                 .isResponsive = t % 2 == 0});
    player.from = 7;
    player.metresPerUnit = 0.01;
    for (const auto& space : player.graph->spaces) {
        auto& takes = player.frames.emplace_back();
        for (std::size_t t = 0; t < space->takes.size(); ++t) {
            for (std::size_t f = 0; f < space->frameCount(); ++f) {
                if (f == 0)
                    takes.emplace_back();
                takes.back().push_back({.sequence = space->name + std::to_string(t),
                                        .frame = static_cast<std::int64_t>(2 * f),
                                        .isMirrored = t == 1,
                                        .picture = static_cast<std::int32_t>(f % 3) - 1});
            }
        }
    }
    player.pictureCount = 2;
    player.picture = pictureOf;
    return player;
}

/// What it plays: all positions of all ticks.
std::vector<Vec3f> played(const BakedPlayer& baked)
{
    LivePlayer player(baked.graph, baked.settings, baked.start);
    std::vector<Vec3f> poses;
    std::vector<Vec3f> pose(baked.graph->vertexCount());
    perform(player, baked.inputs, [&](LivePlayer& each) {
        each.pose(pose);
        poses.insert(poses.end(), pose.begin(), pose.end());
    });
    return poses;
}

class BakedFile : public ::testing::Test
{
protected:
    BakedFile() { writeBakedPlayer(written, file); }

    std::string content() const
    {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    /// What reading says of other content; empty where it is taken.
    std::string complaint(const std::string& bytes) const
    {
        const std::filesystem::path other = folder / "other.qplayer";
        std::ofstream(other, std::ios::binary) << bytes;
        try {
            readBakedPlayer(other);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }

    test::TemporaryFolder folder;
    std::filesystem::path file = folder / "p.qplayer";
    BakedPlayer written = bakedPlayer();
};

} // namespace

TEST_F(BakedFile, PlaysWhatWasWritten)
{
    const BakedPlayer read = readBakedPlayer(file);
    EXPECT_EQ(read.settings.fadeSeconds, 0.25);
    EXPECT_EQ(read.settings.search.depth, written.settings.search.depth);
    EXPECT_EQ(read.settings.latestArrival, written.settings.latestArrival);
    EXPECT_EQ(read.start, written.start);
    EXPECT_EQ(read.inputs, written.inputs);
    EXPECT_EQ(read.from, 7);
    EXPECT_EQ(read.metresPerUnit, 0.01);
    EXPECT_EQ(read.frames, written.frames);
    ASSERT_EQ(read.pictureCount, 2U);
    EXPECT_EQ(read.picture(1), pictureOf(1));
    EXPECT_EQ(read.graph->topology().data(), written.graph->topology().data());
    EXPECT_EQ(read.graph->spaces[2]->name, "jump");
    EXPECT_EQ(played(read), played(written));
}

TEST_F(BakedFile, IsTheSameBytesAgain)
{
    const std::string first = content();
    writeBakedPlayer(readBakedPlayer(file), folder / "again.qplayer");
    file = folder / "again.qplayer";
    EXPECT_EQ(content(), first);
}

TEST_F(BakedFile, IsRefusedWhereItIsDamaged)
{
    const std::string good = content();
    EXPECT_EQ(complaint(good), "");
    std::string bytes = good;
    bytes[0] = 'X';
    EXPECT_THAT(complaint(bytes), HasSubstr("does not begin as a player does"));
    bytes = good;
    bytes[8] = 3;
    EXPECT_THAT(complaint(bytes), HasSubstr("version 3"));
    bytes = good;
    bytes[1000] = static_cast<char>(bytes[1000] ^ 1);
    EXPECT_THAT(complaint(bytes), HasSubstr("not those that were written"));
    EXPECT_THAT(complaint(good.substr(0, 20)), HasSubstr("too short"));
    EXPECT_THAT(complaint(good.substr(0, good.size() / 2)), HasSubstr("ends too early"));
    EXPECT_THAT(complaint(good.substr(0, good.size() - 1)), HasSubstr("picture"));
    EXPECT_THAT(complaint(good.substr(0, good.size() - 20)), HasSubstr("picture"));
}

/// Whatever is in the data, they are refused, or can be played.
TEST(BakedParts, AreTakenOnlyWhereTheyFit)
{
    const BakedPlayer whole = bakedPlayer();
    BakedWriter writer;
    bake(writer, whole);
    const std::string& good = writer.bytes();
    const std::filesystem::path noFile;
    Random random(11);
    int refused = 0;
    constexpr int trials = 400;
    for (int trial = 0; trial < trials; ++trial) {
        std::string bytes = good;
        const auto at = static_cast<std::size_t>(random.unit() * static_cast<double>(bytes.size()));
        // Most of the data are positions: half of the trials are in the others, at the end.
        const std::size_t place = trial % 2 == 0 ? at : bytes.size() - 1 - at % 4000;
        bytes[place] = static_cast<char>(random.between(-128, 128));
        if (trial % 5 == 0)
            bytes.resize(place);
        BakedPlayer read;
        BakedReader reader(std::as_bytes(std::span(bytes)), noFile, 0);
        try {
            bake(reader, read);
            read.inputs.resize(std::min<std::size_t>(read.inputs.size(), 30));
            played(read);
        } catch (const Error& error) {
            EXPECT_TRUE(error.code() == ErrorCode::FileSyntax || error.code() == ErrorCode::BadArgument);
            ++refused;
        }
    }
    EXPECT_GE(refused, trials / 5);
    EXPECT_LT(refused, trials);
}

TEST(LiveStates, GoThroughBytes)
{
    const BakedPlayer baked = bakedPlayer();
    LivePlayer player(baked.graph, baked.settings, baked.start);
    LiveStateBytes states(player);
    std::string bytes(states.size(), '\0');
    for (const LiveInput& input : baked.inputs) {
        player.tick(input);
        states.write(player.state(), bytes.data());
        ASSERT_EQ(states.read(bytes.data()), player.state());
    }
    Random random(3);
    for (int trial = 0; trial < 1000; ++trial) {
        std::string other = bytes;
        other[static_cast<std::size_t>(random.unit() * static_cast<double>(other.size()))] =
            static_cast<char>(random.between(-128, 128));
        if (const auto state = states.read(other.data())) {
            player.restore(*state);
            for (int t = 0; t < 5; ++t)
                player.tick(baked.inputs[static_cast<std::size_t>(t)]);
        }
    }
}

} // namespace quadrille
