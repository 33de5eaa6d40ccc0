// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/motionspaceedits.h"

#include "editor/commands/entryedits.h"
#include "model/project/document/findentry.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace quadrille {

namespace {

struct MotionSpaceTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::MotionSpaceEdits)
};

/// What a parameter is called by what it measures.
QString nameOf(SpaceMeasure measure)
{
    switch (measure) {
    case SpaceMeasure::Speed:
        return MotionSpaceTexts::tr("speed");
    case SpaceMeasure::Turning:
        return MotionSpaceTexts::tr("turning");
    case SpaceMeasure::JumpHeight:
        return MotionSpaceTexts::tr("jump height");
    case SpaceMeasure::JumpLength:
        return MotionSpaceTexts::tr("jump length");
    case SpaceMeasure::Height:
        return MotionSpaceTexts::tr("height");
    case SpaceMeasure::Forward:
        return MotionSpaceTexts::tr("forward");
    case SpaceMeasure::Side:
        return MotionSpaceTexts::tr("side");
    default:
        return MotionSpaceTexts::tr("parameter");
    }
}

/// With a number where another parameter is called so.
std::string freeName(const MotionSpaceEntry& entry, SpaceMeasure measure)
{
    const std::string base = nameOf(measure).toStdString();
    std::string name = base;
    for (int number = 2;
         std::ranges::find(entry.parameters, name, &SpaceParameterEntry::name) != entry.parameters.end();
         ++number)
        name = base + ' ' + std::to_string(number);
    return name;
}

bool isNamedFor(const std::string& name, SpaceMeasure measure)
{
    const std::string base = nameOf(measure).toStdString();
    if (!name.starts_with(base))
        return false;
    const std::string_view number = std::string_view(name).substr(base.size());
    return number.empty() ||
           (number.starts_with(' ') && number.find_first_not_of("0123456789", 1) == std::string_view::npos);
}

void takeIn(const Project& project, MotionSpaceEntry& entry, const QStringList& sequences)
{
    const QStringList own = sequencesFor(project, entry);
    for (const QString& sequence : sequences) {
        if (own.contains(sequence) && entry.takes.size() < WeightSpace::mostTakes)
            entry.takes.emplace_back().sequence = sequence.toStdString();
    }
    if (entry.takes.size() > 1 && entry.parameters.empty())
        addParameter(entry);
}

} // namespace

void addTakes(ProjectDocument& document, const QString& name, const QStringList& sequences)
{
    MotionSpaceEntry after = *findMotionSpace(document.project(), name.toStdString());
    takeIn(document.project(), after, sequences);
    const QString text = sequences.size() == 1
                             ? MotionSpaceTexts::tr("Add the take “%1”").arg(sequences.front())
                             : MotionSpaceTexts::tr("Add takes");
    setMotionSpace(document, name, text, QStringLiteral("takes"), std::move(after));
}

bool canTake(const ProjectDocument& document, const QString& name, const QStringList& sequences)
{
    const MotionSpaceEntry* entry = findMotionSpace(document.project(), name.toStdString());
    if (entry == nullptr)
        return false;
    const QStringList own = sequencesFor(document.project(), *entry);
    return entry->takes.size() < WeightSpace::mostTakes &&
           std::ranges::any_of(sequences, [&](const QString& each) { return own.contains(each); });
}

void addParameter(MotionSpaceEntry& entry)
{
    const auto isFree = [&](SpaceMeasure measure) {
        return std::ranges::find(entry.parameters, measure, &SpaceParameterEntry::measure) ==
               entry.parameters.end();
    };
    constexpr std::array measures{SpaceMeasure::Speed, SpaceMeasure::Turning, SpaceMeasure::JumpHeight,
                                  SpaceMeasure::JumpLength};
    const auto* free = std::ranges::find_if(measures, isFree);
    SpaceParameterEntry added;
    added.measure = free == measures.end() ? SpaceMeasure::ByHand : *free;
    added.name = freeName(entry, added.measure);
    entry.parameters.push_back(std::move(added));
}

void followMeasure(MotionSpaceEntry& entry, std::size_t parameter, SpaceMeasure before)
{
    SpaceParameterEntry& changed = entry.parameters[parameter];
    if (changed.measure == before || !isNamedFor(changed.name, before))
        return;
    changed.name.clear();
    changed.name = freeName(entry, changed.measure);
}

QString addMotionSpace(ProjectDocument& document, const QString& name, const QStringList& sequences)
{
    const Project& project = document.project();
    MotionSpaceEntry entry;
    entry.name = name.toStdString();
    if (!project.characters.empty() && project.characters.size() > 1) {
        const SequenceEntry* first =
            sequences.isEmpty() ? nullptr : findSequence(project, sequences.front().toStdString());
        const CharacterEntry* of = first == nullptr ? nullptr : characterOf(project, *first);
        entry.character = of == nullptr ? project.characters.front().name : of->name;
    }
    takeIn(project, entry, sequences);
    return addEntry(document, MotionSpaceTexts::tr("Add motion space “%1”"), std::move(entry));
}

QString duplicateMotionSpace(ProjectDocument& document, const QString& name)
{
    return duplicateEntry<MotionSpaceEntry>(document, MotionSpaceTexts::tr("Duplicate “%1”").arg(name), name);
}

void setMotionSpace(ProjectDocument& document, const QString& name, const QString& text,
                    const QString& property, MotionSpaceEntry after, EditPhase phase)
{
    setEntry(document, name, text, property, std::move(after), phase);
}

QStringList sequencesFor(const Project& project, const MotionSpaceEntry& entry)
{
    const std::string character = characterNameOf(project, entry);
    QStringList names;
    for (const SequenceEntry& sequence : project.sequences) {
        const CharacterEntry* of = characterOf(project, sequence);
        if ((of == nullptr ? std::string() : of->name) == character)
            names += QString::fromStdString(sequence.name);
    }
    return names;
}

} // namespace quadrille
