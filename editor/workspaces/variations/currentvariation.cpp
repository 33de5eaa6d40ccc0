// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/currentvariation.h"

#include "editor/application/editorcontext.h"
#include "editor/commands/variationedits.h"

namespace quadrille {

CurrentVariation::CurrentVariation(EditorContext& context, StageView& view, QObject* parent)
    : QObject(parent), m_context(context), m_view(view)
{
    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.touches(Section::Variations) || event.touches(Section::Sequences))
            emit changed();
        if (event.touches(Section::BodyParts) || event.touches(Section::Variations) ||
            event.touches(Section::Characters))
            emit bodyChanged();
    });
    connect(&context.selection, &Selection::changed, this, [this] {
        emit changed();
        emit bodyChanged();
    });
}

const QString& CurrentVariation::name() const
{
    return m_context.selection.shownVariation();
}

const VariationEntry* CurrentVariation::entry() const
{
    return m_context.document.variation(name());
}

QString CurrentVariation::character() const
{
    const Project& project = m_context.document.project();
    if (const VariationEntry* own = entry(); own != nullptr && !own->character.empty())
        return QString::fromStdString(own->character);
    const SequenceEntry* sequence = m_context.document.sequence(m_context.selection.shownSequence());
    const CharacterEntry* shown = sequence == nullptr ? nullptr : m_context.document.characterOf(*sequence);
    if (shown != nullptr && entry() == nullptr)
        return QString::fromStdString(shown->name);
    return project.characters.empty() ? QString() : QString::fromStdString(project.characters.front().name);
}

BodyPartsEntry CurrentVariation::body() const
{
    return bodyPartsEntry(m_context.document.project(), character());
}

void CurrentVariation::edit(const QString& text, const QString& property, const Edit& edit, EditPhase phase)
{
    const QString edited = entry() == nullptr ? add() : name();
    VariationEntry after = *m_context.document.variation(edited);
    edit(after);
    setVariation(m_context.document, edited, text, property, std::move(after), phase);
}

void CurrentVariation::editBody(const QString& text, const QString& property, const BodyEdit& edit,
                                EditPhase phase)
{
    BodyPartsEntry after = body();
    edit(after);
    setBodyParts(m_context.document, text, property, after, phase);
}

QString CurrentVariation::add()
{
    VariationEntry variation;
    variation.name = tr("variations").toStdString();
    if (m_context.document.project().characters.size() > 1)
        variation.character = character().toStdString();
    QString added = addVariation(m_context.document, std::move(variation));
    m_context.selection.select({Section::Variations, added});
    return added;
}

} // namespace quadrille
