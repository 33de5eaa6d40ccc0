// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/appearancepage.h"

#include "editor/commands/appearanceedits.h"
#include "editor/context/editorcontext.h"
#include "editor/fields/appearancefields.h"
#include "model/project/document/findentry.h"

namespace quadrille {

AppearancePage::AppearancePage(EditorContext& context)
    : EntryPage(context,
                {.section = Section::Appearances,
                 .name = "appearance",
                 .workspace = "workspace.appearance",
                 .characterTip =
                     [] {
                         return tr(
                             "Whose textures are learned; its sequences are chosen anew with another one");
                     }})
    , m_form(new SettingForm)
    , m_fields(*m_form, [this](const QString& text, const char* property, const auto& change) {
        AppearanceEntry after =
            *findAppearance(EntryPage::context().document.project(), entryName().toStdString());
        change(after);
        setAppearance(EntryPage::context().document, entryName(), text, QLatin1String(property),
                      std::move(after));
    })
{
    m_sequences = addFact("appearanceSequences", [] { return tr("Learned from"); });
    m_completions = addFact("appearanceCompletions", [] { return tr("Completed"); });
    addAppearanceFields(m_fields, {.components = "appearanceComponents",
                                   .warps = "appearanceWarps",
                                   .flow = "appearanceFlow",
                                   .varied = "appearanceVaried"});
    addWide("appearanceSettings", m_form);
    retranslate();
}

QString AppearancePage::character() const
{
    const Project& project = context().document.project();
    return QString::fromStdString(
        characterNameOf(project, *findAppearance(project, entryName().toStdString())));
}

void AppearancePage::setCharacter(const QString& character)
{
    AppearanceEntry after = *findAppearance(context().document.project(), entryName().toStdString());
    after.character = character.toStdString();
    after.sequences.clear();
    after.completions.clear();
    after.reference.reset();
    setAppearance(context().document, entryName(), tr("Change the character of “%1”").arg(entryName()),
                  QStringLiteral("character"), std::move(after));
}

void AppearancePage::retranslate()
{
    EntryPage::retranslate();
    m_fields.retranslate();
}

void AppearancePage::show(const QString& name)
{
    EntryPage::show(name);
    const AppearanceEntry& entry = *findAppearance(context().document.project(), name.toStdString());
    QStringList sequences;
    for (const std::string& sequence : entry.sequences)
        sequences += QString::fromStdString(sequence);
    m_sequences->setText(sequences.isEmpty() ? tr("all with a texture for each frame")
                                             : sequences.join(QStringLiteral(", ")));
    m_completions->setText(tr("%n texture(s)", nullptr, static_cast<int>(entry.completions.size())));
    m_fields.show(entry);
}

} // namespace quadrille

#include "moc_appearancepage.cpp"
