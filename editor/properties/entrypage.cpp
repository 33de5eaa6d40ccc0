// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/entrypage.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>

namespace quadrille {

EntryPage::EntryPage(EditorContext& context, Subject subject)
    : m_context(context)
    , m_subject(std::move(subject))
    , m_nameField(new QLineEdit)
    , m_character(new QComboBox)
{
    const QByteArray prefix = m_subject.name;
    m_character->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    addField((prefix + "Name").constData(), [] { return tr("Name"); }, m_nameField,
             [] { return tr("Unique in the project"); });
    addField((prefix + "Character").constData(), [] { return tr("Character"); }, m_character,
             m_subject.characterTip);
    connect(m_nameField, &QLineEdit::editingFinished, this, [this] {
        renameEntry(m_context.document, {m_subject.section, m_name}, m_nameField->text());
    });
    connect(m_character, &QComboBox::textActivated, this, [this](const QString& chosen) {
        if (chosen != character())
            setCharacter(chosen);
    });
}

void EntryPage::addOpen()
{
    m_open = new QPushButton;
    connect(m_open, &QPushButton::clicked, this, [this] {
        select();
        m_context.actions.action(QLatin1String(m_subject.workspace))->trigger();
    });
    addWide((QByteArray(m_subject.name) + "Open").constData(), m_open);
    retranslate();
}

void EntryPage::show(const QString& name)
{
    m_name = name;
    showName(*m_nameField, name);
    m_character->clear();
    for (const CharacterEntry& entry : m_context.document.project().characters)
        m_character->addItem(QString::fromStdString(entry.name));
    m_character->setCurrentText(character());
    setRowVisible(m_character, m_character->count() > 1);
}

void EntryPage::retranslate()
{
    if (m_open != nullptr)
        m_open->setText(tr("Work on it"));
}

void EntryPage::select()
{
    m_context.selection.select({m_subject.section, m_name});
}

} // namespace quadrille

#include "moc_entrypage.cpp"
