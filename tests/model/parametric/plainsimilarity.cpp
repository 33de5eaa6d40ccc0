// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/parametric/plainsimilarity.h"

#include <cmath>

namespace quadrille::test {

namespace {

std::vector<Vec3d> plainPose(const MotionSpace& space, std::size_t frame, std::size_t node)
{
    const std::size_t vertices = space.vertexCount();
    std::vector<Vec3d> pose(vertices, Vec3d::Zero());
    for (const BlendShare& share : space.weights.nodes()[node].shares)
        for (std::size_t v = 0; v < vertices; ++v)
            pose[v] += share.share * space.takes[share.take].poses[frame * vertices + v].cast<double>();
    if (node >= space.takes.size()) {
        const SpaceReference& reference = space.references[node - space.takes.size()];
        for (std::uint32_t d = reference.starts[frame]; d < reference.starts[frame + 1]; ++d)
            for (std::size_t c = 0; c < 3; ++c)
                pose[reference.vertices[d]][static_cast<Eigen::Index>(c)] +=
                    static_cast<double>(reference.unit) * reference.displacements[d][c];
    }
    return pose;
}

} // namespace

PlainState plainState(const MotionSpace& space, std::size_t frame, std::size_t node)
{
    const std::size_t last = space.frameCount() - 1;
    PlainState state{.pose = plainPose(space, frame, node)};
    state.velocity.assign(state.pose.size(), Vec3d::Zero());
    const bool isEnd = !space.isCyclic && frame == last;
    if (isEnd && frame == 0)
        return state;
    const std::size_t from = isEnd ? frame - 1 : frame;
    GroundMotion step;
    double seconds = 0;
    for (const BlendShare& share : space.weights.nodes()[node].shares) {
        step.turn += share.share * space.takes[share.take].steps[from].turn;
        step.shift += share.share * space.takes[share.take].steps[from].shift;
        seconds += share.share * space.takes[share.take].seconds[from];
    }
    const Ground ground(space.up);
    const std::vector<Vec3d> other = plainPose(space, isEnd ? from : frame == last ? 0 : frame + 1, node);
    for (std::size_t v = 0; v < state.pose.size(); ++v) {
        state.velocity[v] = isEnd ? Vec3d(state.pose[v] - step.inverse()(other[v], ground))
                                  : Vec3d(step(other[v], ground) - state.pose[v]);
        state.velocity[v] /= seconds * space.fps;
    }
    return state;
}

double plainDistance(const PlainState& source, const PlainState& target, double velocityWeight)
{
    double poses = 0;
    double velocities = 0;
    for (std::size_t v = 0; v < source.pose.size(); ++v) {
        poses += (source.pose[v] - target.pose[v]).squaredNorm();
        velocities += (source.velocity[v] - target.velocity[v]).squaredNorm();
    }
    return (std::sqrt(poses) + velocityWeight * std::sqrt(velocities)) /
           static_cast<double>(source.pose.size());
}

std::vector<float> plainSimilarities(const MotionSpace& source, const MotionSpace& target,
                                     double velocityWeight)
{
    const auto statesOf = [](const MotionSpace& space) {
        std::vector<PlainState> states;
        for (std::size_t f = 0; f < space.frameCount(); ++f)
            for (std::size_t n = 0; n < space.weights.nodes().size(); ++n)
                states.push_back(plainState(space, f, n));
        return states;
    };
    const std::vector<PlainState> from = statesOf(source);
    const std::vector<PlainState> to = statesOf(target);
    const std::size_t sourceNodes = source.weights.nodes().size();
    const std::size_t targetNodes = target.weights.nodes().size();
    std::vector<float> distances;
    for (std::size_t s = 0; s < source.frameCount(); ++s)
        for (std::size_t t = 0; t < target.frameCount(); ++t)
            for (std::size_t i = 0; i < sourceNodes; ++i)
                for (std::size_t j = 0; j < targetNodes; ++j)
                    distances.push_back(static_cast<float>(
                        plainDistance(from[s * sourceNodes + i], to[t * targetNodes + j], velocityWeight)));
    return distances;
}

} // namespace quadrille::test
