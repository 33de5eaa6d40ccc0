// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "animatedproject.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/variationsworkspace.h"

namespace quadrille::test {

/// The swaying spire's takes, one second each, and variations “sways” that are learned from the first two.
inline Project variedProject(const QString& folder)
{
    Project project = swayingProject(folder);
    project.animations.clear();
    VariationEntry sways;
    sways.name = "sways";
    sways.cycles = false;
    sways.learning.dimensions = 2;
    sways.learning.restarts = 0;
    sways.chain.burnIn = 20;
    // The spire is no body: what would be bad of one is not bad of it.
    sways.limits = {
        .poseDistance = 10, .skate = 100, .intersections = 1, .volumeChange = 10, .collapse = 1, .sink = 10};
    for (const char* take : {"first", "second"}) {
        TrainingEntry training;
        training.sequence = take;
        training.range = FrameRange{FrameIndex(0), FrameIndex(19)};
        sways.training.push_back(training);
    }
    SamplesEntry samples;
    samples.of = "first";
    samples.count = 3;
    sways.samples = {samples};
    project.variations = {sways};
    return project;
}

/// Waits until variations are learned and drawn as the project says.
inline bool waitForVariations(EditorContext& context, const QString& name)
{
    return QTest::qWaitFor(
        [&] {
            const auto* resultState = context.variations.resultState(name);
            return resultState != nullptr && resultState->phase == ResultPhase::Ready;
        },
        patience);
}

inline bool isNotLearned(const VariationResults::State& state)
{
    return state.isNotLearned();
}

inline bool isReady(const VariationResults::State& state)
{
    return state.phase == ResultPhase::Ready;
}

inline bool isFailed(const VariationResults::State& state)
{
    return state.phase == ResultPhase::Failed;
}

inline bool waitForState(EditorContext& context, const QString& name,
                         bool (*holds)(const VariationResults::State&), int milliseconds = patience)
{
    return QTest::qWaitFor(
        [&] {
            const auto* resultState = context.variations.resultState(name);
            return resultState != nullptr && holds(*resultState);
        },
        milliseconds);
}

} // namespace quadrille::test
