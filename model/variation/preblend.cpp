// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/preblend.h"

#include "model/core/badargument.h"
#include "model/core/error.h"
#include "model/transition/poseinterpolation.h"
#include "model/variation/playback.h"

#include <cassert>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

void requireVertices(const PoissonSystem& system, const AlignedTake& take)
{
    const std::size_t found = take.poses.size() / take.placements.size();
    if (found != system.vertexCount())
        throw Error(ErrorCode::VertexCountMismatch,
                    {.values = {{"found", std::to_string(found)},
                                {"expected", std::to_string(system.vertexCount())}}});
}

std::vector<Positions> posesOf(const AlignedTake& take)
{
    std::vector<Positions> poses;
    for (std::size_t f = 0; f < take.placements.size(); ++f)
        poses.push_back(take.pose(f));
    return poses;
}

/// Between two poses that lie on the template a pose lies beside it: its centre keeps to a straight line,
/// around which its anchor moves as limbs swing.
void layOnto(const AlignmentTemplate& target, std::size_t frames, std::vector<Vec3f>& poses)
{
    const std::size_t vertices = target.pose.size();
    tbb::parallel_for(std::size_t{0}, frames, [&](std::size_t f) {
        const auto pose = std::span(poses).subspan(f * vertices, vertices);
        const RigidMotion onto = target.onto(pose);
        for (Vec3f& p : pose)
            p = onto(p.cast<double>()).cast<float>();
    });
}

} // namespace

AlignedTake blendedTake(const std::shared_ptr<const PoissonSystem>& system, const AlignedTake& a,
                        const AlignedTake& b, double weight, std::string name,
                        const PreblendSettings& settings, const Progress& progress)
{
    assert(a.placements.size() == b.placements.size());
    if (!(weight >= 0 && weight <= 1))
        refuse("A blend of two takes has a weight from 0 to 1", "0 is the first take, 1 the second.");
    requireVertices(*system, a);
    requireVertices(*system, b);
    AlignedTake blend{.name = std::move(name),
                      .warp = blendedWarp(a.warp, b.warp, weight),
                      .poses = {},
                      .placements = blendedPlacements(a.placements, b.placements, weight, settings.up),
                      .laidOnto = a.laidOnto};
    std::vector<BlendStep> steps;
    for (std::size_t f = 0; f < a.placements.size(); ++f)
        steps.push_back({static_cast<int>(f), static_cast<int>(f), weight, {}, {}});
    blend.poses = blendPoses(system, posesOf(a), posesOf(b), steps, settings.method, progress);
    if (a.laidOnto && a.laidOnto == b.laidOnto)
        layOnto(*a.laidOnto, steps.size(), blend.poses);
    return blend;
}

std::vector<RigidMotion> blendedPlacements(std::span<const RigidMotion> a, std::span<const RigidMotion> b,
                                           double weight, UpAxis up)
{
    assert(a.size() == b.size());
    if (weight <= 0)
        return {a.begin(), a.end()};
    if (weight >= 1)
        return {b.begin(), b.end()};
    std::vector<Displacement> displacements = displacementsOf(a);
    const std::vector<Displacement> others = displacementsOf(b);
    const Vec3d upAxis = Vec3d::Unit(static_cast<Eigen::Index>(up));
    std::vector<RigidMotion> guide;
    for (std::size_t f = 0; f < a.size(); ++f) {
        for (std::size_t k = 0; k < displacements[f].size(); ++k)
            displacements[f][k] = (1 - weight) * displacements[f][k] + weight * others[f][k];
        const Vec3d leaning = (1 - weight) * upSeenFrom(a[f], upAxis) + weight * upSeenFrom(b[f], upAxis);
        guide.push_back(leanedTo(leaning, interpolated(a[f], b[f], weight), upAxis));
    }
    return pathOnGround(displacements, guide, {.up = up, .driftHalfLife = 0});
}

} // namespace quadrille
