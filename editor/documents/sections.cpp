// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/sections.h"

#include "editor/documents/evaluationnames.h"
#include "model/project/document/brokenentry.h"

#include <QCoreApplication>

namespace quadrille {

namespace {

template <auto list>
QStringList ownNames(const Project& project)
{
    QStringList names;
    for (const auto& entry : project.*list)
        names += QString::fromStdString(entry.name);
    return names;
}

/// They are called by their character, which a project with only one need not name.
QStringList namesOfBodies(const Project& project)
{
    QStringList names;
    for (const BodyPartsEntry& body : project.bodyParts) {
        const bool isNamed = !body.character.empty() || project.characters.empty();
        names += QString::fromStdString(isNamed ? body.character : project.characters.front().name);
    }
    names.removeAll(QString());
    return names;
}

QStringList namesOfEvaluations(const Project& project)
{
    QStringList names;
    for (const EvaluationEntry& evaluation : project.evaluations)
        names += evaluationName(evaluation);
    return names;
}

QStringList titlesOfBroken(const Project& project)
{
    QStringList titles;
    for (const std::string& title : titlesOf(brokenEntries(project)))
        titles += QString::fromStdString(title);
    return titles;
}

} // namespace

std::span<const SectionInfo> sections()
{
    static const std::vector<SectionInfo> all{
        {.section = Section::Characters,
         .key = "characters",
         .icon = "character",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Characters (%1)"),
         .names = ownNames<&Project::characters>,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::ProjectEdits", "Remove %n characters"),
         .kind = NamedKind::Character,
         .isRenamable = true},
        {.section = Section::Sequences,
         .key = "sequences",
         .icon = "sequence",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Sequences (%1)"),
         .names = ownNames<&Project::sequences>,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::ProjectEdits", "Remove %n sequences"),
         .kind = NamedKind::Sequence,
         .isRenamable = true,
         .isDuplicable = true,
         .additions = {"file.import", "file.importFolder"}},
        {.section = Section::Animations,
         .key = "animations",
         .icon = "trajectory",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Animations (%1)"),
         .names = ownNames<&Project::animations>,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::ProjectEdits", "Remove %n animations"),
         .kind = NamedKind::Animation,
         .isRenamable = true,
         .isDuplicable = true,
         .additions = {"animate.new"},
         .opening = "workspace.animate"},
        {.section = Section::BodyParts,
         .key = "body_parts",
         .icon = "parts",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Body parts (%1)"),
         .names = namesOfBodies,
         .opening = "workspace.variations"},
        {.section = Section::Variations,
         .key = "variations",
         .icon = "variation",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Variations (%1)"),
         .names = ownNames<&Project::variations>,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::ProjectEdits", "Remove %n variations"),
         .kind = NamedKind::Variation,
         .isRenamable = true,
         .isDuplicable = true,
         .additions = {"variations.new"},
         .opening = "workspace.variations"},
        {.section = Section::MotionSpaces,
         .key = "motion_spaces",
         .icon = "motiongraph",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Motion spaces (%1)"),
         .names = ownNames<&Project::motionSpaces>,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::ProjectEdits", "Remove %n motion spaces"),
         .kind = NamedKind::MotionSpace,
         .isRenamable = true,
         .isDuplicable = true,
         .additions = {"motionSpaces.new"},
         .opening = "workspace.live"},
        {.section = Section::Lives,
         .key = "live",
         .icon = "play",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Live performances (%1)"),
         .names = ownNames<&Project::lives>,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::ProjectEdits", "Remove %n live performances"),
         .kind = NamedKind::Live,
         .isRenamable = true,
         .opening = "workspace.live"},
        {.section = Section::Appearances,
         .key = "appearance",
         .icon = "texture",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Appearance (%1)"),
         .names = ownNames<&Project::appearances>,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::ProjectEdits", "Remove %n models of appearance"),
         .isRenamable = true,
         .isDuplicable = true,
         .additions = {"appearance.new"},
         .opening = "workspace.appearance"},
        {.section = Section::Transfers,
         .key = "transfers",
         .icon = "character",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Transfers (%1)"),
         .names = ownNames<&Project::transfers>,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::ProjectEdits", "Remove %n transfers"),
         .kind = NamedKind::Transfer,
         .isRenamable = true,
         .isDuplicable = true,
         .additions = {"transfer.new"},
         .opening = "workspace.transfer"},
        {.section = Section::Projections,
         .key = "projections",
         .icon = "texture",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Projections (%1)"),
         .names = ownNames<&Project::projections>,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::ProjectEdits", "Remove %n projections"),
         .kind = NamedKind::Projection,
         .isRenamable = true,
         .isDuplicable = true,
         .additions = {"projection.new"}},
        {.section = Section::Evaluations,
         .key = "evaluations",
         .icon = "evaluation",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Evaluations (%1)"),
         .names = namesOfEvaluations,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::ProjectEdits", "Remove %n evaluations"),
         .additions = {"evaluations.add"},
         .opening = "evaluations.show"},
        {.section = Section::Exports,
         .key = "exports",
         .icon = "export",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Exports (%1)"),
         .names = ownNames<&Project::exports>,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::ProjectEdits", "Remove %n exports"),
         .isRenamable = true,
         .additions = {"file.export"},
         .opening = "file.export"},
        {.section = Section::Project,
         .key = "settings",
         .icon = "error",
         .title = QT_TRANSLATE_NOOP("quadrille::ProjectTreeModel", "Cannot be read (%1)"),
         .names = titlesOfBroken,
         .removal = QT_TRANSLATE_N_NOOP("quadrille::BrokenEdits", "Remove %n unreadable parts")},
    };
    return all;
}

const SectionInfo* findSection(Section section)
{
    const auto found = std::ranges::find(sections(), section, &SectionInfo::section);
    return found == sections().end() ? nullptr : &*found;
}

QString titleOf(const SectionInfo& section, int count)
{
    return QCoreApplication::translate("quadrille::ProjectTreeModel", section.title).arg(count);
}

} // namespace quadrille
