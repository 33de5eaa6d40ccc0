// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/variationpage.h"

#include "editor/commands/variationedits.h"
#include "editor/context/editorcontext.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"

namespace quadrille {

VariationPage::VariationPage(EditorContext& context)
    : EntryPage(context,
                {.section = Section::Variations,
                 .name = "variation",
                 .workspace = "workspace.variations",
                 .characterTip = [] {
                     return tr("Whose movement is learned; its takes are chosen anew with another one");
                 }})
{
    m_takes = addFact("variationTakes", [] { return tr("Learned from"); });
    m_samples = addFact("variationSamples", [] { return tr("Drawn"); });
    addOpen();
}

QString VariationPage::character() const
{
    const Project& project = context().document.project();
    return QString::fromStdString(characterNameOf(project, *context().document.variation(entryName())));
}

void VariationPage::setCharacter(const QString& character)
{
    VariationEntry after = *context().document.variation(entryName());
    after.character = character.toStdString();
    after.training.clear();
    after.blends.clear();
    after.samples.clear();
    after.reference.clear();
    after.templatePose.reset();
    setVariation(context().document, entryName(), tr("Change the character of “%1”").arg(entryName()),
                 QStringLiteral("character"), std::move(after));
}

void VariationPage::show(const QString& name)
{
    EntryPage::show(name);
    const VariationEntry& entry = *context().document.variation(name);
    QStringList takes;
    for (const TrainingEntry& take : entry.training)
        takes += QString::fromStdString(take.sequence);
    m_takes->setText(takes.isEmpty() ? tr("nothing yet") : takes.join(QStringLiteral(", ")));
    m_samples->setText(tr("%n variation(s)", nullptr, variationCount(entry)));
}

} // namespace quadrille

#include "moc_variationpage.cpp"
