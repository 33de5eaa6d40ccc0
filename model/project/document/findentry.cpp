// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/findentry.h"

#include <algorithm>

namespace quadrille {

namespace {

template <typename Entry>
const Entry* findEntry(const std::vector<Entry>& entries, const std::string& name)
{
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.name == name; });
    return found == entries.end() ? nullptr : &*found;
}

std::string characterOrOnlyOne(const Project& project, const std::string& named)
{
    return named.empty() && !project.characters.empty() ? project.characters.front().name : named;
}

} // namespace

const CharacterEntry* characterOf(const Project& project, const SequenceEntry& entry)
{
    if (entry.character.empty())
        return project.characters.empty() ? nullptr : &project.characters.front();
    const auto found =
        std::find_if(project.characters.begin(), project.characters.end(),
                     [&](const CharacterEntry& character) { return character.name == entry.character; });
    return found == project.characters.end() ? nullptr : &*found;
}

const SequenceEntry* findSequence(const Project& project, const std::string& name)
{
    return findEntry(project.sequences, name);
}

const AnimationEntry* findAnimation(const Project& project, const std::string& name)
{
    return findEntry(project.animations, name);
}

const VariationEntry* findVariation(const Project& project, const std::string& name)
{
    return findEntry(project.variations, name);
}

const MotionSpaceEntry* findMotionSpace(const Project& project, const std::string& name)
{
    return findEntry(project.motionSpaces, name);
}

const LiveEntry* findLive(const Project& project, const std::string& name)
{
    return findEntry(project.lives, name);
}

const AppearanceEntry* findAppearance(const Project& project, const std::string& name)
{
    return findEntry(project.appearances, name);
}

const TransferEntry* findTransfer(const Project& project, const std::string& name)
{
    return findEntry(project.transfers, name);
}

const ProjectionEntry* findProjection(const Project& project, const std::string& name)
{
    return findEntry(project.projections, name);
}

const AppearanceEntry* appearanceOf(const Project& project, const std::string& character)
{
    const auto found = std::ranges::find_if(project.appearances, [&](const AppearanceEntry& entry) {
        return characterNameOf(project, entry) == character;
    });
    return found == project.appearances.end() ? nullptr : &*found;
}

std::string characterNameOf(const Project& project, const AnimationEntry& animation)
{
    return characterOrOnlyOne(project, animation.character);
}

std::string characterNameOf(const Project& project, const VariationEntry& variation)
{
    return characterOrOnlyOne(project, variation.character);
}

std::string characterNameOf(const Project& project, const MotionSpaceEntry& space)
{
    return characterOrOnlyOne(project, space.character);
}

std::string characterNameOf(const Project& project, const LiveEntry& live)
{
    const MotionSpaceEntry* space =
        live.spaces.empty() ? nullptr : findMotionSpace(project, live.spaces.front());
    return space != nullptr ? characterNameOf(project, *space) : std::string();
}

std::string characterNameOf(const Project& project, const AppearanceEntry& appearance)
{
    return characterOrOnlyOne(project, appearance.character);
}

std::size_t steeredSpaces(const Project& project, const std::string& character)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(project.motionSpaces, [&](const MotionSpaceEntry& entry) {
            return entry.takes.size() > 1 && characterNameOf(project, entry) == character;
        }));
}

const BodyPartsEntry* bodyPartsOf(const Project& project, const std::string& character)
{
    const auto found =
        std::find_if(project.bodyParts.begin(), project.bodyParts.end(), [&](const BodyPartsEntry& entry) {
            return characterOrOnlyOne(project, entry.character) == character;
        });
    return found == project.bodyParts.end() ? nullptr : &*found;
}

} // namespace quadrille
