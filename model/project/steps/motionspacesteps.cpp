// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/motionspacesteps.h"

#include "model/project/steps/motionspaceresults.h"

namespace quadrille {

namespace {

using WorkPointer = std::shared_ptr<const MotionSpaceWork>;

constexpr std::string_view stepsBegin = "motion_spaces/";
constexpr std::string_view spaceEnd = "/space";

std::string pairName(const std::string& source, const std::string& target)
{
    return "transitions/" + source + "/" + target;
}

BuildStep spaceStep(const WorkPointer& work)
{
    BuildStep step;
    step.name = motionSpaceStepOf(work->entry().name);
    step.kind = "motion space";
    step.dataPrefix = "motion_spaces/" + work->entry().name;
    step.version = MotionSpaceWork::version;
    step.character = work->character();
    step.settings = work->settings();
    step.files = [work](const Progress& progress) { return work->files(progress); };
    step.inputs = work->inputs();
    step.compute = [work](const StepContext& /*context*/, const Progress& progress) {
        return motionSpaceResult(work->make(progress));
    };
    return step;
}

BuildStep qualityStep(const WorkPointer& work)
{
    BuildStep step;
    step.name = motionSpaceQualityStepOf(work->entry().name);
    step.kind = "quality of a motion space";
    step.dataPrefix = "motion-spaces/" + work->entry().name;
    step.character = work->character();
    step.inputs = {motionSpaceStepOf(work->entry().name)};
    step.compute = [work](const StepContext& context, const Progress& progress) {
        return motionSpaceQuality(*sharedMotionSpace(*work, context, progress), progress);
    };
    return step;
}

BuildStep similarityStep(const WorkPointer& source, const WorkPointer& target)
{
    BuildStep step;
    step.name = similarityStepOf(source->entry().name, target->entry().name);
    step.kind = "similarity of motion spaces";
    step.dataPrefix = pairName(source->entry().name, target->entry().name);
    step.character = source->character();
    step.inputs = {motionSpaceStepOf(source->entry().name), motionSpaceStepOf(target->entry().name)};
    step.compute = [source, target](const StepContext& context, const Progress& progress) {
        const auto from = sharedMotionSpace(*source, context, progress);
        const auto to = sharedMotionSpace(*target, context, progress);
        return similarityResult(similarities(*from, *to, {}, progress));
    };
    return step;
}

BuildStep reportStep(const WorkPointer& source, const WorkPointer& target)
{
    BuildStep step = similarityStep(source, target);
    const std::string& from = source->entry().name;
    const std::string& to = target->entry().name;
    step.name = transitionReportStepOf(from, to);
    step.kind = "transitions of motion spaces";
    step.inputs.push_back(similarityStepOf(from, to));
    step.compute = [source, target](const StepContext& context, const Progress& progress) {
        return transitionReport(
            *sharedMotionSpace(*source, context, progress), *sharedMotionSpace(*target, context, progress),
            sharedSimilarities(source->entry().name, target->entry().name, context), progress);
    };
    return step;
}

} // namespace

std::string motionSpaceStepOf(const std::string& space)
{
    return std::string(stepsBegin).append(space).append(spaceEnd);
}

std::string motionSpaceOfStep(std::string_view step)
{
    if (!step.starts_with(stepsBegin) || !step.ends_with(spaceEnd))
        return {};
    step.remove_prefix(stepsBegin.size());
    step.remove_suffix(spaceEnd.size());
    return std::string(step);
}

std::string motionSpaceQualityStepOf(const std::string& space)
{
    return "motion_spaces/" + space + "/quality";
}

std::string similarityStepOf(const std::string& source, const std::string& target)
{
    return pairName(source, target) + "/similarity";
}

std::string transitionReportStepOf(const std::string& source, const std::string& target)
{
    return pairName(source, target) + "/report";
}

std::shared_ptr<const MotionSpace> sharedMotionSpace(const MotionSpaceWork& work, const StepContext& context,
                                                     const Progress& progress)
{
    const std::string step = motionSpaceStepOf(work.entry().name);
    const std::string kind =
        "motion space " + work.entry().name + ' ' + std::to_string(static_cast<int>(work.up()));
    return context.shared<const MotionSpace>({step}, kind, [&] {
        MotionSpace space = motionSpaceOf(*context.resultOf(step));
        space.name = work.entry().name;
        space.topology = work.topology(Progress(progress.token()));
        space.up = work.up();
        return std::make_shared<const MotionSpace>(std::move(space));
    });
}

std::shared_ptr<const SimilarityTable>
sharedSimilarities(const std::string& source, const std::string& target, const StepContext& context)
{
    const std::string step = similarityStepOf(source, target);
    return context.shared<const SimilarityTable>({step}, "similarities", [&] {
        return std::make_shared<const SimilarityTable>(similaritiesOf(*context.resultOf(step)));
    });
}

std::vector<BuildStep> makeMotionSpaceSteps(const StepMaking& making)
{
    std::vector<WorkPointer> works;
    for (const MotionSpaceEntry& entry : making.opener->project().motionSpaces) {
        if (!entry.takes.empty())
            works.push_back(std::make_shared<const MotionSpaceWork>(making.opener, entry));
    }
    std::vector<BuildStep> steps;
    for (const WorkPointer& work : works) {
        steps.push_back(spaceStep(work));
        steps.push_back(qualityStep(work));
    }
    for (const WorkPointer& source : works) {
        for (const WorkPointer& target : works) {
            if (source == target || source->character() != target->character())
                continue;
            steps.push_back(similarityStep(source, target));
            steps.push_back(reportStep(source, target));
        }
    }
    return steps;
}

} // namespace quadrille
