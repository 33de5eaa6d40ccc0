// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/animationedits.h"

#include "editor/commands/entryedits.h"
#include "model/project/steps/charactersteps.h"

#include <QCoreApplication>
#include <tuple>

namespace quadrille {

namespace {

struct AnimationTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::AnimationEdits)
};

} // namespace

QString addAnimation(ProjectDocument& document, AnimationEntry animation)
{
    return addEntry(document, AnimationTexts::tr("Add animation “%1”"), std::move(animation));
}

QString duplicateAnimation(ProjectDocument& document, const QString& name)
{
    return duplicateEntry<AnimationEntry>(document, AnimationTexts::tr("Duplicate “%1”").arg(name), name);
}

bool asksTheSame(const AnimationEntry& a, const AnimationEntry& b)
{
    return std::tie(a.character, a.start, a.constraints, a.search) ==
           std::tie(b.character, b.start, b.constraints, b.search);
}

void setAnimation(ProjectDocument& document, const QString& name, const QString& text,
                  const QString& property, AnimationEntry after, EditPhase phase)
{
    if (const AnimationEntry* before = document.animation(name);
        before != nullptr && !asksTheSame(*before, after))
        after.junctions.walk.clear();
    setEntry(document, name, text, property, std::move(after), phase);
}

GraphEntry graphEntry(const Project& project, const QString& character)
{
    return graphOf(project, character.toStdString());
}

void setGraph(ProjectDocument& document, const QString& text, const QString& property,
              const GraphEntry& after, EditPhase phase)
{
    setEntryOfCharacter(document, text, property, after, phase, [&](const GraphEntry& graph) {
        return isGraphOf(document.project(), graph, after.character);
    });
}

} // namespace quadrille
