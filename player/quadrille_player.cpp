// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "player/quadrille_player.h"

#include "model/live/bakedplayer.h"
#include "model/live/bakedstate.h"
#include "model/parametric/measureunit.h"
#include "model/sequence/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

using namespace quadrille;

struct QuadrillePlayer
{
    explicit QuadrillePlayer(const char* path)
        : baked(readBakedPlayer(path))
        , player(baked.graph, baked.settings, baked.start)
        , states(player)
        , pose(baked.graph->vertexCount())
    {
        wanted.space = baked.start.space;
        wanted.parameters = baked.start.parameters;
        const Topology& topology = baked.graph->topology();
        for (const Triangle& triangle : topology.triangles()) {
            for (const VertexIndex vertex : triangle)
                triangles.push_back(vertex.value);
        }
        for (const auto& corners : topology.data().triangleUvs) {
            for (const std::uint32_t corner : corners) {
                const Vec2f& uv = topology.data().uvs[corner];
                textureCoordinates.insert(textureCoordinates.end(), {uv.x(), uv.y()});
            }
        }
    }

    bool has(std::uint32_t space) const { return space < baked.graph->spaces.size(); }
    bool makesSense(const QuadrilleInput& input) const
    {
        return has(input.space) &&
               std::ranges::all_of(input.parameters, [](double value) { return std::isfinite(value); });
    }

    BakedPlayer baked;
    LivePlayer player;
    LiveStateBytes states;
    LiveInput wanted;
    std::vector<Vec3f> pose;
    std::vector<std::uint32_t> triangles;
    std::vector<float> textureCoordinates;
    PictureBytes picture; ///< that was asked for last
};

namespace {

LiveInput inputOf(const QuadrilleInput& input)
{
    LiveInput own;
    own.space = input.space;
    std::ranges::copy(input.parameters, own.parameters.begin());
    own.isResponsive = input.responsive != 0;
    return own;
}

QuadrilleFrame frameOf(const QuadrillePlayer& player, const LiveProvenance& provenance)
{
    const BakedFrame& frame = player.baked.frameOf(provenance);
    return {frame.sequence.c_str(), frame.frame, frame.isMirrored ? 1U : 0U, frame.picture, provenance.share};
}

void tell(const char* sentence, char* error, std::size_t size)
{
    if (size == 0)
        return;
    const std::size_t length = std::min(std::strlen(sentence), size - 1);
    std::memcpy(error, sentence, length);
    error[length] = 0;
}

} // namespace

QuadrillePlayer* quadrille_player_open(const char* path, char* error, size_t errorSize)
{
    try {
        return std::make_unique<QuadrillePlayer>(path).release();
    } catch (const std::exception& problem) {
        tell(problem.what(), error, errorSize);
        return nullptr;
    }
}

void quadrille_player_close(QuadrillePlayer* player)
{
    const std::unique_ptr<QuadrillePlayer> owned(player);
}

uint32_t quadrille_player_space_count(const QuadrillePlayer* player)
{
    return static_cast<std::uint32_t>(player->baked.graph->spaces.size());
}

const char* quadrille_player_space_name(const QuadrillePlayer* player, uint32_t space)
{
    return player->has(space) ? player->baked.graph->spaces[space]->name.c_str() : nullptr;
}

int quadrille_player_space_is_cyclic(const QuadrillePlayer* player, uint32_t space)
{
    return player->has(space) && player->baked.graph->spaces[space]->isCyclic ? 1 : 0;
}

uint32_t quadrille_player_parameter_count(const QuadrillePlayer* player, uint32_t space)
{
    return player->has(space)
               ? static_cast<std::uint32_t>(player->baked.graph->spaces[space]->parameters.size())
               : 0;
}

int quadrille_player_parameter(const QuadrillePlayer* player, uint32_t space, uint32_t parameter,
                               QuadrilleParameter* out)
{
    if (parameter >= quadrille_player_parameter_count(player, space))
        return 0;
    const MotionSpace& played = *player->baked.graph->spaces[space];
    const SpaceParameter& found = played.parameters[parameter];
    *out = {found.name.c_str(), unitOf(found.measure), played.map.least[parameter],
            played.map.greatest[parameter]};
    return 1;
}

int quadrille_player_up_axis(const QuadrillePlayer* player)
{
    return static_cast<int>(player->baked.graph->up());
}

double quadrille_player_tick_seconds(const QuadrillePlayer* player)
{
    return player->player.tickSeconds();
}

uint32_t quadrille_player_ticks_per_frame(const QuadrillePlayer* player)
{
    return static_cast<std::uint32_t>(player->baked.settings.ticksPerFrame);
}

uint32_t quadrille_player_vertex_count(const QuadrillePlayer* player)
{
    return static_cast<std::uint32_t>(player->pose.size());
}

uint32_t quadrille_player_triangle_count(const QuadrillePlayer* player)
{
    return static_cast<std::uint32_t>(player->triangles.size() / 3);
}

const uint32_t* quadrille_player_triangles(const QuadrillePlayer* player)
{
    return player->triangles.data();
}

const float* quadrille_player_texture_coordinates(const QuadrillePlayer* player)
{
    return player->textureCoordinates.empty() ? nullptr : player->textureCoordinates.data();
}

int quadrille_player_start(QuadrillePlayer* player, const QuadrilleInput* input, const QuadrilleRoot* root)
{
    const bool isSomewhere =
        std::isfinite(root->turn) && std::isfinite(root->shift[0]) && std::isfinite(root->shift[1]);
    if (!isSomewhere || !player->makesSense(*input))
        return 0;
    player->wanted = inputOf(*input);
    const LiveStart start{.space = player->wanted.space,
                          .parameters = player->wanted.parameters,
                          .root = {root->turn, {root->shift[0], root->shift[1]}}};
    player->player.start(start);
    return 1;
}

void quadrille_player_tick(QuadrillePlayer* player, const QuadrilleInput* input)
{
    if (player->makesSense(*input))
        player->wanted = inputOf(*input);
    player->player.tick(player->wanted);
}

int64_t quadrille_player_tick_count(const QuadrillePlayer* player)
{
    return player->player.state().tick;
}

uint32_t quadrille_player_space(const QuadrillePlayer* player)
{
    return static_cast<std::uint32_t>(player->player.state().track.space);
}

void quadrille_player_pose(QuadrillePlayer* player, float* positions)
{
    player->player.pose(player->pose);
    for (const Vec3f& position : player->pose)
        positions = std::copy_n(position.data(), 3, positions);
}

void quadrille_player_surface(QuadrillePlayer* player, float* positions, float* normals)
{
    quadrille_player_pose(player, positions);
    using Normals = Eigen::Map<Eigen::Matrix3Xf>;
    Normals all(normals, 3, static_cast<Eigen::Index>(player->pose.size()));
    all.setZero();
    const std::vector<Vec3f>& pose = player->pose;
    for (std::size_t t = 0; t < player->triangles.size(); t += 3) {
        const std::uint32_t* corners = &player->triangles[t];
        const Vec3f& first = pose[corners[0]];
        const Vec3f across = (pose[corners[1]] - first).cross(pose[corners[2]] - first);
        for (int corner = 0; corner < 3; ++corner)
            all.col(corners[corner]) += across;
    }
    for (Eigen::Index v = 0; v < all.cols(); ++v)
        all.col(v).stableNormalize();
}

void quadrille_player_root(const QuadrillePlayer* player, QuadrilleRoot* out)
{
    const GroundMotion root = player->player.root();
    *out = {root.turn, {root.shift.x(), root.shift.y()}};
}

void quadrille_player_frame(const QuadrillePlayer* player, QuadrilleFrame* out)
{
    *out = frameOf(*player, player->player.provenance());
}

double quadrille_player_look(const QuadrillePlayer* player, QuadrilleFrame* first, QuadrilleFrame* second)
{
    const LiveLook look = player->player.look();
    *first = frameOf(*player, look.first);
    *second = frameOf(*player, look.second);
    return look.weight;
}

int quadrille_player_transition(const QuadrillePlayer* player, QuadrilleTransition* out)
{
    const LiveDecision& decision = player->player.decision();
    if (decision.count == 0)
        return 0;
    const double frames = decision.latencyFrames(player->baked.settings.ticksPerFrame);
    *out = {decision.tick, static_cast<std::uint32_t>(decision.source),
            static_cast<std::uint32_t>(decision.target), frames / player->baked.graph->fps,
            decision.choices[0].dissimilarity};
    return 1;
}

const void* quadrille_player_texture(QuadrillePlayer* player, int32_t texture, size_t* size)
{
    *size = 0;
    if (texture < 0 || static_cast<std::size_t>(texture) >= player->baked.pictureCount)
        return nullptr;
    try {
        player->picture = player->baked.picture(static_cast<std::size_t>(texture));
    } catch (const std::exception&) {
        return nullptr;
    }
    *size = player->picture.size();
    return player->picture.data();
}

size_t quadrille_player_state_size(const QuadrillePlayer* player)
{
    return player->states.size();
}

void quadrille_player_save(QuadrillePlayer* player, void* state)
{
    player->states.write(player->player.state(), state);
}

int quadrille_player_restore(QuadrillePlayer* player, const void* state)
{
    const auto read = player->states.read(state);
    if (!read)
        return 0;
    player->player.restore(*read);
    return 1;
}

int64_t quadrille_player_recorded_ticks(const QuadrillePlayer* player)
{
    return static_cast<std::int64_t>(player->baked.inputs.size());
}

int64_t quadrille_player_recorded_from(const QuadrillePlayer* player)
{
    return player->baked.from;
}

int quadrille_player_recorded(const QuadrillePlayer* player, int64_t tick, QuadrilleInput* out)
{
    if (tick < 0 || tick >= quadrille_player_recorded_ticks(player))
        return 0;
    const LiveInput& input = player->baked.inputs[static_cast<std::size_t>(tick)];
    *out = {static_cast<std::uint32_t>(input.space), input.isResponsive ? 1U : 0U, {}};
    std::ranges::copy(input.parameters, out->parameters);
    return 1;
}
