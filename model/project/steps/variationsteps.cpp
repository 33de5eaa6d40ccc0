// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/variationsteps.h"

#include "model/core/random.h"
#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/fields/writefields.h"
#include "model/project/steps/buildstep.h"
#include "model/project/steps/selectionnote.h"
#include "model/project/steps/variate.h"
#include "model/project/steps/variationresults.h"
#include "model/project/store/clipresult.h"
#include "model/variation/selectionspread.h"

#include <algorithm>

namespace quadrille {

namespace {

/// All samples of an entry with the settings of their chains.
std::string samplesSettings(const VariationEntry& entry)
{
    VariationEntry drawn;
    drawn.samples = entry.samples;
    for (SamplesEntry& samples : drawn.samples)
        samples.discarded.clear();
    drawn.chain = entry.chain;
    drawn.extent = entry.extent;
    return settingsText(drawn);
}

/// What is judged, and how.
std::string selectionSettings(const VariationEntry& entry)
{
    VariationEntry judged;
    judged.limits = entry.limits;
    judged.draw = entry.draw;
    judged.correctsContacts = entry.correctsContacts;
    return samplesSettings(entry) + settingsText(judged);
}

/// The steps of one entry of “variations”.
class VariationSteps
{
public:
    VariationSteps(std::shared_ptr<VariationWork> work)
        : m_work(std::move(work))
        , m_name(m_work->entry().name)
        , m_parts(partNamesOf(m_work->project(), m_work->entry()))
    {
    }

    std::vector<BuildStep> make() const
    {
        std::vector<BuildStep> steps{alignment()};
        for (std::size_t p = 0; p < m_parts.size(); ++p) {
            steps.push_back(model(p));
            steps.push_back(samples(p));
        }
        steps.push_back(selection());
        for (int number = 1; number <= variationCount(m_work->entry()); ++number)
            steps.push_back(clip(number));
        return steps;
    }

private:
    /// \param kind  the same for all variations.
    BuildStep step(std::string kind, std::string name, std::string prefix) const
    {
        BuildStep made;
        made.name = std::move(name);
        made.kind = std::move(kind);
        made.dataPrefix = std::move(prefix);
        made.character = m_work->character();
        return made;
    }

    BuildStep alignment() const
    {
        BuildStep made = step("variation alignment", alignmentStepOf(m_name), "variations/" + m_name);
        made.version = 7;
        made.settings = m_work->movementSettings();
        made.files = [work = m_work](const Progress& progress) { return work->files(progress); };
        made.inputs = m_work->clipSteps();
        made.compute = [work = m_work](const StepContext& context, const Progress& progress) {
            const auto movement = work->movement(progress);
            if (const auto note = noteOnCycles(*movement))
                context.tell({.severity = Issue::Severity::Info, .context = {.values = {{"text", *note}}}});
            return alignmentResult(*movement);
        };
        return made;
    }

    BuildStep model(std::size_t part) const
    {
        BuildStep made = step("variation model of " + m_parts[part], modelStepOf(m_name, m_parts[part]),
                              "variations/" + m_name + "/" + m_parts[part]);
        VariationEntry learned;
        learned.learning = m_work->entry().learning;
        made.version = 3;
        made.settings = settingsText(learned);
        made.inputs = {alignmentStepOf(m_name)};
        made.compute = [work = m_work, name = m_parts[part]](const StepContext& context,
                                                             const Progress& progress) {
            const auto movement = work->movement(progress.part(0, 0.1));
            const PartTraining& training = movement->training.at(movement->parts.indexOf(name));
            GpdmLearning best{.stop = GpdmStop::Cancelled};
            const GpdmWatch watch = [&](int /*iteration*/, double objective, const GpdmState& state) {
                best.objective.push_back(objective);
                best.state = state;
                context.improved(modelProgressResult(best));
            };
            const GpdmLearning learning =
                learnGpdm(training.rows, training.spans, work->entry().learning, progress.part(0.1, 1),
                          context.improved ? watch : GpdmWatch());
            Result result = modelResult(training, learning, work->takeNames());
            if (context.improved)
                context.improved(result);
            // What was cancelled is no result of the settings.
            progress.report(1);
            return result;
        };
        return made;
    }

    BuildStep samples(std::size_t part) const
    {
        BuildStep made = step("variation samples of " + m_parts[part], samplesStepOf(m_name, m_parts[part]),
                              "variations/" + m_name + "/" + m_parts[part]);
        const std::string model = modelStepOf(m_name, m_parts[part]);
        made.version = 6;
        made.settings = samplesSettings(m_work->entry());
        made.inputs = {model};
        made.compute = [work = m_work, name = m_parts[part], model](const StepContext& context,
                                                                    const Progress& progress) {
            const auto movement = work->movement(progress.part(0, 0.1));
            const std::size_t index = movement->parts.indexOf(name);
            const GpdmState state = stateOf(*context.resultOf(model));
            const std::vector<SamplesEntry>& sets = work->entry().samples;
            const SamplingSettings settings{work->entry().chain, work->entry().extent};
            std::vector<PartVariations> drawn;
            for (std::size_t s = 0; s < sets.size(); ++s) {
                const double share = 0.9 / static_cast<double>(sets.size());
                const double at = 0.1 + share * static_cast<double>(s);
                drawn.push_back(drawPart(*movement, index, state, work->subject(sets[s]),
                                         candidatesFor(sets[s].count), sets[s].seed, settings,
                                         progress.part(at, at + share)));
            }
            return samplesResult(drawn, movement->alignment.frameCount(), state.latents.cols());
        };
        return made;
    }

    BuildStep selection() const
    {
        BuildStep made = step("variation selection", selectionStepOf(m_name), "variations/" + m_name);
        made.version = 7;
        made.settings = selectionSettings(m_work->entry());
        made.inputs = drawnSteps();
        made.compute = [self = *this](const StepContext& context, const Progress& progress) {
            return self.selected(context, progress);
        };
        return made;
    }

    /// What was made of the latents of all parts, and how it was judged.
    struct Selected
    {
        std::vector<VariationSelection> selections; ///< of each set, with their clips
        std::vector<std::vector<PartSpread>> spreads;
    };

    /// Clips are made to be judged: their steps need not make them once more.
    std::string selectedName() const { return selectionSettings(m_work->entry()); }

    Result selected(const StepContext& context, const Progress& progress) const
    {
        const auto all = context.shared<const Selected>(drawnSteps(), selectedName(), [&] {
            return std::make_shared<const Selected>(select(context, progress));
        });
        const std::vector<SamplesEntry>& sets = m_work->entry().samples;
        for (std::size_t s = 0; s < sets.size(); ++s) {
            if (const auto note = noteOn(sets[s], all->selections[s]))
                context.tell({.severity = note->isShort ? Issue::Severity::Warning : Issue::Severity::Info,
                              .context = {.values = {{"text", note->text}}}});
        }
        return selectionResult(m_work->entry(), all->selections, all->spreads);
    }

    Selected select(const StepContext& context, const Progress& progress) const
    {
        const auto learned = m_work->learned(models(context), progress.part(0, 0.1));
        const auto latents = allLatents(context);
        const VariationMeter meter = m_work->meter(progress.part(0.1, 0.2));
        Selected all;
        const std::vector<SamplesEntry>& sets = m_work->entry().samples;
        for (std::size_t s = 0; s < sets.size(); ++s) {
            const double share = 0.8 / static_cast<double>(sets.size());
            const double at = 0.2 + share * static_cast<double>(s);
            all.selections.push_back(selectVariations(
                *learned, m_work->subject(sets[s]), latents[s], sets[s].count, sets[s].seed, m_work->poses(),
                meter, m_work->layout(), m_work->entry().limits, progress.part(at, at + 0.8 * share)));
            all.spreads.push_back(selectionSpread(*learned, latents[s], all.selections.back(),
                                                  m_work->poses(), sets[s].seed,
                                                  progress.part(at + 0.8 * share, at + share)));
        }
        return all;
    }

    BuildStep clip(int number) const
    {
        const std::string name = variationClip(m_name, number);
        BuildStep made = step("variation clip", clipStepOf(name), name);
        made.version = 7;
        VariationEntry drawn;
        drawn.draw = m_work->entry().draw;
        drawn.correctsContacts = m_work->entry().correctsContacts;
        made.settings = settingsText(drawn) + std::to_string(number);
        made.inputs = drawnSteps();
        made.inputs.push_back(selectionStepOf(m_name));
        made.compute = [self = *this, number](const StepContext& context, const Progress& progress) {
            return self.oneClip(number, context, progress);
        };
        return made;
    }

    Result oneClip(int number, const StepContext& context, const Progress& progress) const
    {
        const SamplePlace place = *placeOfVariation(m_work->entry(), number);
        const SamplesEntry& samples = m_work->entry().samples[place.set];
        const auto candidate = candidateOf(*context.resultOf(selectionStepOf(m_name)), number);
        if (!candidate) // the selection has told that it is missing
            return {};
        if (const auto all = context.existing<const Selected>(drawnSteps(), selectedName())) {
            const VariationSelection& set = all->selections[place.set];
            const auto accepted = std::ranges::find(set.accepted, *candidate);
            return resultOf(set.clips.at(static_cast<std::size_t>(accepted - set.accepted.begin())));
        }
        const auto learned = m_work->learned(models(context), progress.part(0, 0.2));
        VariationPoses poses = m_work->poses();
        poses.seed = streamSeed(samples.seed, static_cast<std::uint64_t>(*candidate));
        const Clip made =
            makeVariation(*learned, m_work->subject(samples),
                          allLatents(context)[place.set].at(static_cast<std::size_t>(*candidate)),
                          m_work->layout(), poses, progress.part(0.2, 1));
        return resultOf(made);
    }

    Result resultOf(const Clip& made) const
    {
        std::vector<std::string> takes;
        for (const TrainingEntry& take : m_work->entry().training)
            takes.push_back(take.sequence);
        return clipResult(m_work->inProjectUnit(made), m_work->layout(), takes,
                          unitText(m_work->project().settings.axes.metresPerUnit));
    }

    std::vector<std::string> drawnSteps() const
    {
        std::vector<std::string> inputs;
        for (const std::string& part : m_parts) {
            inputs.push_back(modelStepOf(m_name, part));
            inputs.push_back(samplesStepOf(m_name, part));
        }
        return inputs;
    }

    std::vector<GpdmState> models(const StepContext& context) const
    {
        std::vector<GpdmState> states;
        for (const BodyPart& part : m_work->movement()->parts.parts)
            states.push_back(stateOf(*context.resultOf(modelStepOf(m_name, part.name))));
        return states;
    }

    /// Of each set of samples its candidates.
    std::vector<std::vector<LatentVariation>> allLatents(const StepContext& context) const
    {
        std::vector<std::vector<LatentVariation>> sets;
        for (const SamplesEntry& samples : m_work->entry().samples)
            sets.emplace_back(static_cast<std::size_t>(candidatesFor(samples.count)));
        for (const BodyPart& part : m_work->movement()->parts.parts) {
            std::vector<RowMatrix> all = trajectoriesOf(*context.resultOf(samplesStepOf(m_name, part.name)));
            std::size_t next = 0;
            for (auto& set : sets) {
                for (LatentVariation& variation : set)
                    variation.push_back(std::move(all.at(next++)));
            }
        }
        return sets;
    }

    std::shared_ptr<VariationWork> m_work;
    std::string m_name;
    std::vector<std::string> m_parts;
};

} // namespace

std::string alignmentStepOf(const std::string& variation)
{
    return "variations/" + variation + "/alignment";
}

std::string modelStepOf(const std::string& variation, const std::string& part)
{
    return "variations/" + variation + "/" + part + "/model";
}

std::string samplesStepOf(const std::string& variation, const std::string& part)
{
    return "variations/" + variation + "/" + part + "/samples";
}

std::string selectionStepOf(const std::string& variation)
{
    return "variations/" + variation + "/selection";
}

std::vector<BuildStep> makeVariationSteps(const StepMaking& making)
{
    std::vector<BuildStep> steps;
    for (const VariationEntry& entry : making.opener->project().variations) {
        if (entry.training.empty())
            continue;
        for (BuildStep& step :
             VariationSteps(std::make_shared<VariationWork>(making.opener, entry, making.session)).make())
            steps.push_back(std::move(step));
    }
    return steps;
}

} // namespace quadrille
