// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/bakedplayer.h"
#include "player/quadrille_player.h"
#include "tests/model/core/temporaryfolder.h"
#include "tests/model/live/livefixture.h"
#include "tests/model/parametric/countallocations.h"

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <gmock/gmock.h>

namespace quadrille {
namespace {

using ::testing::HasSubstr;

struct ClosePlayer
{
    void operator()(QuadrillePlayer* player) const { quadrille_player_close(player); }
};
using PlayerPointer = std::unique_ptr<QuadrillePlayer, ClosePlayer>;

/// A performance that goes to all spaces, as a file.
class PlayerFile : public ::testing::Test
{
protected:
    PlayerFile()
    {
        baked.graph = test::swingingGraph();
        baked.start = {.space = test::walking, .parameters = {1}, .root = {0.3, {2, -1}}};
        const std::array<double, 3> values{1.5, -30, 1};
        for (std::size_t t = 0; t < 360; ++t)
            baked.inputs.push_back(
                {.space = t / 120, .parameters = {values[t / 120]}, .isResponsive = t > 200});
        baked.from = 21;
        for (const auto& space : baked.graph->spaces)
            baked.frames.emplace_back(
                space->takes.size(),
                std::vector<BakedFrame>(space->frameCount(), {.sequence = space->name, .picture = 0}));
        baked.pictureCount = 1;
        baked.picture = [](std::size_t) { return PictureBytes(5, std::byte{7}); };
        writeBakedPlayer(baked, file);
    }

    PlayerPointer open() const
    {
        std::array<char, 500> error{};
        PlayerPointer player(quadrille_player_open(file.c_str(), error.data(), error.size()));
        EXPECT_NE(player, nullptr) << error.data();
        return player;
    }
    /// What its library gives at each tick of the recording.
    std::vector<float> played(QuadrillePlayer* player) const
    {
        std::vector<float> all;
        std::vector<float> pose(3 * std::size_t{quadrille_player_vertex_count(player)});
        const auto take = [&] {
            quadrille_player_pose(player, pose.data());
            all.insert(all.end(), pose.begin(), pose.end());
        };
        take();
        QuadrilleInput input{};
        for (std::int64_t t = 0; quadrille_player_recorded(player, t, &input) != 0; ++t) {
            quadrille_player_tick(player, &input);
            take();
        }
        return all;
    }
    /// What the editor shows: of ticks from one on, each of so many.
    std::vector<float> shown(std::int64_t from, std::int64_t each) const
    {
        LivePlayer player(baked.graph, baked.settings, baked.start);
        std::vector<float> all;
        std::vector<Vec3f> pose(baked.graph->vertexCount());
        perform(player, baked.inputs, [&](LivePlayer& own) {
            const std::int64_t tick = own.state().tick - from;
            if (tick < 0 || tick % each != 0)
                return;
            own.pose(pose);
            for (const Vec3f& point : pose)
                all.insert(all.end(), point.data(), point.data() + 3);
        });
        return all;
    }

    test::TemporaryFolder folder;
    std::filesystem::path file = folder / "p.qplayer";
    BakedPlayer baked;
};

} // namespace

TEST_F(PlayerFile, PlaysAsTheEditorDoes)
{
    const PlayerPointer player = open();
    EXPECT_EQ(played(player.get()), shown(0, 1));
    EXPECT_EQ(quadrille_player_tick_count(player.get()), 360);
    QuadrilleTransition last{};
    ASSERT_NE(quadrille_player_transition(player.get(), &last), 0);
    EXPECT_EQ(last.from, test::turning);
    EXPECT_EQ(last.to, test::jumping);
    EXPECT_GT(last.latency, 0);
}

TEST_F(PlayerFile, IsPlayedByAProgramInC)
{
    const std::filesystem::path out = folder / "out.bin";
    const std::string command =
        std::string(QUADRILLE_PERFORM) + " '" + file.string() + "' '" + out.string() + "' > /dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const std::vector<float> frames = shown(baked.from, baked.settings.ticksPerFrame);
    std::ifstream in(out, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    ASSERT_EQ(bytes.size(), frames.size() * sizeof(float));
    EXPECT_EQ(std::memcmp(bytes.data(), frames.data(), bytes.size()), 0);
    EXPECT_NE(std::system((std::string(QUADRILLE_PERFORM) + " /none.qplayer --list 2> /dev/null").c_str()),
              0);
}

TEST_F(PlayerFile, SaysWhatThereIs)
{
    const PlayerPointer player = open();
    ASSERT_EQ(quadrille_player_space_count(player.get()), 3U);
    EXPECT_STREQ(quadrille_player_space_name(player.get(), 1), "turn");
    EXPECT_EQ(quadrille_player_space_name(player.get(), 3), nullptr);
    EXPECT_NE(quadrille_player_space_is_cyclic(player.get(), 0), 0);
    EXPECT_EQ(quadrille_player_space_is_cyclic(player.get(), 2), 0);
    QuadrilleParameter parameter{};
    ASSERT_NE(quadrille_player_parameter(player.get(), 1, 0, &parameter), 0);
    EXPECT_STREQ(parameter.name, "turn");
    EXPECT_STREQ(parameter.unit, "deg/s");
    EXPECT_EQ(parameter.least, -60);
    EXPECT_EQ(parameter.greatest, 60);
    EXPECT_EQ(quadrille_player_parameter(player.get(), 1, 1, &parameter), 0);
    EXPECT_EQ(quadrille_player_parameter(player.get(), 9, 0, &parameter), 0);
    EXPECT_EQ(quadrille_player_up_axis(player.get()), 1);
    EXPECT_DOUBLE_EQ(quadrille_player_tick_seconds(player.get()), 1.0 / 60);
    const auto& triangles = baked.graph->topology().triangles();
    ASSERT_EQ(quadrille_player_triangle_count(player.get()), triangles.size());
    EXPECT_EQ(quadrille_player_triangles(player.get())[4], triangles[1][1].value);
    QuadrilleFrame frame{};
    quadrille_player_frame(player.get(), &frame);
    EXPECT_STREQ(frame.sequence, "walk");
    QuadrilleFrame other{};
    EXPECT_LE(quadrille_player_look(player.get(), &frame, &other), 0.5);
    EXPECT_STREQ(frame.sequence, "walk");
    EXPECT_LE(other.share, frame.share);
    std::size_t size = 0;
    const void* picture = quadrille_player_texture(player.get(), frame.texture, &size);
    ASSERT_EQ(size, 5U);
    EXPECT_EQ(static_cast<const char*>(picture)[4], 7);
    EXPECT_EQ(quadrille_player_texture(player.get(), 1, &size), nullptr);
    EXPECT_EQ(quadrille_player_texture(player.get(), -1, &size), nullptr);
    EXPECT_EQ(size, 0U);
}

TEST_F(PlayerFile, GoesBackAndBeginsAnew)
{
    const PlayerPointer player = open();
    std::vector<char> state(quadrille_player_state_size(player.get()));
    const std::vector<float> first = played(player.get());
    const QuadrilleInput start{test::walking, 0, {1, 0, 0}};
    const QuadrilleRoot root{0.3, {2, -1}};
    ASSERT_NE(quadrille_player_start(player.get(), &start, &root), 0);
    QuadrilleRoot there{};
    quadrille_player_root(player.get(), &there);
    EXPECT_EQ(there.shift[1], -1);
    EXPECT_EQ(played(player.get()), first);
    quadrille_player_start(player.get(), &start, &root);
    quadrille_player_save(player.get(), state.data());
    played(player.get());
    ASSERT_NE(quadrille_player_restore(player.get(), state.data()), 0);
    EXPECT_EQ(played(player.get()), first);
    std::memset(state.data(), 255, state.size());
    EXPECT_EQ(quadrille_player_restore(player.get(), state.data()), 0);
    EXPECT_EQ(quadrille_player_tick_count(player.get()), 360);
    const QuadrilleInput nowhere{7, 0, {}};
    EXPECT_EQ(quadrille_player_start(player.get(), &nowhere, &root), 0);
}

TEST_F(PlayerFile, LeavesOutInputsThatMakeNoSense)
{
    const PlayerPointer player = open();
    const PlayerPointer other = open();
    const QuadrilleInput wanted{test::turning, 0, {40, 0, 0}};
    const QuadrilleInput nonsense{test::turning, 0, {std::nan(""), 0, 0}};
    const QuadrilleInput nowhere{99, 0, {}};
    std::vector<float> a(3 * std::size_t{quadrille_player_vertex_count(player.get())});
    std::vector<float> b = a;
    for (int t = 0; t < 90; ++t) {
        quadrille_player_tick(player.get(), &wanted);
        quadrille_player_tick(other.get(), t == 0 ? &wanted : t % 2 == 0 ? &nonsense : &nowhere);
        quadrille_player_pose(player.get(), a.data());
        quadrille_player_pose(other.get(), b.data());
        ASSERT_EQ(a, b);
    }
}

TEST_F(PlayerFile, AllocatesNothingWhileItPlays)
{
    const PlayerPointer player = open();
    std::vector<float> pose(3 * std::size_t{quadrille_player_vertex_count(player.get())});
    std::vector<float> normals(pose.size());
    std::vector<char> state(quadrille_player_state_size(player.get()));
    quadrille_player_save(player.get(), state.data());
    const std::size_t before = test::allocationCount();
    QuadrilleInput input{};
    QuadrilleFrame frame{};
    QuadrilleFrame other{};
    for (std::int64_t t = 0; quadrille_player_recorded(player.get(), t, &input) != 0; ++t) {
        quadrille_player_tick(player.get(), &input);
        quadrille_player_surface(player.get(), pose.data(), normals.data());
        quadrille_player_frame(player.get(), &frame);
        quadrille_player_look(player.get(), &frame, &other);
        quadrille_player_save(player.get(), state.data());
        quadrille_player_restore(player.get(), state.data());
    }
    EXPECT_EQ(test::allocationCount(), before);
    for (std::size_t v = 0; v < normals.size(); v += 3)
        EXPECT_NEAR(std::hypot(normals[v], normals[v + 1], normals[v + 2]), 1, 1e-5);
}

TEST_F(PlayerFile, SaysWhatIsWrongWithAFile)
{
    std::array<char, 300> error{};
    EXPECT_EQ(quadrille_player_open((folder / "none").c_str(), error.data(), error.size()), nullptr);
    EXPECT_THAT(error.data(), HasSubstr("none"));
    std::array<char, 6> few{};
    EXPECT_EQ(quadrille_player_open((folder / "none").c_str(), few.data(), few.size()), nullptr);
    EXPECT_EQ(std::strlen(few.data()), 5U);
    EXPECT_EQ(quadrille_player_open((folder / "none").c_str(), nullptr, 0), nullptr);
    quadrille_player_close(nullptr);
}

} // namespace quadrille
