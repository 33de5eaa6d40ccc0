// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// The name of one variation, from 1: "variations/NAME/3".
std::string variationClip(const std::string& variation, int number);

/// A variation in a clip "variations/NAME/3".
struct VariationNumber
{
    std::string variation;
    int number = 0; ///< from 1; 0: all of "variations/NAME"

    bool operator==(const VariationNumber&) const = default;
};
/// Nothing for clips of other sections, and where the number is none.
std::optional<VariationNumber> variationOfClip(std::string_view clip);
/// The performance that a clip "live/NAME" is; null where it is none, or there is no such.
const LiveEntry* liveOfClip(const Project& project, std::string_view clip);
/// The takes of motion spaces, each once.
std::vector<std::string> takesOfSpaces(const Project& project, const std::vector<std::string>& spaces);
/// The transfer that a clip "transfers/NAME" is; null where it is none, or there is no such.
const TransferEntry* transferOfClip(const Project& project, std::string_view clip);
/// The projection that a clip "projections/NAME" is; null where it is none, or there is no such.
const ProjectionEntry* projectionOfClip(const Project& project, std::string_view clip);
/// The clip whose frames a clip shows with other textures, perhaps through several projections; itself where
/// it is none. Empty where projections go round in a circle.
std::string clipBelow(const Project& project, const std::string& clip);
/// The sequences in which the pose of a transfer's template is found that is like the target's: the one that
/// the entry names, or all captured ones of the template's character.
std::vector<std::string> templateSequences(const Project& project, const TransferEntry& transfer);
/// The transfers that a character performs and that say what the result ought to be.
std::vector<const TransferEntry*> transfersWithTruth(const Project& project, const std::string& character);
/// How many variations an entry draws.
int variationCount(const VariationEntry& entry);

/// Whether the user threw a variation away.
bool isDiscarded(const VariationEntry& entry, int number);
/// Where a variation of an entry, counted from 1, is found: in which set of samples, and as which of it, from
/// 0. Nothing where there are fewer.
struct SamplePlace
{
    std::size_t set = 0;
    int index = 0;
};
std::optional<SamplePlace> placeOfVariation(const VariationEntry& entry, int number);
/// The variations of a character that have takes to learn from.
std::vector<const VariationEntry*> learnedVariations(const Project& project, const std::string& character);
/// Names of the parts that an entry learns, the root first; “body” where it is not cut.
std::vector<std::string> partNamesOf(const Project& project, const VariationEntry& entry);

/// Whether a clip is one that steps make: "animations/NAME", "live/NAME", "transfers/NAME",
/// "projections/NAME" or "variations/NAME/3".
bool isMadeClip(std::string_view clip);
/// The step that makes it; of a projection that of its textures. \pre isMadeClip.
std::string clipStepOf(const std::string& clip);
/// The steps of the clips that a clip "SECTION/NAME" means, for all of "variations/NAME" those that were not
/// discarded; none where it is a sequence that shows a file.
std::vector<std::string> clipStepsOf(const Project& project, const std::string& clip);

/// The steps of the clips that some sequences show: their inputs.
std::vector<std::string> clipInputs(const Project& project, const std::vector<std::string>& sequences);

/// The clip that a sequence shows, perhaps through other sequences, where it is made; nothing where it shows
/// files.
std::optional<std::string> shownClip(const Project& project, const SequenceEntry& entry);

/// The sequences whose frames a made clip shows, in the order in which its origins count them; empty where
/// there is no such clip.
std::vector<std::string> sequencesOfClip(const Project& project, const std::string& clip);

/// The character of a clip “SECTION/NAME”; empty where there is none.
std::string characterOfClip(const Project& project, const std::string& clip);

/// The sequences that the graph of a character is made of, in project order: all of the character's but those
/// that are clips of its own animations, or variations of such.
std::vector<std::string> sequencesOfGraph(const Project& project, const std::string& character);

} // namespace quadrille
