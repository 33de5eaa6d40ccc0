// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/variationedits.h"

#include "editor/commands/insertpart.h"
#include "editor/commands/projectedits.h"

#include <QCoreApplication>

namespace quadrille {

namespace {

struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::VariationEdits)
};

void insert(ProjectDocument& document, const QString& text, std::size_t place, VariationEntry variation)
{
    ProjectPart part;
    part.variations.emplace_back(place, std::move(variation));
    document.push(std::make_unique<InsertPart>(document, text, std::move(part)));
}

bool isBodyOf(const Project& project, const BodyPartsEntry& body, const std::string& character)
{
    return body.character == character || (body.character.empty() && project.characters.size() < 2);
}

} // namespace

QString addVariation(ProjectDocument& document, VariationEntry variation)
{
    const Project& project = document.project();
    QString name = freeName(project, Section::Variations, QString::fromStdString(variation.name));
    variation.name = name.toStdString();
    insert(document, Texts::tr("Add variations “%1”").arg(name), project.variations.size(),
           std::move(variation));
    return name;
}

QString duplicateVariation(ProjectDocument& document, const QString& name)
{
    const Project& project = document.project();
    const auto original = std::ranges::find(project.variations, name.toStdString(), &VariationEntry::name);
    VariationEntry copy = *original;
    QString copyName = freeName(project, Section::Variations, name);
    copy.name = copyName.toStdString();
    const auto place = static_cast<std::size_t>(original - project.variations.begin()) + 1;
    insert(document, Texts::tr("Duplicate “%1”").arg(name), place, std::move(copy));
    return copyName;
}

void setVariation(ProjectDocument& document, const QString& name, const QString& text,
                  const QString& property, VariationEntry after, EditPhase phase)
{
    document.push(std::make_unique<ChangeEntry<VariationEntry>>(document, text, name, property,
                                                                std::move(after), phase));
}

BodyPartsEntry bodyPartsEntry(const Project& project, const QString& character)
{
    for (const BodyPartsEntry& body : project.bodyParts) {
        if (isBodyOf(project, body, character.toStdString()))
            return body;
    }
    BodyPartsEntry none;
    none.character = character.toStdString();
    return none;
}

void setBodyParts(ProjectDocument& document, const QString& text, const QString& property,
                  const BodyPartsEntry& after, EditPhase phase)
{
    using Bodies = std::vector<BodyPartsEntry>;
    Bodies bodies = document.project().bodyParts;
    const auto isIts = [&](const BodyPartsEntry& body) {
        return isBodyOf(document.project(), body, after.character);
    };
    if (const auto found = std::ranges::find_if(bodies, isIts); found != bodies.end())
        *found = after;
    else
        bodies.push_back(after);
    document.push(std::make_unique<ChangeEntry<Bodies>>(
        document, text, QString::fromStdString(after.character), property, std::move(bodies), phase));
}

} // namespace quadrille
