// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/changeevent.h"
#include "model/project/project.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

namespace quadrille {

template <typename Entry>
constexpr Section sectionOf()
{
    if constexpr (std::is_same_v<Entry, ProjectSettings>)
        return Section::Project;
    else if constexpr (std::is_same_v<Entry, CharacterEntry>)
        return Section::Characters;
    else if constexpr (std::is_same_v<Entry, SequenceEntry>)
        return Section::Sequences;
    else if constexpr (std::is_same_v<Entry, std::vector<GraphEntry>>)
        return Section::Graphs;
    else if constexpr (std::is_same_v<Entry, AnimationEntry>)
        return Section::Animations;
    else if constexpr (std::is_same_v<Entry, std::vector<BodyPartsEntry>>)
        return Section::BodyParts;
    else if constexpr (std::is_same_v<Entry, VariationEntry>)
        return Section::Variations;
    else
        return Section::Exports;
}

/// The entries of one kind. \tparam ProjectType Project or const Project.
template <typename Entry, typename ProjectType>
auto& entriesOf(ProjectType& project)
{
    if constexpr (std::is_same_v<Entry, CharacterEntry>)
        return project.characters;
    else if constexpr (std::is_same_v<Entry, SequenceEntry>)
        return project.sequences;
    else if constexpr (std::is_same_v<Entry, AnimationEntry>)
        return project.animations;
    else if constexpr (std::is_same_v<Entry, VariationEntry>)
        return project.variations;
    else
        return project.exports;
}

/// The entry of a name. \pre It is there. Of settings, graphs and body parts there is one value, whatever the
/// name.
template <typename Entry, typename ProjectType>
auto& entryOf(ProjectType& project, const QString& name)
{
    if constexpr (std::is_same_v<Entry, ProjectSettings>) {
        return project.settings;
    } else if constexpr (std::is_same_v<Entry, std::vector<GraphEntry>>) {
        return project.graphs;
    } else if constexpr (std::is_same_v<Entry, std::vector<BodyPartsEntry>>) {
        return project.bodyParts;
    } else {
        auto& entries = entriesOf<Entry>(project);
        const auto found = std::ranges::find(entries, name.toStdString(), &Entry::name);
        assert(found != entries.end());
        return *found;
    }
}

} // namespace quadrille
