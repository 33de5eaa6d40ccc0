// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"
#include "model/project/fields/references.h"

#include <QString>
#include <QStringList>
#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille {

/// The sections of a project that the tree shows and the selection can point into.
enum class Section
{
    Project, ///< the settings; as entries, what cannot be read
    Characters,
    Sequences,
    Graphs, ///< an entry is called by its character
    Animations,
    BodyParts, ///< an entry is called by its character
    Variations,
    MotionSpaces,
    Lives,
    Appearances,
    Transfers,
    Projections,
    Evaluations, ///< an entry is called by its table, and its character where it names one: see
                 ///< evaluationName()
    Exports,
};

/// What tree, menus, history and names need to know of a section.
struct SectionInfo
{
    Section section;
    const char* key;   ///< in the file
    const char* icon;  ///< of its entries
    const char* title; ///< with “%1” for how many entries it has; see titleOf()
    /// Of its entries, in project order.
    QStringList (*names)(const Project& project);
    const char* removal = nullptr;   ///< what the history calls the removal of %n entries, where it can
    std::optional<NamedKind> kind{}; ///< where others speak of its entries
    bool isRenamable = false;
    bool isDuplicable = false;
    std::vector<const char*> additions{}; ///< actions that add an entry
    const char* opening = nullptr;        ///< action that shows an entry
};

/// Those that the tree shows, in its order.
std::span<const SectionInfo> sections();
/// Null where the tree does not show it.
const SectionInfo* findSection(Section section);
/// “Sequences (3)”, translated.
QString titleOf(const SectionInfo& section, int count);

namespace sectionlists {

template <typename Value>
using Place = std::pair<Section, Value Project::*>;

/// The lists of entries that have names of their own.
inline constexpr std::tuple named{
    Place<std::vector<CharacterEntry>>(Section::Characters, &Project::characters),
    Place<std::vector<SequenceEntry>>(Section::Sequences, &Project::sequences),
    Place<std::vector<AnimationEntry>>(Section::Animations, &Project::animations),
    Place<std::vector<VariationEntry>>(Section::Variations, &Project::variations),
    Place<std::vector<MotionSpaceEntry>>(Section::MotionSpaces, &Project::motionSpaces),
    Place<std::vector<LiveEntry>>(Section::Lives, &Project::lives),
    Place<std::vector<AppearanceEntry>>(Section::Appearances, &Project::appearances),
    Place<std::vector<TransferEntry>>(Section::Transfers, &Project::transfers),
    Place<std::vector<ProjectionEntry>>(Section::Projections, &Project::projections),
    Place<std::vector<ExportEntry>>(Section::Exports, &Project::exports)};
/// What is edited as one value.
inline constexpr std::tuple whole{
    Place<ProjectSettings>(Section::Project, &Project::settings),
    Place<std::vector<GraphEntry>>(Section::Graphs, &Project::graphs),
    Place<std::vector<BodyPartsEntry>>(Section::BodyParts, &Project::bodyParts)};

template <typename Value, typename Places>
inline constexpr bool holds = false;
template <typename Value, typename... Values>
inline constexpr bool holds<Value, std::tuple<Place<Values>...>> = (std::is_same_v<Value, Values> || ...);

/// Where an entry stands: among others of its kind, or as one value. \return a Place: section and member of
/// Project.
template <typename Entry>
constexpr auto placeOf()
{
    if constexpr (holds<Entry, std::remove_const_t<decltype(whole)>>)
        return std::get<Place<Entry>>(whole);
    else
        return std::get<Place<std::vector<Entry>>>(named);
}

/// Calls a function with the section and the list of each kind of named entries.
template <typename ProjectType, typename Function>
void forEachNamed(ProjectType& project, const Function& function)
{
    std::apply([&](const auto&... places) { (function(places.first, project.*places.second), ...); }, named);
}

} // namespace sectionlists

/// Of a kind of entries, or of a value that is edited as a whole.
template <typename Entry>
constexpr Section sectionOf()
{
    return sectionlists::placeOf<Entry>().first;
}

/// The entries of one kind. \tparam ProjectType Project or const Project. \tparam Entry  of a kind with names
/// of its own.
template <typename Entry, typename ProjectType>
auto& entriesOf(ProjectType& project)
{
    return project.*std::get<sectionlists::Place<std::vector<Entry>>>(sectionlists::named).second;
}

/// The entry of a name; null where there is none.
template <typename Entry, typename ProjectType>
auto* findEntry(ProjectType& project, const QString& name)
{
    auto& entries = entriesOf<Entry>(project);
    const auto found = std::ranges::find(entries, name.toStdString(), &Entry::name);
    return found == entries.end() ? nullptr : &*found;
}

/// The entry of a name. \pre It is there. Of settings, graphs and body parts there is one value, whatever the
/// name.
template <typename Entry, typename ProjectType>
auto& entryOf(ProjectType& project, const QString& name)
{
    if constexpr (sectionlists::holds<Entry, std::remove_const_t<decltype(sectionlists::whole)>>) {
        return project.*sectionlists::placeOf<Entry>().second;
    } else {
        auto* entry = findEntry<Entry>(project, name);
        assert(entry != nullptr);
        return *entry;
    }
}

} // namespace quadrille
