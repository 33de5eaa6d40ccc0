// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/animationedits.h"

#include "editor/commands/insertpart.h"
#include "editor/commands/projectedits.h"
#include "model/project/characterstages.h"

#include <QCoreApplication>

namespace quadrille {

namespace {

struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::AnimationEdits)
};

void insert(ProjectDocument& document, const QString& text, std::size_t place, AnimationEntry animation)
{
    ProjectPart part;
    part.animations.emplace_back(place, std::move(animation));
    document.push(std::make_unique<InsertPart>(document, text, std::move(part)));
}

} // namespace

QString addAnimation(ProjectDocument& document, AnimationEntry animation)
{
    const Project& project = document.project();
    QString name = freeName(project, Section::Animations, QString::fromStdString(animation.name));
    animation.name = name.toStdString();
    insert(document, Texts::tr("Add animation “%1”").arg(name), project.animations.size(),
           std::move(animation));
    return name;
}

QString duplicateAnimation(ProjectDocument& document, const QString& name)
{
    const Project& project = document.project();
    const auto original = std::ranges::find(project.animations, name.toStdString(), &AnimationEntry::name);
    AnimationEntry copy = *original;
    QString copyName = freeName(project, Section::Animations, name);
    copy.name = copyName.toStdString();
    const auto place = static_cast<std::size_t>(original - project.animations.begin()) + 1;
    insert(document, Texts::tr("Duplicate “%1”").arg(name), place, std::move(copy));
    return copyName;
}

void setAnimation(ProjectDocument& document, const QString& name, const QString& text,
                  const QString& property, AnimationEntry after, EditPhase phase)
{
    document.push(std::make_unique<ChangeEntry<AnimationEntry>>(document, text, name, property,
                                                                std::move(after), phase));
}

GraphEntry graphEntry(const Project& project, const QString& character)
{
    return graphOf(project, character.toStdString());
}

void setGraph(ProjectDocument& document, const QString& text, const QString& property,
              const GraphEntry& after, EditPhase phase)
{
    using Graphs = std::vector<GraphEntry>;
    Graphs graphs = document.project().graphs;
    const auto isIts = [&](const GraphEntry& graph) {
        return isGraphOf(document.project(), graph, after.character);
    };
    if (const auto found = std::ranges::find_if(graphs, isIts); found != graphs.end())
        *found = after;
    else
        graphs.push_back(after);
    document.push(std::make_unique<ChangeEntry<Graphs>>(
        document, text, QString::fromStdString(after.character), property, std::move(graphs), phase));
}

} // namespace quadrille
