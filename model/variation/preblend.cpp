// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/preblend.h"

#include "model/core/badargument.h"
#include "model/core/error.h"
#include "model/transition/poseinterpolation.h"
#include "model/variation/playback.h"

#include <array>
#include <cassert>
#include <cmath>
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

/// Those that take part. \throws Error BadArgument.
std::vector<TakeShare> partakers(std::span<const TakeShare> takes)
{
    constexpr double rounding = 1e-9;
    double sum = 0;
    std::vector<TakeShare> some;
    for (const TakeShare& take : takes) {
        // Written so that no number is refused, too.
        if (!(take.share >= 0))
            refuse("A take has a share below 0 in a blend", "Weights are from 0 to 1.");
        sum += take.share;
        if (take.share > 0)
            some.push_back(take);
    }
    if (!(std::abs(sum - 1) <= rounding))
        refuse("The shares of the takes in a blend do not add up to 1", "Weights are from 0 to 1.");
    return some;
}

} // namespace

AlignedTake blendedTake(const std::shared_ptr<const PoissonSystem>& system, std::span<const TakeShare> takes,
                        std::string name, const PreblendSettings& settings, const Progress& progress)
{
    const std::vector<TakeShare> some = partakers(takes);
    for (const TakeShare& each : takes)
        requireVertices(*system, *each.take);
    AlignedTake blend = *some.front().take;
    blend.name = std::move(name);
    std::vector<WarpShare> warps{{&some.front().take->warp, some.front().share}};
    double share = some.front().share;
    const std::size_t frames = blend.placements.size();
    for (std::size_t t = 1; t < some.size(); ++t) {
        const AlignedTake& take = *some[t].take;
        assert(take.placements.size() == frames);
        warps.push_back({&take.warp, some[t].share});
        share += some[t].share;
        std::vector<BlendStep> steps;
        for (std::size_t f = 0; f < frames; ++f)
            steps.push_back({static_cast<int>(f), static_cast<int>(f), some[t].share / share, {}, {}});
        const auto done = static_cast<double>(t);
        const auto steppings = static_cast<double>(some.size() - 1);
        blend.poses = blendPoses(system, blend.allPoses(), take.allPoses(), steps, settings.method,
                                 progress.part((done - 1) / steppings, done / steppings));
        if (blend.laidOnto != take.laidOnto)
            blend.laidOnto = nullptr;
        if (blend.laidOnto)
            layOnto(*blend.laidOnto, frames, blend.poses);
    }
    for (std::size_t k = 0; k < blend.coefficients.size(); ++k) {
        blend.coefficients[k] *= some.front().share;
        for (const TakeShare& each : std::span(some).subspan(1))
            blend.coefficients[k] += each.share * each.take->coefficients[k];
    }
    blend.warp = blendedWarp(warps);
    blend.placements = blendedPlacements(some, settings.up);
    return blend;
}

AlignedTake blendedTake(const std::shared_ptr<const PoissonSystem>& system, const AlignedTake& a,
                        const AlignedTake& b, double weight, std::string name,
                        const PreblendSettings& settings, const Progress& progress)
{
    return blendedTake(system, std::array{TakeShare{&a, 1 - weight}, TakeShare{&b, weight}}, std::move(name),
                       settings, progress);
}

std::vector<RigidMotion> blendedPlacements(std::span<const TakeShare> takes, UpAxis up)
{
    assert(!takes.empty());
    std::vector<RigidMotion> guide = takes.front().take->placements;
    if (takes.size() == 1)
        return guide;
    const Vec3d upAxis = Vec3d::Unit(static_cast<Eigen::Index>(up));
    std::vector<Displacement> displacements(guide.size(), Displacement{});
    std::vector<Vec3d> leaning(guide.size(), Vec3d::Zero());
    double share = 0;
    for (const TakeShare& each : takes) {
        const std::vector<RigidMotion>& places = each.take->placements;
        assert(places.size() == guide.size());
        share += each.share;
        const std::vector<Displacement> own = displacementsOf(places);
        for (std::size_t f = 0; f < guide.size(); ++f) {
            for (std::size_t k = 0; k < own[f].size(); ++k)
                displacements[f][k] += each.share * own[f][k];
            leaning[f] += each.share * upSeenFrom(places[f], upAxis);
            guide[f] = interpolated(guide[f], places[f], each.share / share);
        }
    }
    for (std::size_t f = 0; f < guide.size(); ++f)
        guide[f] = leanedTo(leaning[f], guide[f], upAxis);
    return pathOnGround(displacements, guide, {.up = up, .driftHalfLife = 0});
}

} // namespace quadrille
