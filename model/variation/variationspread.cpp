// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/variationspread.h"

#include "model/geometry/procrustes.h"
#include "model/variation/alignment.h"

#include <atomic>
#include <cmath>
#include <numeric>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

using Pose = std::vector<Vec3f>;

/// Laid onto another pose by vertices that weigh.
Pose laidOnto(Positions moved, Positions target, std::span<const double> weights)
{
    const RigidMotion motion = rigidProcrustes(moved, target, weights);
    Pose laid;
    laid.reserve(moved.size());
    for (const Vec3f& position : moved)
        laid.push_back(motion(position.cast<double>()).cast<float>());
    return laid;
}

/// Of one frame of each run, the mean distance of each vertex from its mean, metres.
std::vector<double> deviations(std::span<const Positions> poses, std::span<const double> weights)
{
    const std::size_t count = poses.front().size();
    Pose mean(poses.front().begin(), poses.front().end());
    std::vector<Pose> laid(poses.size());
    // Laid onto the first, then once more onto the mean of them all.
    for (int pass = 0; pass < 2; ++pass) {
        for (std::size_t run = 0; run < poses.size(); ++run)
            laid[run] = laidOnto(poses[run], mean, weights);
        for (std::size_t v = 0; v < count; ++v) {
            Vec3d sum = Vec3d::Zero();
            for (const Pose& pose : laid)
                sum += pose[v].cast<double>();
            mean[v] = (sum / static_cast<double>(poses.size())).cast<float>();
        }
    }
    const auto runs = static_cast<double>(poses.size());
    const double scale = std::sqrt(runs / (runs - 1)) / runs;
    std::vector<double> deviations(count, 0.0);
    for (const Pose& pose : laid) {
        for (std::size_t v = 0; v < count; ++v)
            deviations[v] += scale * (pose[v] - mean[v]).cast<double>().norm();
    }
    return deviations;
}

/// The mean over the frames, of each vertex; empty where there is nothing to compare.
std::vector<double> spreadOf(std::span<const Positions> runs, std::span<const double> weights,
                             const Progress& progress)
{
    const std::size_t vertexCount = weights.size();
    if (runs.size() < 2)
        return {};
    const std::size_t frameCount = runs.front().size() / vertexCount;
    std::vector<std::vector<double>> frames(frameCount);
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(std::size_t{0}, frameCount, [&](std::size_t f) {
        std::vector<Positions> poses;
        for (const Positions& run : runs)
            poses.push_back(run.subspan(f * vertexCount, vertexCount));
        frames[f] = deviations(poses, weights);
        progress.report(++done, static_cast<std::int64_t>(frameCount));
    });
    std::vector<double> spread(vertexCount, 0.0);
    for (const std::vector<double>& frame : frames) {
        for (std::size_t v = 0; v < vertexCount; ++v)
            spread[v] += frame[v] / static_cast<double>(frameCount);
    }
    return spread;
}

} // namespace

std::optional<double> PartSpread::ratio() const
{
    return variations && takes && *takes > 0 ? std::optional(*variations / *takes) : std::nullopt;
}

std::vector<PartSpread> variationSpread(const BodyParts& parts, std::size_t vertexCount,
                                        std::span<const Positions> variations,
                                        std::span<const Positions> takes, const Progress& progress)
{
    const std::vector<VertexIndex> anchor = anchorVertices(parts);
    std::vector<double> weights(vertexCount, anchor.empty() ? 1.0 : 0.0);
    for (const VertexIndex v : anchor)
        weights[v.value] = 1;
    const std::vector<double> ofVariations = spreadOf(variations, weights, progress.part(0, 0.5));
    const std::vector<double> ofTakes = spreadOf(takes, weights, progress.part(0.5, 1));
    const auto meanOver = [](const std::vector<double>& spread, const std::vector<VertexIndex>& vertices) {
        if (spread.empty() || vertices.empty())
            return std::optional<double>();
        double sum = 0;
        for (const VertexIndex v : vertices)
            sum += spread[v.value];
        return std::optional(sum / static_cast<double>(vertices.size()));
    };
    std::vector<PartSpread> spreads;
    for (const BodyPart& part : parts.parts)
        spreads.push_back(
            {part.name, meanOver(ofVariations, part.vertices), meanOver(ofTakes, part.vertices)});
    std::vector<VertexIndex> all;
    for (std::size_t v = 0; v < vertexCount; ++v)
        all.emplace_back(v);
    spreads.push_back({{}, meanOver(ofVariations, all), meanOver(ofTakes, all)});
    return spreads;
}

} // namespace quadrille
