// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/variationmeasures.h"
#include "model/project/document/madeclips.h"
#include "model/project/evaluations/evaluationsteps.h"
#include "model/project/steps/variate.h"
#include "model/project/steps/variationresults.h"
#include "model/project/steps/variationsteps.h"
#include "model/project/store/clipresult.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace quadrille {

namespace {

constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();

/// What there is of the variations of a set of samples.
struct ComparedSet
{
    std::vector<VariationComparison> variations;
    std::vector<std::int64_t> lengths;

    template <typename Value>
    double mean(Value value) const
    {
        double sum = 0;
        int count = 0;
        for (const VariationComparison& each : variations) {
            const std::optional<double> own = value(each);
            sum += own.value_or(0);
            count += own ? 1 : 0;
        }
        return count > 0 ? sum / count : unmeasured;
    }
    template <typename Value>
    double greatest(Value value) const
    {
        double most = variations.empty() ? unmeasured : value(variations.front());
        for (const VariationComparison& each : variations)
            most = std::max(most, value(each));
        return most;
    }
    /// Between the longest and the shortest, as a share of the mean.
    double lengthSpread() const
    {
        if (lengths.empty())
            return unmeasured;
        const auto [least, most] = std::ranges::minmax(lengths);
        double sum = 0;
        for (const std::int64_t length : lengths)
            sum += static_cast<double>(length);
        return static_cast<double>(most - least) * static_cast<double>(lengths.size()) / sum;
    }
};

class ComparisonTable
{
public:
    ComparisonTable()
    {
        m_table.text("variation").text("of").text("to").real("weight").whole("asked").whole("delivered");
        m_table.whole("drawn");
        for (std::size_t fault = 0; fault < variationFaults; ++fault)
            m_table.whole("rejected-" + std::string(toString(static_cast<VariationFault>(fault))));
        m_table.real("acceleration").real("greatest-acceleration").real("centre-acceleration");
        m_table.real("slide").real("sink", "m").real("hover", "m").real("heading", "degrees");
        m_table.real("take-step").real("step").real("length-spread").real("closing", "m");
    }

    void add(const VariationEntry& entry, const SamplesEntry& samples, const VariationSelection& selection,
             const ComparedSet& set, bool isCycle)
    {
        std::array<std::int64_t, variationFaults> rejected{};
        for (const Candidate& candidate : selection.candidates) {
            for (const VariationFault fault : candidate.faults)
                rejected[static_cast<std::size_t>(fault)] += 1;
        }
        std::vector<TableBuilder::Cell> cells{entry.name,
                                              samples.of,
                                              samples.to,
                                              samples.weight,
                                              std::int64_t{samples.count},
                                              std::ssize(set.variations),
                                              std::ssize(selection.candidates)};
        cells.insert(cells.end(), rejected.begin(), rejected.end());
        using Of = VariationComparison;
        const double degrees = 180 / std::numbers::pi;
        for (const double value :
             {set.mean([](const Of& v) { return v.acceleration; }),
              set.greatest([](const Of& v) { return v.acceleration; }),
              set.mean([](const Of& v) { return v.centreAcceleration; }),
              set.mean([](const Of& v) { return v.slide; }), set.greatest([](const Of& v) { return v.sink; }),
              set.greatest([](const Of& v) { return v.hover; }),
              degrees * set.greatest([](const Of& v) { return v.heading; }),
              set.mean([](const Of& v) { return v.takeStep; }), set.mean([](const Of& v) { return v.step; }),
              set.lengthSpread(), isCycle ? set.mean([](const Of& v) { return v.closing; }) : unmeasured})
            cells.emplace_back(value);
        m_table.add(cells);
    }

    Result result() &&
    {
        Result result;
        result.tables = {std::move(m_table).table()};
        return result;
    }

private:
    TableBuilder m_table{
        "variations",
        "What shows of the variations of each set, beside the captured frames that they follow: "
        "accelerations and sliding of standing feet as multiples of the take's, of all vertices and of the "
        "centre; the deepest point below and the greatest height above the take's, the greatest turn from "
        "it; how limbs that swing together or against each other in the take correlate; the spread of "
        "lengths, and how much further cycles end from where they began; and why others were rejected."};
};

ComparedSet comparedSet(VariationWork& work, std::size_t set, const StepContext& context)
{
    const UpAxis up = work.project().settings.axes.up;
    const auto movement = work.movement();
    const CharacterFrames& frames = work.frames();
    const Stances stances = findStances(frames, up);
    const auto metres = static_cast<float>(work.project().settings.axes.metresPerUnit);
    ComparedSet compared;
    for (int number = 1; number <= variationCount(work.entry()); ++number) {
        if (placeOfVariation(work.entry(), number)->set != set)
            continue;
        auto clip = clipOf(*context.resultOf(clipStepOf(variationClip(work.entry().name, number))),
                           frames.sequences(), movement->alignment.fps);
        if (!clip)
            continue;
        for (Vec3f& position : clip->positions)
            position *= metres;
        const FollowedTake take = followedTake(*clip, frames);
        compared.variations.push_back(quadrille::compared(measureMoved(*clip, *movement, stances, up),
                                                          measureMoved(take.clip, *movement, stances, up),
                                                          take.frames, up));
        compared.lengths.push_back(clip->frameCount());
    }
    return compared;
}

} // namespace

BuildStep variationsStep(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    std::vector<std::shared_ptr<VariationWork>> works;
    for (const VariationEntry* entry : learnedVariations(work.opener->project(), work.character))
        works.push_back(std::make_shared<VariationWork>(work.opener, *entry));
    BuildStep step = evaluationStep(work, evaluation);
    for (const auto& each : works) {
        const std::string& name = each->entry().name;
        step.inputs.push_back(selectionStepOf(name));
        for (int number = 1; number <= variationCount(each->entry()); ++number)
            step.inputs.push_back(clipStepOf(variationClip(name, number)));
    }
    step.compute = [works](const StepContext& context, const Progress& progress) {
        ComparisonTable table;
        for (std::size_t w = 0; w < works.size(); ++w) {
            progress.report(static_cast<std::int64_t>(w), static_cast<std::int64_t>(works.size()));
            const VariationEntry& entry = works[w]->entry();
            const auto selections = selectionsOf(*context.resultOf(selectionStepOf(entry.name)), entry);
            const bool isCycle = works[w]->movement()->alignment.cycle.has_value();
            for (std::size_t s = 0; s < selections.size(); ++s)
                table.add(entry, entry.samples[s], selections[s], comparedSet(*works[w], s, context),
                          isCycle);
        }
        return std::move(table).result();
    };
    return step;
}

} // namespace quadrille
