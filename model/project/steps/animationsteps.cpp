// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/fields/writefields.h"
#include "model/project/steps/animate.h"
#include "model/project/steps/clippost.h"
#include "model/project/steps/clipresult.h"
#include "model/project/steps/variedrepeats.h"
#include "model/project/steps/walkrequest.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>
#include <limits>

namespace quadrille {

namespace {

/// The work of the character that an animation shows.
CharacterInputs workOf(const StepMaking& making, const AnimationEntry& animation)
{
    const Project& project = making.opener->project();
    return characterWork(making.opener, graphOf(project, characterNameOf(project, animation)));
}

DataArray groundMotionArray(std::string name, std::string description, const GroundMotion& motion)
{
    DataArray array;
    array.name = std::move(name);
    array.description = std::move(description);
    array.shape = {3};
    array.values = std::vector<double>{motion.turn, motion.shift.x(), motion.shift.y()};
    return array;
}

GroundMotion placementOf(const Result& walk)
{
    const auto& values = std::get<std::vector<double>>(arrayOf(walk, "placement").values);
    return {values[0], Vec2d(values[1], values[2])};
}

DataArray askedArray(const FrameRange& asked)
{
    DataArray array;
    array.name = "asked";
    array.description = "The first and the last frame that show what was asked for: keys, actions and spans "
                        "of a path; 0 and -1 where nothing was.";
    array.shape = {2};
    array.values = std::vector<std::int64_t>{asked.first.value, asked.last.value};
    return array;
}

FrameRange askedOf(const Result& walk)
{
    const auto& values = std::get<std::vector<std::int64_t>>(arrayOf(walk, "asked").values);
    return {FrameIndex(values[0]), FrameIndex(values[1])};
}

DataTable walkTable(const WalkSolution& solution, const CharacterGraph& graph, const ClipPlan& plan)
{
    TableBuilder table("walk", "The captured frames of the animation, and the transitions after them.");
    table.text("sequence").whole("first", "frame").whole("last", "frame").whole("shown-from", "frame");
    table.whole("transition-length", "frame").real("transition-cost").real("transition-weight");
    // What the cost is made of.
    table.real("pose-cost").real("contact-cost").real("velocity-cost");
    const std::vector<WalkSpan>& spans = solution.walk.spans;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const NamedFrame first = graph.nameOf(spans[i].first);
        const bool isLast = i + 1 == spans.size();
        std::int64_t length = 0;
        double cost = 0;
        double weight = 0;
        CostParts parts;
        if (!isLast) {
            const FramePair pair = solution.walk.transition(i);
            length = graph.costs().length()(pair.source, pair.destination);
            cost = static_cast<double>(graph.costs().cost()(pair.source, pair.destination));
            weight = graph.costs().weight(pair.source, pair.destination, graph.alpha());
            parts = graph.partsOf(pair);
        }
        table.add({first.sequence, first.frame.value, graph.nameOf(spans[i].last).frame.value,
                   plan.spanStarts[i], length, cost, weight, parts.pose, parts.contacts, parts.velocity});
    }
    return std::move(table).table();
}

/// What was wanted and what came out.
DataTable reportTable(const AnimationEntry& animation, const CharacterGraph& graph,
                      const WalkSolution& solution, const WalkConstraints& constraints,
                      std::int64_t frameCount)
{
    const double fps = graph.fps();
    TableBuilder table("report", "What was asked of the animation, and what it does.");
    table.text("what").text("name").real("wanted").real("obtained").text("unit");
    constexpr double open = std::numeric_limits<double>::quiet_NaN(); // nothing was asked
    table.add({"duration", "", open, static_cast<double>(frameCount) / fps, "s"});
    table.add({"transitions", "", open, static_cast<double>(solution.walk.transitionCount()), ""});
    table.add({"cost of edges", "", open, solution.cost.edges, ""});
    if (animation.walk)
        return std::move(table).table();
    const char* const unit = constraints.path ? "m²" : "";
    const CostWeights weights = costWeights(animation, graph);
    table.add({"weight of edges", "mu", open, weights.mu, unit});
    table.add({"cost of timing", "", open, solution.cost.timing, unit});
    table.add({"weight of timing", "beta, of a frame", open, weights.beta, unit});
    table.add({"cost of deviation", "", open, solution.cost.deviation, "m²"});
    table.add({"total cost", "", open, solution.totalCost, unit});
    table.add({"expansions", "", open, static_cast<double>(solution.expansions), ""});
    table.add({"proven best in the Essential graph", solution.eachLeg ? "each stretch from key to key" : "",
               open, solution.optimal ? 1.0 : 0.0, ""});
    table.add({"proven least cost of any walk in the Essential graph", "", open,
               solution.bound > 0 ? solution.bound : open, unit});
    for (std::size_t k = 0; k < solution.keys.size(); ++k)
        table.add({"key", std::to_string(k + 1), solution.keys[k].wanted / fps,
                   static_cast<double>(solution.keys[k].obtained) / fps, "s"});
    if (constraints.path) {
        table.add({"length of path", "", solution.pathLength, solution.pathLength, "m"});
        table.add({"mean deviation", "", 0.0, solution.meanDeviation, "m"});
        table.add({"greatest deviation", "", 0.0, solution.greatestDeviation, "m"});
    }
    const auto addRange = [&](const char* what, const std::string& name, const FrameRange& range,
                              const std::optional<double>& wanted) {
        table.add(
            {std::string(what) + " from", name, open, static_cast<double>(range.first.value) / fps, "s"});
        table.add({std::string(what) + " lasts", name, wanted.value_or(open) / fps,
                   static_cast<double>(range.count()) / fps, "s"});
    };
    for (std::size_t a = 0; a < solution.actions.size(); ++a)
        addRange("action", constraints.actions[a].frames.name, solution.actions[a],
                 constraints.actions[a].duration);
    for (std::size_t s = 0; s < solution.spans.size(); ++s) {
        const PathSpan& span = constraints.path->spans[s];
        addRange("span of path", span.demanded ? span.demanded->name : std::to_string(s + 1),
                 solution.spans[s], span.duration);
    }
    return std::move(table).table();
}

Result walkResult(const AnimationEntry& animation, const CharacterGraph& graph, const Progress& progress)
{
    const auto [constraints, solution] = animationWalk(animation, graph, progress);
    const ClipPlan plan = planClip(graph.roots(), graph.layout(), graph.paths(), solution.walk);
    Result result;
    result.arrays = {groundMotionArray("placement",
                                       "Turn about the up axis, radians, and shift over the ground, "
                                       "metres, that place the first sequence as it was captured.",
                                       solution.start),
                     askedArray(solution.asked())};
    result.tables = {walkTable(solution, graph, plan),
                     reportTable(animation, graph, solution, constraints, plan.frameCount())};
    return result;
}

BuildStep walkStep(const CharacterInputs& work, const AnimationEntry& animation)
{
    BuildStep step;
    step.name = "animations/" + animation.name + "/walk";
    step.version = 16;
    step.dataPrefix = "animations/" + animation.name;
    step.settings = walkSettings(animation, work);
    step.inputs = CharacterGraph::inputs(work);
    step.compute = [work, animation](const StepContext& context, const Progress& progress) {
        const CharacterGraph graph(work, context);
        return walkResult(animation, graph, progress);
    };
    return step;
}

Walk walkOf(const Result& result, const CharacterGraph& graph)
{
    const DataTable& table = result.tables.front();
    const auto& sequences = std::get<std::vector<std::string>>(table.columns[0].values);
    const auto& first = std::get<std::vector<std::int64_t>>(table.columns[1].values);
    const auto& last = std::get<std::vector<std::int64_t>>(table.columns[2].values);
    Walk walk;
    for (std::size_t i = 0; i < sequences.size(); ++i)
        walk.spans.push_back(graph.span(sequences[i], FrameRange{FrameIndex(first[i]), FrameIndex(last[i])}));
    return walk;
}

BuildStep clipStep(const CharacterInputs& work, const AnimationEntry& animation, const BuildStep& walk)
{
    BuildStep step;
    step.name = clipStepOf("animations/" + animation.name);
    step.version = 8;
    step.dataPrefix = walk.dataPrefix;
    const AnimationEntry made{.interpolation = animation.interpolation,
                              .gentleBlend = animation.gentleBlend,
                              .post = animation.post};
    step.settings = work.settings + animationSettings(made, work.opener->project().settings.axes.up);
    step.inputs = CharacterGraph::inputs(work);
    step.inputs.push_back(walk.name);
    const std::vector<std::string> drawn = clipsDrawnFrom(work.opener->project(), animation);
    for (const std::string& clip : drawn) {
        step.settings += clip;
        step.inputs.push_back(clipStepOf(clip));
    }
    step.files = [work, animation](const Progress& progress) {
        std::vector<std::filesystem::path> files = work.files(progress);
        const auto symmetry = symmetryFiles(animation, work);
        files.insert(files.end(), symmetry.begin(), symmetry.end());
        return files;
    };
    step.compute = [work, animation, drawn, walk = walk.name](const StepContext& context,
                                                              const Progress& progress) {
        const CharacterGraph graph(work, context);
        const Result found = context.resultOf(walk);
        const ClipPlan plan = animationPlan(
            animation, graph,
            {.walk = walkOf(found, graph), .start = placementOf(found), .actions = {askedOf(found)}},
            pathOf(animation, graph));
        const CharacterFrames frames = work.open(progress.part(0, 0.05));
        std::vector<TakeVariation> variations;
        std::vector<std::string> names;
        for (const std::string& clip : drawn) {
            if (auto variation = takeVariation(clip, context.resultOf(clipStepOf(clip)), graph)) {
                variations.push_back(std::move(*variation));
                names.push_back(clip);
            }
        }
        const auto [processed, shown, spans, hasNoFeet] =
            animationClip(animation, graph, frames, plan, variations, progress.part(0.05, 1));
        Result result = clipResult(processed.clip, graph.layout(), work.sequences,
                                   unitText(work.opener->project().settings.axes.metresPerUnit), names);
        if (hasNoFeet)
            context.tell({.severity = Issue::Severity::Info,
                          .context = {.values = {{"text", QUADRILLE_MESSAGE("The character has no feet that "
                                                                            "could be told apart: contacts "
                                                                            "are not corrected.")}}}});
        if (animation.post.variations) {
            result.tables.push_back(repeatsTable(spans, variations, graph));
            if (const auto problem = problemWithMissing(drawn, names))
                context.tell({.context = {.values = {{"text", *problem}}}});
            if (const auto problem = problemWithRepeats(spans, graph))
                context.tell({.context = {.values = {{"text", *problem}}}});
        }
        if (processed.travel)
            result.arrays.push_back(groundMotionArray(
                "loop-travel",
                "From one playing of the loop to the next: turn about the up axis, radians, and shift over "
                "the ground, metres.",
                *processed.travel));
        return result;
    };
    return step;
}

} // namespace

std::vector<BuildStep> makeAnimationSteps(const StepMaking& making)
{
    std::vector<BuildStep> steps;
    for (const AnimationEntry& animation : making.opener->project().animations) {
        const CharacterInputs work = workOf(making, animation);
        if (work.sequences.empty())
            continue;
        const BuildStep walk = walkStep(work, animation);
        steps.push_back(walk);
        steps.push_back(clipStep(work, animation, walk));
    }
    return steps;
}

} // namespace quadrille
