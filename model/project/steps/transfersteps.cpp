// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/steps/buildstep.h"
#include "model/project/steps/performtransfer.h"
#include "model/project/steps/transferwork.h"
#include "model/project/store/clipresult.h"
#include "model/project/store/tablebuilder.h"

#include <limits>
#include <numbers>

namespace quadrille {

namespace {

DataTable frameReport(const PerformedTransfer& made, const std::vector<double>& slides,
                      const std::vector<LimbErrors>& limbs)
{
    TableBuilder table("report",
                       "How each frame came out: the target's volume against that at rest, the mean "
                       "angle that marked triangles miss, how fast the feet that stand until the "
                       "next frame slide, and the mean angles by which lower arms and legs, and feet, point "
                       "elsewhere than the template's.");
    table.whole("frame", "frame").real("volume", "").real("mark-error", "deg").real("skate", "m/s");
    table.real("limb-error", "deg").real("foot-error", "deg");
    constexpr double degrees = 180 / std::numbers::pi;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t f = 0; f < slides.size(); ++f)
        table.add({static_cast<std::int64_t>(f), made.volume.empty() ? unknown : made.volume[f],
                   made.markErrors[f] * degrees, slides[f], limbs[f].limbs * degrees,
                   limbs[f].feet * degrees});
    return std::move(table).table();
}

/// Which triangles were paired.
DataTable pairTable(std::span<const ProposedPair> pairs)
{
    TableBuilder table("pairs", "Triangles that turn alike, and how alike the places of proposed ones are: 1 "
                                "where nothing tells them apart.");
    table.whole("template-triangle").whole("target-triangle").real("quality");
    for (const ProposedPair& proposed : pairs)
        table.add({static_cast<std::int64_t>(proposed.pair.onTemplate.value),
                   static_cast<std::int64_t>(proposed.pair.onTarget.value), proposed.quality});
    return std::move(table).table();
}

Result transferResult(const TransferWork& work, const StepContext& context, const Progress& progress)
{
    const auto tell = [&context](std::string text) {
        context.tell({.severity = Issue::Severity::Info, .context = {.values = {{"text", std::move(text)}}}});
    };
    const TransferBodies bodies(work.opener(), work.entry(), progress.part(0, 0.1));
    const TransferMarks marks = transferMarks(bodies, tell, progress.part(0.1, 0.3));
    PerformedTransfer made = performTransfer(bodies, marks, bodies.settings(), tell, progress.part(0.3, 0.9));
    DataTable frames = frameReport(
        made, footSlides(standingAs(bodies.performed(), made.clip), bodies.up(), progress.part(0.9, 0.95)),
        limbErrors(bodies, marks.reference, made.clip, progress.part(0.95, 1)));
    const double metresPerUnit = work.opener().project().settings.axes.metresPerUnit;
    const auto unitsPerMetre = static_cast<float>(1 / metresPerUnit);
    for (Vec3f& p : made.clip.positions)
        p *= unitsPerMetre;
    const FrameLayout layout = CharacterFrames(std::span(&bodies.targetSequence()->sequence, 1)).layout();
    Result result = clipResult(made.clip, layout, {work.entry().target.sequence}, unitText(metresPerUnit));
    result.tables.push_back(std::move(frames));
    result.tables.push_back(pairTable(marks.chosen));
    return result;
}

} // namespace

std::vector<BuildStep> makeTransferSteps(const StepMaking& making)
{
    std::vector<BuildStep> steps;
    for (const TransferEntry& entry : making.opener->project().transfers) {
        const auto work = std::make_shared<const TransferWork>(making.opener, entry);
        BuildStep step;
        step.name = clipStepOf(work->clipName());
        step.kind = "transferred clip";
        step.dataPrefix = work->clipName();
        step.version = TransferWork::version;
        step.character = work->character();
        step.settings = work->settings();
        step.files = [work](const Progress& progress) { return work->files(progress); };
        step.inputs = work->inputs();
        step.compute = [work](const StepContext& context, const Progress& progress) {
            return transferResult(*work, context, progress);
        };
        steps.push_back(std::move(step));
    }
    return steps;
}

} // namespace quadrille
