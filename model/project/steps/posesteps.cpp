// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/posesteps.h"

#include "model/project/document/findentry.h"
#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/graphstepresults.h"
#include "model/synthesis/clips/rootposes.h"
#include "model/transition/posedistance.h"

#include <utility>

namespace quadrille {

namespace {

/// What the steps that follow need to know of the frames.
void addLayout(Result& result, const PoseDistances& distances)
{
    result.arrays.push_back(columnOf("sequence-lengths", "frame", lengthsOf(distances.layout)));
    result.arrays.back().description = "Frames of each sequence, in the order of the project.";
    result.arrays.push_back(
        columnOf("triangles", "", std::vector{distances.trianglesUsed, distances.trianglesLeftOut}));
    result.arrays.back().description =
        "Triangles compared, and those left out because they have no area or are beyond their number.";
}

bool isSurface(const PoseDistanceSettings& settings)
{
    return settings.metric == PoseMetric::Surface;
}

/// Beside the distances that a graph is made from.
PoseDistanceSettings euclideanOf(const PoseDistanceSettings& settings)
{
    return {.metric = PoseMetric::Euclidean, .triangles = settings.triangles};
}

Result distanceResult(const CharacterInputs& work, const std::string& name,
                      const PoseDistanceSettings& settings, PoseDistances distances)
{
    if (!isSurface(settings))
        distances.distances *= static_cast<float>(work.opener->project().settings.axes.metresPerUnit);
    Result result;
    result.arrays = {matrixOf(name,
                              isSurface(settings)
                                  ? "Surface distance between the poses of all frames, rigid motion removed."
                                  : "Mean distance of the vertices between all frames, rigid motion removed.",
                              isSurface(settings) ? "rad" : "m", std::move(distances.distances))};
    if (name == graphstep::poseDistance)
        addLayout(result, distances);
    return result;
}

Result rootsResult(const CharacterInputs& work, const CharacterFrames& frames, RootPoses roots,
                   const Progress& progress)
{
    roots.supports = findSupports(frames, roots.up, progress.part(0, 0.5));
    constexpr std::size_t enough = 48; // vertices that stand
    thinSupports(roots.supports, enough);
    roots.stances = findStances(frames, roots.up, progress.part(0.5, 1));
    return rootPosesResult(std::move(roots), unitText(work.opener->project().settings.axes.metresPerUnit));
}

UpAxis upOf(const CharacterInputs& work)
{
    return work.opener->project().settings.axes.up;
}

/// What all of these steps depend on.
BuildStep poseStep(const CharacterInputs& work, const std::string& name)
{
    BuildStep step = work.step(name);
    step.settings = work.settings;
    step.files = [work](const Progress& progress) { return work.files(progress); };
    step.inputs = clipInputs(work.opener->project(), work.sequences);
    return step;
}

BuildStep distanceStep(const CharacterInputs& work, const std::string& name,
                       const PoseDistanceSettings& settings)
{
    BuildStep step = poseStep(work, name);
    step.version = 3;
    step.settings += jsonLine(distanceSettings(settings));
    if (step.inputs.empty()) // else frames are not known before
        step.bytes = bytesOfTables(work, 1);
    step.compute = [=](const StepContext&, const Progress& progress) {
        const CharacterFrames frames = work.open(progress.part(0, 0.05));
        const PoseDistanceSettings compared = ofGraph(settings, frames.frameCount());
        return distanceResult(work, name, settings, poseDistances(frames, compared, progress.part(0.05, 1)));
    };
    return step;
}

/// Where the frames stand and how they are turned, for walks.
BuildStep rootPosesStep(const CharacterInputs& work)
{
    BuildStep step = poseStep(work, graphstep::rootPoses);
    step.version = 6;
    for (const std::string& name : work.sequences)
        step.settings += contactSettings(*findSequence(work.opener->project(), name));
    step.compute = [work](const StepContext&, const Progress& progress) {
        const CharacterFrames frames = work.open(progress.part(0, 0.05));
        RootPoses roots = rootPoses(frames, upOf(work), progress.part(0.05, 0.8));
        return rootsResult(work, frames, std::move(roots), progress.part(0.8, 1));
    };
    return step;
}

} // namespace

std::vector<BuildStep> poseSteps(const CharacterInputs& work)
{
    const PoseDistanceSettings& settings = work.graph.pose;
    const PoseDistanceSettings euclidean = euclideanOf(settings);
    BuildStep distances = distanceStep(work, graphstep::poseDistance, settings);
    distances.along = {work.stepName(graphstep::euclideanDistance), work.stepName(graphstep::rootPoses)};
    distances.compute = [work, settings, euclidean, along = distances.along](const StepContext& context,
                                                                             const Progress& progress) {
        const bool wantsEuclidean = context.isWanted && context.isWanted(along[0]);
        const bool wantsRoots = context.isWanted && context.isWanted(along[1]);
        const CharacterFrames frames = work.open(progress.part(0, 0.05));
        std::vector<PoseDistanceSettings> metrics{ofGraph(settings, frames.frameCount())};
        if (wantsEuclidean)
            metrics.push_back(ofGraph(euclidean, frames.frameCount()));
        PosePairs pairs = posePairs(frames, metrics, wantsRoots ? turnOf(upOf(work)) : OfCovariance(),
                                    progress.part(0.05, 0.95));
        if (wantsEuclidean)
            context.give(along[0], distanceResult(work, graphstep::euclideanDistance, euclidean,
                                                  std::move(pairs.distances.back())));
        if (wantsRoots)
            context.give(along[1], rootsResult(work, frames,
                                               rootPoses(std::move(pairs.centres),
                                                         std::move(pairs.ofCovariances), upOf(work)),
                                               progress.part(0.95, 1)));
        return distanceResult(work, graphstep::poseDistance, settings, std::move(pairs.distances.front()));
    };
    return {std::move(distances), distanceStep(work, graphstep::euclideanDistance, euclidean),
            rootPosesStep(work)};
}

std::vector<JsonLine> distanceSettings(const PoseDistanceSettings& settings)
{
    std::vector<JsonLine> list{isSurface(settings) ? "surface" : "euclidean", settings.stretchWeight};
    if (settings.triangles)
        list.emplace_back(*settings.triangles);
    return list;
}

std::function<std::uint64_t(const Progress&)> bytesOfTables(const CharacterInputs& work, double tables)
{
    return [work, tables](const Progress& progress) {
        const double frames = work.open(progress).frameCount();
        return static_cast<std::uint64_t>(tables * frames * frames * static_cast<double>(sizeof(float)));
    };
}

} // namespace quadrille
