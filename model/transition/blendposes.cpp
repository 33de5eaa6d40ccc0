// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/poseinterpolation.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>
#include <map>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Steps that are computed together; their poses are in memory at the same time.
constexpr std::size_t batchSize = 32;

using PreparedPoses = std::map<int, std::shared_ptr<const PreparedPose>>;

/// Lets go of poses that a batch does not use and makes room for those it does.
void renew(PreparedPoses& poses, std::span<const BlendStep> batch, std::span<int BlendStep::*const> frames)
{
    PreparedPoses used;
    for (const BlendStep& step : batch) {
        for (int BlendStep::*const frame : frames)
            used[step.*frame];
    }
    for (auto& [index, pose] : used) {
        if (const auto found = poses.find(index); found != poses.end())
            pose = found->second;
    }
    poses = std::move(used);
}

} // namespace

std::vector<Vec3f> blendPoses(const std::shared_ptr<const PoissonSystem>& system,
                              std::span<const Positions> sources, std::span<const Positions> targets,
                              std::span<const BlendStep> steps, InterpolationMethod method,
                              const Progress& progress)
{
    const std::size_t vertexCount = system->vertexCount();
    std::vector<Vec3f> out(steps.size() * vertexCount);
    // Two windows of one clip share what is prepared of its frames.
    const bool isOneWindow = sources.data() == targets.data();
    PreparedPoses sourcePoses;
    PreparedPoses ownTargetPoses;
    PreparedPoses& targetPoses = isOneWindow ? sourcePoses : ownTargetPoses;
    constexpr std::array sourceAndTarget{&BlendStep::source, &BlendStep::target};
    for (std::size_t from = 0; from < steps.size(); from += batchSize) {
        const std::span<const BlendStep> batch =
            steps.subspan(from, std::min(batchSize, steps.size() - from));
        const Progress part =
            progress.part(static_cast<double>(from) / static_cast<double>(steps.size()),
                          static_cast<double>(from + batch.size()) / static_cast<double>(steps.size()));
        renew(sourcePoses, batch, std::span(sourceAndTarget).first(isOneWindow ? 2 : 1));
        if (!isOneWindow)
            renew(targetPoses, batch, std::span(sourceAndTarget).last(1));
        struct Missing
        {
            std::shared_ptr<const PreparedPose>* pose;
            Positions positions;
        };
        std::vector<Missing> missing;
        const auto note = [&missing](PreparedPoses& poses, std::span<const Positions> frames) {
            for (auto& [index, pose] : poses) {
                if (!pose)
                    missing.push_back({&pose, frames[static_cast<std::size_t>(index)]});
            }
        };
        note(sourcePoses, sources);
        if (!isOneWindow)
            note(targetPoses, targets);
        const auto total = static_cast<std::int64_t>(missing.size() + batch.size());
        std::atomic<std::int64_t> done = 0;
        tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t i) {
            *missing[i].pose = std::make_shared<const PreparedPose>(system, missing[i].positions);
            part.report(++done, total);
        });
        tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) {
            const BlendStep& step = batch[i];
            const PoseInterpolation between(sourcePoses.at(step.source), targetPoses.at(step.target));
            between.at(step.lambda, MutablePositions(out).subspan((from + i) * vertexCount, vertexCount),
                       method, step.placeSource, step.placeTarget);
            part.report(++done, total);
        });
    }
    progress.report(1.0);
    return out;
}

} // namespace quadrille
