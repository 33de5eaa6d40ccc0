// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/findentry.h"
#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/fields/writefields.h"
#include "model/project/steps/buildstep.h"
#include "model/project/steps/livework.h"
#include "model/project/steps/performtransfer.h"
#include "model/project/store/clipresult.h"
#include "model/project/store/tablebuilder.h"

#include <limits>

namespace quadrille {

namespace {

DataTable stateTable(const LiveEntry& entry, const PerformedLive& made, const std::vector<double>& slides)
{
    TableBuilder table("report",
                       "What was played in each frame, and how fast the feet that stand until the next "
                       "frame slide.");
    table.whole("frame", "frame").whole("tick", "ticks").text("space").real("phase", "frames");
    table.real("taken-over", "share").real("skate", "m/s");
    for (std::size_t f = 0; f < made.states.size(); ++f) {
        const LiveState& state = made.states[f];
        table.add({static_cast<std::int64_t>(f), state.tick, entry.spaces[state.track.space],
                   state.track.phase, state.fade,
                   f < slides.size() ? slides[f] : std::numeric_limits<double>::quiet_NaN()});
    }
    return std::move(table).table();
}

DataTable decisionTable(const LiveEntry& entry, const PerformedLive& made)
{
    TableBuilder table("transitions",
                       "Transitions that were made: when, since when they were wished for, what was left and "
                       "entered, how unlike both "
                       "were (0 … 1000), and what waiting cost.");
    table.whole("tick", "ticks")
        .whole("wished", "ticks")
        .text("from")
        .text("to")
        .real("dissimilarity")
        .real("latency-cost");
    table.whole("source-frames", "frames").whole("target-frames", "frames").whole("leaving-frame", "frame");
    table.whole("arrival-frame", "frame");
    for (const LiveDecision& decision : made.decisions) {
        const TransitionChoice& choice = decision.choices[0];
        table.add({decision.tick, decision.wished, entry.spaces[decision.source],
                   entry.spaces[decision.target], choice.dissimilarity, choice.latencyCost,
                   std::int64_t{choice.sourceFrames}, std::int64_t{choice.targetFrames},
                   static_cast<std::int64_t>(choice.leavingFrame),
                   static_cast<std::int64_t>(choice.arrivalFrame)});
    }
    return std::move(table).table();
}

BuildStep liveStep(const StepMaking& making, const LiveEntry& entry)
{
    const std::string clip = "live/" + entry.name;
    BuildStep step;
    step.name = clipStepOf(clip);
    step.kind = "live clip";
    step.dataPrefix = clip;
    step.character = characterNameOf(making.opener->project(), entry);
    step.version = 4;
    LiveEntry nameless = entry;
    nameless.name.clear();
    step.settings = settingsText(nameless);
    step.inputs = liveGraphSteps(entry.spaces);
    step.files = [](const Progress&) { return std::vector<std::filesystem::path>(); };
    step.compute = [opener = making.opener, entry](const StepContext& context, const Progress& progress) {
        const auto graph = liveGraphFrom(opener, entry.spaces, context, progress.part(0, 0.1));
        const LiveTakes takes(*opener, entry.spaces, progress.part(0.1, 0.3));
        const Project& project = opener->project();
        PerformedLive made = performLive(graph, entry, project, takes, progress.part(0.3, 0.9));
        MeshSequence shown = toSequence(entry.name, made.clip, takes.frames());
        DataTable states =
            stateTable(entry, made, footSlides(shown, project.settings.axes.up, progress.part(0.9, 1)));
        const double metresPerUnit = project.settings.axes.metresPerUnit;
        for (Vec3f& position : made.clip.positions)
            position *= static_cast<float>(1 / metresPerUnit);
        Result result =
            clipResult(made.clip, takes.frames().layout(), takes.names(), unitText(metresPerUnit));
        result.tables.push_back(std::move(states));
        result.tables.push_back(decisionTable(entry, made));
        return result;
    };
    return step;
}

} // namespace

std::vector<BuildStep> makeLiveSteps(const StepMaking& making)
{
    std::vector<BuildStep> steps;
    for (const LiveEntry& entry : making.opener->project().lives) {
        if (!entry.spaces.empty() && !entry.inputs.empty())
            steps.push_back(liveStep(making, entry));
    }
    return steps;
}

} // namespace quadrille
