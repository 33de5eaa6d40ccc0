// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/selectionnote.h"

#include <array>
#include <string_view>

namespace quadrille {

std::optional<SelectionNote> noteOn(const SamplesEntry& samples, const VariationSelection& selection)
{
    constexpr std::array<std::string_view, variationFaults> reasons{
        "poses unlike all that were learned", "sliding feet",
        "a surface that goes through itself", "a body that swells or shrinks",
        "a region of the body that crumples", "sinking into the ground"};
    if (selection.rejectedCount() == 0)
        return std::nullopt;
    std::array<int, variationFaults> counts{};
    for (const Candidate& candidate : selection.candidates) {
        for (const VariationFault fault : candidate.faults)
            counts[static_cast<std::size_t>(fault)] += 1;
    }
    std::string parts;
    for (std::size_t fault = 0; fault < variationFaults; ++fault) {
        if (counts[fault] > 0)
            parts += (parts.empty() ? "" : ", ") + std::string(reasons[fault]) + " (" +
                     std::to_string(counts[fault]) + ")";
    }
    SelectionNote note{.isShort = std::ssize(selection.accepted) < samples.count};
    const std::string of =
        samples.to.empty() ? "“" + samples.of + "”" : "“" + samples.of + "” and “" + samples.to + "”";
    if (note.isShort)
        note.text = "Only " + std::to_string(selection.accepted.size()) + " of " +
                    std::to_string(samples.count) + " variations of " + of + " were good enough. ";
    note.text += "Of " + std::to_string(selection.candidates.size()) + " that were drawn of " + of + ", " +
                 std::to_string(selection.rejectedCount()) + " were rejected: " + parts + ".";
    if (note.isShort)
        note.text += " Draw with another seed, or allow more in the limits.";
    return note;
}

std::optional<std::string> noteOnCycles(const Movement& movement)
{
    const Alignment& alignment = movement.alignment;
    std::string takes;
    for (std::size_t t = 0; t < alignment.reports.size(); ++t) {
        const TakeUse use = alignment.reports[t].use;
        if (use == TakeUse::NoCycle || use == TakeUse::TooShort)
            takes += (takes.empty() ? "“" : ", “") + movement.take(t).name + "”";
    }
    if (takes.empty())
        return std::nullopt;
    return "No cycle like that of “" + movement.take(alignment.reference).name + "” was found in " + takes +
           ": all frames are learned as if they were one. Give the range of one cycle, or leave them out.";
}

} // namespace quadrille
