// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/evaluations/appearanceevaluations.h"

#include "model/core/message.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/evaluations/evaluationsteps.h"

namespace quadrille {

BuildStep appearanceStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation)
{
    BuildStep step = evaluationStep(inputs.work, evaluation);
    step.inputs = {inputs.modelStep()};
    return step;
}

std::shared_ptr<const MeasuredAppearance> measuredAppearance(const AppearanceInputs& inputs,
                                                             std::int64_t least, const Progress& progress)
{
    auto measured = std::make_shared<MeasuredAppearance>();
    AppearanceTraining& training = measured->training;
    training = appearanceTraining(*inputs.work.opener, inputs.appearance.entry, progress);
    measured->frames = training.frames();
    if (std::ssize(training.textures) < least)
        throwInvalid("“" + inputs.appearance.entry.name + "” learns from " +
                         std::to_string(training.textures.size()) + " textures; here it takes " +
                         std::to_string(least) + " at least",
                     QUADRILLE_MESSAGE("Give it sequences with more frames."));
    AppearanceSubject& subject = measured->subject;
    subject.textures = training.source();
    const std::shared_ptr<const Image> first = subject.textures.read(0);
    subject.charts = std::make_shared<const ChartLookup>(
        usedTexels(*training.topology, first->width, first->height, inputs.appearance.options().gutter));
    subject.topology = training.topology;
    subject.frame = [opener = inputs.work.opener, frames = measured->frames](std::int64_t texture) {
        const AppearanceFrame& of = frames[static_cast<std::size_t>(texture)];
        return opener->open(of.sequence)->sequence.frame(of.frame);
    };
    subject.up = inputs.work.opener->project().settings.axes.up;
    subject.scratchFolder = inputs.appearance.folder();
    std::filesystem::create_directories(subject.scratchFolder);
    return measured;
}

std::shared_ptr<TextureAlignment> alignmentOf(const AppearanceInputs& inputs,
                                              const MeasuredAppearance& measured, const Result& model,
                                              const Progress& progress)
{
    if (inputs.appearance.entry.warpShare <= 0)
        return nullptr;
    AlignmentOptions options = inputs.appearance.options().alignment;
    options.reference = std::get<std::vector<std::int64_t>>(arrayOf(model, "reference").values).front();
    FlowFiles flows = inputs.appearance.flows(measured.training, progress.part(0, 0.1));
    return alignTextures(measured.subject.textures, *measured.subject.charts, options, &flows,
                         progress.part(0.1, 1));
}

} // namespace quadrille
