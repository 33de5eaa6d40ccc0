// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

namespace quadrille::test {

inline BodyPartsEntry fullBodyParts()
{
    const auto ring = [](std::string name, std::uint32_t first) {
        PartCurveEntry entry;
        entry.curve.name = std::move(name);
        entry.curve.vertices = {VertexIndex(first), VertexIndex(first + 1), VertexIndex(first + 2)};
        entry.points = {VertexIndex(first), VertexIndex(first + 2)};
        return entry;
    };
    const auto part = [](std::string name, std::string parent, std::vector<std::string> curves) {
        PartEntry entry;
        entry.part = {std::move(name), std::move(parent), std::move(curves)};
        return entry;
    };
    BodyPartsEntry parts;
    parts.character = "liam";
    parts.pose = NamedFrame{"talk", FrameIndex(3)};
    parts.curves = {ring("shoulder", 0), ring("upper arm", 10)};
    parts.parts = {part("torso", "", {}), part("arm", "torso", {"shoulder", "upper arm"})};
    return parts;
}

/// Variations in which every known key has a value that is not the default.
inline VariationEntry fullVariation()
{
    VariationEntry variation;
    variation.name = "chat";
    variation.character = "liam";
    TrainingEntry talk;
    talk.sequence = "talk";
    talk.range = FrameRange{FrameIndex(0), FrameIndex(30)};
    TrainingEntry again;
    again.sequence = "again";
    TrainingEntry softly;
    softly.sequence = "softly";
    TrainingEntry softlyAgain;
    softlyAgain.sequence = "softly again";
    variation.training = {talk, again, softly, softlyAgain};
    variation.reference = "again";
    variation.templatePose = NamedFrame{"talk", FrameIndex(5)};
    variation.cycles = false;
    BlendEntry blend;
    blend.from = "talk";
    blend.to = "again";
    blend.weights = {0.25, 0.75};
    blend.across.emplace();
    blend.across->from = "softly";
    blend.across->to = "softly again";
    blend.across->weights = {0.4};
    variation.blends = {blend};
    variation.displacementShare = 3;
    variation.learning = {.dimensions = 4,
                          .restarts = 2,
                          .seed = 7,
                          .tolerance = 1e-5,
                          .window = 20,
                          .greatestIterations = 500};
    variation.chain.leapfrogSteps = 10;
    variation.chain.burnIn = 50;
    variation.chain.thinning = 5;
    variation.chain.leastAcceptance = 0.65;
    variation.chain.greatestAcceptance = 0.85;
    variation.extent = {.spread = 0.8, .uncertainty = 0.1};
    SamplesEntry samples;
    samples.of = "talk";
    samples.to = "again";
    samples.weight = 0.3;
    samples.across.emplace();
    samples.across->of = "softly";
    samples.across->to = "softly again";
    samples.across->weight = 0.6;
    samples.count = 3;
    samples.seed = 2;
    samples.discarded = {2};
    SamplesEntry alone;
    alone.of = "talk";
    variation.samples = {samples, alone};
    variation.draw = PoseDraw::Sample;
    variation.correctsContacts = false;
    variation.limits = {.poseDistance = 0.1,
                        .skate = 0.2,
                        .intersections = 0.02,
                        .volumeChange = 0.3,
                        .collapse = 0.2,
                        .sink = 0.03};
    return variation;
}

} // namespace quadrille::test
