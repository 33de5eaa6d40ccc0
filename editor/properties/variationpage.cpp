// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/variationpage.h"

#include "editor/application/editorcontext.h"
#include "editor/commands/projectedits.h"
#include "editor/commands/variationedits.h"
#include "model/project/madeclips.h"
#include "model/project/opensequence.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>

namespace quadrille {

VariationPage::VariationPage(EditorContext& context)
    : m_context(context), m_nameField(new QLineEdit), m_character(new QComboBox), m_open(new QPushButton)
{
    m_character->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    addField(
        "variationName", [] { return tr("Name"); }, m_nameField, [] { return tr("Unique in the project"); });
    addField(
        "variationCharacter", [] { return tr("Character"); }, m_character,
        [] { return tr("Whose movement is learned; its takes are chosen anew with another one"); });
    m_takes = addFact("variationTakes", [] { return tr("Learned from"); });
    m_samples = addFact("variationSamples", [] { return tr("Drawn"); });
    m_takes->setWordWrap(true);
    m_samples->setWordWrap(true);
    addWide("variationOpen", m_open);
    connect(m_nameField, &QLineEdit::editingFinished, this, [this] {
        if (!renameEntry(m_context.document, {Section::Variations, m_name}, m_nameField->text()))
            m_nameField->setText(m_name);
    });
    connect(m_character, &QComboBox::textActivated, this, [this](const QString& character) {
        VariationEntry after = *m_context.document.variation(m_name);
        if (after.character == character.toStdString())
            return;
        after.character = character.toStdString();
        after.training.clear();
        after.blends.clear();
        after.samples.clear();
        after.reference.clear();
        after.templatePose.reset();
        setVariation(m_context.document, m_name, tr("Change the character of “%1”").arg(m_name),
                     QStringLiteral("character"), std::move(after));
    });
    connect(m_open, &QPushButton::clicked, this, [this] {
        m_context.selection.select({Section::Variations, m_name});
        m_context.actions.action(QStringLiteral("workspace.variations"))->trigger();
    });
    retranslate();
}

void VariationPage::show(const QString& name)
{
    m_name = name;
    const VariationEntry& entry = *m_context.document.variation(name);
    if (!m_nameField->hasFocus() || !m_nameField->isModified())
        m_nameField->setText(name);
    m_character->clear();
    for (const CharacterEntry& character : m_context.document.project().characters)
        m_character->addItem(QString::fromStdString(character.name));
    m_character->setCurrentText(QString::fromStdString(characterNameOf(m_context.document.project(), entry)));
    setFieldVisible(m_character, m_character->count() > 1);
    QStringList takes;
    for (const TrainingEntry& take : entry.training)
        takes += QString::fromStdString(take.sequence);
    m_takes->setText(takes.isEmpty() ? tr("nothing yet") : takes.join(QStringLiteral(", ")));
    m_samples->setText(tr("%n variation(s)", nullptr, variationCount(entry)));
}

void VariationPage::retranslate()
{
    m_open->setText(tr("Work on it"));
}

} // namespace quadrille
