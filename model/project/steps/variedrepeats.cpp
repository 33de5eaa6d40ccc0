// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/variedrepeats.h"

#include "model/core/contains.h"
#include "model/core/error.h"
#include "model/core/message.h"
#include "model/project/document/clipdependencies.h"
#include "model/project/document/madeclips.h"
#include "model/project/steps/charactersteps.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>
#include <map>
#include <set>

namespace quadrille {

namespace {

} // namespace

std::optional<TakeVariation> takeVariation(const std::string& clip, const Result& result,
                                           const CharacterGraph& graph)
{
    if (result.tables.empty())
        return std::nullopt;
    const DataTable& frames = result.tables.front();
    const auto& sequences = columnNamed<TextColumn>(frames, "sequence");
    const auto& sources = columnNamed<std::vector<std::int64_t>>(frames, "source-frame");
    TakeVariation variation{.name = clip,
                            .first = graph.node({sequences.front(), FrameIndex(sources.front())}),
                            .last = graph.node({sequences.back(), FrameIndex(sources.back())}),
                            .positions = {}};
    // Evenly faster or slower it has the tempo of the take.
    const DataArray& positions = arrayOf(result, "positions");
    const auto& values = std::get<std::vector<float>>(positions.values);
    const auto own = static_cast<std::size_t>(positions.shape[0]);
    const auto vertices = static_cast<std::size_t>(positions.shape[1]);
    const auto wanted = static_cast<std::size_t>(variation.frameCount());
    const auto at = [&](std::size_t frame, std::size_t vertex) {
        return Vec3f(&values[3 * (frame * vertices + vertex)]);
    };
    variation.positions.reserve(wanted * vertices);
    for (std::size_t f = 0; f < wanted; ++f) {
        const double place = wanted > 1 ? static_cast<double>(f) * static_cast<double>(own - 1) /
                                              static_cast<double>(wanted - 1)
                                        : 0;
        const auto before = std::min(static_cast<std::size_t>(place), own - 1);
        const auto after = std::min(before + 1, own - 1);
        const auto share = static_cast<float>(place - static_cast<double>(before));
        for (std::size_t v = 0; v < vertices; ++v)
            variation.positions.emplace_back((1 - share) * at(before, v) + share * at(after, v));
    }
    return variation;
}

std::shared_ptr<const std::vector<TakeVariation>>
takeVariations(const std::vector<std::string>& clips, const CharacterGraph& graph, const StepContext& context)
{
    std::vector<std::string> steps{graph.work().stepName(graphstep::poseDistance)};
    std::string names;
    for (const std::string& clip : clips) {
        steps.push_back(clipStepOf(clip));
        names += clip + '\n';
    }
    return context.shared<const std::vector<TakeVariation>>(steps, names, [&] {
        std::vector<TakeVariation> variations;
        for (const std::string& clip : clips) {
            if (auto variation = takeVariation(clip, *context.resultOf(clipStepOf(clip)), graph))
                variations.push_back(std::move(*variation));
        }
        return std::make_shared<const std::vector<TakeVariation>>(std::move(variations));
    });
}

DataTable repeatsTable(std::span<const SpanDraw> spans, std::span<const TakeVariation> variations,
                       const CharacterGraph& graph)
{
    TableBuilder table("variations", "What each span of the animation is drawn from: captured frames, or a "
                                     "variation of some of them. A loop has as many playings as repeats.");
    const std::size_t playings =
        spans.empty() ? 1 : static_cast<std::size_t>(spans.back().playing) + 1; // each of as many spans
    const std::size_t each = spans.size() / playings;
    table.whole("playing").whole("span").text("sequence").whole("first", "frame").whole("last", "frame");
    table.whole("shown-from", "frame").text("repeat").text("variation");
    table.whole("varied-first", "frame").whole("varied-last", "frame");
    for (std::size_t s = 0; s < spans.size(); ++s) {
        if (!spans[s].frames)
            continue;
        const auto [first, last] = *spans[s].frames;
        const auto frameOf = [&](NodeIndex node) { return graph.nameOf(node).frame.value; };
        std::string name;
        std::int64_t variedFirst = -1;
        std::int64_t variedLast = -1;
        if (spans[s].variation) {
            const TakeVariation& variation = variations[*spans[s].variation];
            name = variation.name;
            variedFirst = frameOf(std::max(first, variation.first));
            variedLast = frameOf(std::min(last, variation.last));
        }
        table.add({std::int64_t{spans[s].playing} + 1, static_cast<std::int64_t>(s % each) + 1,
                   graph.nameOf(first).sequence, frameOf(first), frameOf(last), spans[s].start,
                   spans[s].isRepeat ? "yes" : "no", name, variedFirst, variedLast});
    }
    return std::move(table).table();
}

std::optional<std::string> problemWithMissing(const std::vector<std::string>& wanted,
                                              const std::vector<std::string>& found)
{
    std::string missing;
    for (const std::string& clip : wanted) {
        if (!contains(found, clip))
            missing += (missing.empty() ? "“" : ", “") + clip + "”";
    }
    if (missing.empty())
        return std::nullopt;
    return "Too few variations were good enough: " + missing +
           (found.empty() ? " are missing." : " are missing, and others are shown in their place.");
}

std::optional<std::string> problemWithRepeats(std::span<const SpanDraw> spans, const CharacterGraph& graph)
{
    std::set<std::string> asCaptured;
    bool hasRepeats = false;
    for (const SpanDraw& span : spans) {
        hasRepeats = hasRepeats || span.isRepeat;
        if (span.isRepeat && !span.variation)
            asCaptured.insert("“" + graph.nameOf(span.frames->first).sequence + "”");
    }
    if (!hasRepeats)
        return "No captured frames are shown twice, so that nothing is drawn from variations.";
    if (asCaptured.empty())
        return std::nullopt;
    std::string takes;
    for (const std::string& take : asCaptured)
        takes += (takes.empty() ? "" : ", ") + take;
    return "Frames are shown again as they were captured, for no variation varies them: of " + takes + ".";
}

} // namespace quadrille
