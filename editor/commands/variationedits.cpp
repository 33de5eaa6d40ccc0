// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/variationedits.h"

#include "editor/commands/entryedits.h"

#include <QCoreApplication>

namespace quadrille {

namespace {

struct VariationTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::VariationEdits)
};

bool isBodyOf(const Project& project, const BodyPartsEntry& body, const std::string& character)
{
    return body.character == character || (body.character.empty() && project.characters.size() < 2);
}

} // namespace

QString addVariation(ProjectDocument& document, VariationEntry variation)
{
    return addEntry(document, VariationTexts::tr("Add variations “%1”"), std::move(variation));
}

QString duplicateVariation(ProjectDocument& document, const QString& name)
{
    return duplicateEntry<VariationEntry>(document, VariationTexts::tr("Duplicate “%1”").arg(name), name);
}

void setVariation(ProjectDocument& document, const QString& name, const QString& text,
                  const QString& property, VariationEntry after, EditPhase phase)
{
    setEntry(document, name, text, property, std::move(after), phase);
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
    setEntryOfCharacter(document, text, property, after, phase, [&](const BodyPartsEntry& body) {
        return isBodyOf(document.project(), body, after.character);
    });
}

} // namespace quadrille
