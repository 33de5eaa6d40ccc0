// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/hybridblend.h"

#include "model/parametric/blendkernels.h"
#include "model/variation/resampling.h"

#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// The four frames around a phase; a cycle goes on with its first frames.
FramesAround framesAroundPhase(const MotionSpace& space, double phase)
{
    const std::size_t count = space.frameCount();
    if (!space.isCyclic)
        return framesAround(phase, count);
    const double whole = std::floor(phase);
    // In the middle of four frames there are all that a cubic asks for.
    FramesAround around = framesAround(1 + phase - whole, 4);
    const auto frames = static_cast<std::ptrdiff_t>(count);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::ptrdiff_t frame =
            static_cast<std::ptrdiff_t>(whole) - 1 + static_cast<std::ptrdiff_t>(around.frames[i]);
        around.frames[i] = static_cast<std::size_t>((frame % frames + frames) % frames);
    }
    return around;
}

const SpaceReference* referenceOf(const MotionSpace& space, int node)
{
    const auto index = static_cast<std::size_t>(node);
    return index < space.takes.size() ? nullptr : &space.references[index - space.takes.size()];
}

/// Calls a function with each take that partakes and its share in a node's weight.
template <typename Use>
void forShares(const MotionSpace& space, const NodeWeights& weights, Use use)
{
    for (std::size_t n = 0; n < static_cast<std::size_t>(weights.count); ++n) {
        for (const BlendShare& share :
             space.weights.nodes()[static_cast<std::size_t>(weights.nodes[n])].shares)
            use(share.take, weights.weights[n] * share.share);
    }
}

void addDisplacements(const SpaceReference& reference, std::size_t frame, float weight, MutablePositions out)
{
    if (weight == 0)
        return;
    const float unit = weight * reference.unit;
    for (std::uint32_t i = reference.starts[frame]; i < reference.starts[frame + 1]; ++i) {
        const auto& displacement = reference.displacements[i];
        out[reference.vertices[i]] += unit * Vec3f(displacement[0], displacement[1], displacement[2]);
    }
}

} // namespace

void blendedPose(const MotionSpace& space, double phase, const NodeWeights& weights, MutablePositions out)
{
    assert(out.size() == space.vertexCount());
    const FramesAround around = framesAroundPhase(space, phase);
    std::array<double, WeightSpace::mostTakes> shares{};
    forShares(space, weights, [&](std::size_t take, double share) { shares[take] += share; });
    std::array<WeightedPose, 4 * WeightSpace::mostTakes> poses;
    std::size_t count = 0;
    for (std::size_t t = 0; t < space.takes.size(); ++t) {
        for (std::size_t i = 0; i < 4; ++i) {
            const auto weight = static_cast<float>(shares[t] * around.weights[i]);
            if (weight != 0)
                poses[count++] = {space.takes[t].pose(around.frames[i]).data()->data(), weight};
        }
    }
    addPoses(std::span(poses).first(count), std::span(out.data()->data(), 3 * out.size()));
    for (std::size_t n = 0; n < static_cast<std::size_t>(weights.count); ++n) {
        const SpaceReference* reference = referenceOf(space, weights.nodes[n]);
        if (!reference)
            continue;
        addDisplacements(*reference, around.before(),
                         static_cast<float>(weights.weights[n] * (1 - around.share)), out);
        addDisplacements(*reference, around.after(), static_cast<float>(weights.weights[n] * around.share),
                         out);
    }
}

GroundMotion blendedStep(const MotionSpace& space, std::size_t frame, const NodeWeights& weights)
{
    GroundMotion step;
    forShares(space, weights, [&](std::size_t take, double share) {
        step.turn += share * space.takes[take].steps[frame].turn;
        step.shift += share * space.takes[take].steps[frame].shift;
    });
    return step;
}

double blendedSeconds(const MotionSpace& space, std::size_t frame, const NodeWeights& weights)
{
    double seconds = 0;
    forShares(space, weights,
              [&](std::size_t take, double share) { seconds += share * space.takes[take].seconds[frame]; });
    return seconds;
}

PerformedMovement BlendedMovement::performed(const MotionSpace& space) const
{
    return {poses, space.vertexCount(), steps, seconds, space.isCyclic, space.up};
}

BlendedMovement blendedMovement(const MotionSpace& space, const NodeWeights& weights)
{
    BlendedMovement movement{
        .poses = std::vector<Vec3f>(space.frameCount() * space.vertexCount()), .steps = {}, .seconds = {}};
    for (std::size_t f = 0; f < space.frameCount(); ++f) {
        blendedPose(space, static_cast<double>(f), weights,
                    MutablePositions(movement.poses).subspan(f * space.vertexCount(), space.vertexCount()));
        movement.steps.push_back(blendedStep(space, f, weights));
        movement.seconds.push_back(blendedSeconds(space, f, weights));
    }
    return movement;
}

} // namespace quadrille
