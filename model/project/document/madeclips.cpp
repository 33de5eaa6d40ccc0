// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/madeclips.h"

#include "model/project/document/findentry.h"
#include "model/project/document/paths.h"

#include <algorithm>
#include <charconv>
#include <set>

namespace quadrille {

namespace {

constexpr auto animationsSection = "animations";
constexpr auto variationsSection = "variations";
constexpr auto liveSection = "live";
constexpr auto transfersSection = "transfers";
constexpr auto projectionsSection = "projections";

/// Whether a clip is, directly or through others, one of an animation of a character.
class AnimationSearch
{
public:
    AnimationSearch(const Project& project, const std::string& character)
        : m_project(project), m_character(character)
    {
    }

    bool finds(const SequenceEntry& entry)
    {
        if (!m_seen.insert(entry.name).second)
            return false;
        const auto clip = clipOfSource(entry.source);
        return clip && findsClip(*clip);
    }

private:
    bool findsClip(const std::string& clip)
    {
        if (const auto name = nameOfClip(clip, animationsSection)) {
            const AnimationEntry* animation = findAnimation(m_project, *name);
            return animation != nullptr && characterNameOf(m_project, *animation) == m_character;
        }
        if (const auto name = nameOfClip(clip, "sequences"))
            return findsIn(*name);
        if (const TransferEntry* transfer = transferOfClip(m_project, clip))
            return m_seen.insert(clip).second &&
                   (findsIn(transfer->target.sequence) || findsClip(transfer->clip));
        if (projectionOfClip(m_project, clip) != nullptr)
            return findsClip(clipBelow(m_project, clip));
        if (liveOfClip(m_project, clip) != nullptr) {
            const std::vector<std::string> takes = sequencesOfClip(m_project, clip);
            return std::ranges::any_of(takes, [this](const std::string& take) { return findsIn(take); });
        }
        const auto varied = variationOfClip(clip);
        const VariationEntry* variation = varied ? findVariation(m_project, varied->variation) : nullptr;
        return variation != nullptr &&
               std::any_of(variation->training.begin(), variation->training.end(),
                           [this](const TrainingEntry& take) { return findsIn(take.sequence); });
    }
    bool findsIn(const std::string& name)
    {
        const SequenceEntry* sequence = findSequence(m_project, name);
        return sequence != nullptr && finds(*sequence);
    }

    const Project& m_project;
    const std::string& m_character;
    std::set<std::string> m_seen;
};

} // namespace

std::string variationClip(const std::string& variation, int number)
{
    return std::string(variationsSection) + "/" + variation + "/" + std::to_string(number);
}

std::optional<VariationNumber> variationOfClip(std::string_view clip)
{
    const auto rest = nameOfClip(clip, variationsSection);
    if (!rest)
        return std::nullopt;
    const auto slash = rest->find('/');
    if (slash == std::string::npos)
        return VariationNumber{*rest, 0};
    VariationNumber found{rest->substr(0, slash), 0};
    const char* const last = rest->data() + rest->size();
    const auto [end, error] = std::from_chars(rest->data() + slash + 1, last, found.number);
    if (error != std::errc() || end != last || found.number < 1)
        return std::nullopt;
    return found;
}

const LiveEntry* liveOfClip(const Project& project, std::string_view clip)
{
    const auto name = nameOfClip(clip, liveSection);
    return name ? findLive(project, *name) : nullptr;
}

const TransferEntry* transferOfClip(const Project& project, std::string_view clip)
{
    const auto name = nameOfClip(clip, transfersSection);
    return name ? findTransfer(project, *name) : nullptr;
}

const ProjectionEntry* projectionOfClip(const Project& project, std::string_view clip)
{
    const auto name = nameOfClip(clip, projectionsSection);
    return name ? findProjection(project, *name) : nullptr;
}

std::string clipBelow(const Project& project, const std::string& clip)
{
    std::string below = clip;
    for (std::size_t steps = 0; steps <= project.projections.size(); ++steps) {
        const ProjectionEntry* projection = projectionOfClip(project, below);
        if (projection == nullptr)
            return below;
        below = projection->clip;
    }
    return {};
}

std::vector<std::string> templateSequences(const Project& project, const TransferEntry& transfer)
{
    if (transfer.reference)
        return {transfer.reference->sequence};
    std::vector<std::string> names;
    const std::string character = characterOfClip(project, transfer.clip);
    for (const SequenceEntry& entry : project.sequences) {
        const CharacterEntry* own = characterOf(project, entry);
        if (own != nullptr && own->name == character && !clipOfSource(entry.source))
            names.push_back(entry.name);
    }
    return names;
}

std::vector<const TransferEntry*> transfersWithTruth(const Project& project, const std::string& character)
{
    std::vector<const TransferEntry*> known;
    for (const TransferEntry& entry : project.transfers) {
        if (!entry.truth.empty() && characterOfClip(project, "transfers/" + entry.name) == character)
            known.push_back(&entry);
    }
    return known;
}

int variationCount(const VariationEntry& entry)
{
    int count = 0;
    for (const SamplesEntry& samples : entry.samples)
        count += samples.count;
    return count;
}

bool isDiscarded(const VariationEntry& entry, int number)
{
    const auto place = placeOfVariation(entry, number);
    if (!place)
        return false;
    const std::vector<int>& discarded = entry.samples[place->set].discarded;
    return std::find(discarded.begin(), discarded.end(), place->index + 1) != discarded.end();
}

std::optional<SamplePlace> placeOfVariation(const VariationEntry& entry, int number)
{
    int index = number - 1;
    for (std::size_t set = 0; set < entry.samples.size(); ++set) {
        const int count = entry.samples[set].count;
        if (index >= 0 && index < count)
            return SamplePlace{set, index};
        index -= count;
    }
    return std::nullopt;
}

std::vector<const VariationEntry*> learnedVariations(const Project& project, const std::string& character)
{
    std::vector<const VariationEntry*> learned;
    for (const VariationEntry& entry : project.variations) {
        if (!entry.training.empty() && characterNameOf(project, entry) == character)
            learned.push_back(&entry);
    }
    return learned;
}

std::vector<std::string> partNamesOf(const Project& project, const VariationEntry& entry)
{
    std::vector<std::string> names;
    const BodyPartsEntry* parts = bodyPartsOf(project, characterNameOf(project, entry));
    // The root stands first, as in BodyParts.
    for (const bool isRoot : {true, false}) {
        for (const PartEntry& part : parts ? parts->parts : std::vector<PartEntry>()) {
            if (part.part.parent.empty() == isRoot)
                names.push_back(part.part.name);
        }
    }
    if (names.empty())
        names.emplace_back("body");
    return names;
}

bool isMadeClip(std::string_view clip)
{
    const auto varied = variationOfClip(clip);
    return nameOfClip(clip, animationsSection).has_value() || nameOfClip(clip, liveSection).has_value() ||
           nameOfClip(clip, transfersSection).has_value() ||
           nameOfClip(clip, projectionsSection).has_value() || (varied && varied->number > 0);
}

std::string clipStepOf(const std::string& clip)
{
    return clip + (nameOfClip(clip, projectionsSection) ? "/textures" : "/clip");
}

std::vector<std::string> clipStepsOf(const Project& project, const std::string& clip)
{
    if (const auto name = nameOfClip(clip, "sequences")) {
        const SequenceEntry* entry = findSequence(project, *name);
        const auto shown = entry ? shownClip(project, *entry) : std::nullopt;
        return shown ? std::vector{clipStepOf(*shown)} : std::vector<std::string>();
    }
    if (isMadeClip(clip))
        return {clipStepOf(clip)};
    std::vector<std::string> steps;
    const auto varied = variationOfClip(clip);
    if (const VariationEntry* variation = varied ? findVariation(project, varied->variation) : nullptr) {
        for (int number = 1; number <= variationCount(*variation); ++number) {
            if (!isDiscarded(*variation, number))
                steps.push_back(clipStepOf(variationClip(variation->name, number)));
        }
    }
    return steps;
}

std::vector<std::string> clipInputs(const Project& project, const std::vector<std::string>& sequences)
{
    std::vector<std::string> inputs;
    for (const std::string& name : sequences) {
        for (std::string& step : clipStepsOf(project, "sequences/" + name)) {
            if (std::find(inputs.begin(), inputs.end(), step) == inputs.end())
                inputs.push_back(std::move(step));
        }
    }
    return inputs;
}

std::optional<std::string> shownClip(const Project& project, const SequenceEntry& entry)
{
    const SequenceEntry* at = &entry;
    // Sequences that go round in a circle show none.
    for (std::size_t steps = 0; at != nullptr && steps <= project.sequences.size(); ++steps) {
        auto clip = clipOfSource(at->source);
        if (!clip)
            return std::nullopt;
        if (isMadeClip(*clip))
            return sequencesOfClip(project, *clip).empty() ? std::nullopt : std::move(clip);
        const auto name = nameOfClip(*clip, "sequences");
        at = name ? findSequence(project, *name) : nullptr;
    }
    return std::nullopt;
}

std::vector<std::string> takesOfSpaces(const Project& project, const std::vector<std::string>& spaces)
{
    std::vector<std::string> names;
    for (const std::string& space : spaces) {
        const MotionSpaceEntry* entry = findMotionSpace(project, space);
        if (entry == nullptr)
            continue;
        for (const SpaceTakeEntry& take : entry->takes) {
            if (std::ranges::find(names, take.sequence) == names.end())
                names.push_back(take.sequence);
        }
    }
    return names;
}

std::vector<std::string> sequencesOfClip(const Project& project, const std::string& clip)
{
    if (const auto name = nameOfClip(clip, animationsSection)) {
        const AnimationEntry* animation = findAnimation(project, *name);
        return animation ? sequencesOfGraph(project, characterNameOf(project, *animation))
                         : std::vector<std::string>();
    }
    if (const LiveEntry* live = liveOfClip(project, clip))
        return takesOfSpaces(project, live->spaces);
    if (const TransferEntry* transfer = transferOfClip(project, clip))
        return {transfer->target.sequence};
    if (projectionOfClip(project, clip) != nullptr) {
        const std::string below = clipBelow(project, clip);
        const auto name = nameOfClip(below, "sequences");
        return name ? std::vector{*name} : sequencesOfClip(project, below);
    }
    std::vector<std::string> names;
    const auto varied = variationOfClip(clip);
    const VariationEntry* variation = varied ? findVariation(project, varied->variation) : nullptr;
    if (variation != nullptr && varied->number <= variationCount(*variation)) {
        for (const TrainingEntry& take : variation->training)
            names.push_back(take.sequence);
    }
    return names;
}

std::string characterOfClip(const Project& project, const std::string& clip)
{
    if (const auto name = nameOfClip(clip, animationsSection)) {
        const AnimationEntry* animation = findAnimation(project, *name);
        return animation ? characterNameOf(project, *animation) : "";
    }
    if (const auto varied = variationOfClip(clip)) {
        const VariationEntry* variation = findVariation(project, varied->variation);
        return variation ? characterNameOf(project, *variation) : "";
    }
    if (projectionOfClip(project, clip) != nullptr)
        return characterOfClip(project, clipBelow(project, clip));
    if (const LiveEntry* live = liveOfClip(project, clip))
        return characterNameOf(project, *live);
    const TransferEntry* transfer = transferOfClip(project, clip);
    const auto name = transfer ? transfer->target.sequence : nameOfClip(clip, "sequences");
    const SequenceEntry* sequence = name ? findSequence(project, *name) : nullptr;
    const CharacterEntry* character = sequence ? characterOf(project, *sequence) : nullptr;
    return character ? character->name : "";
}

std::vector<std::string> sequencesOfGraph(const Project& project, const std::string& character)
{
    std::vector<std::string> names;
    for (const SequenceEntry& entry : project.sequences) {
        const CharacterEntry* own = characterOf(project, entry);
        if ((own ? own->name : "") == character && !AnimationSearch(project, character).finds(entry))
            names.push_back(entry.name);
    }
    return names;
}

} // namespace quadrille
