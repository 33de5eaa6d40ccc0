// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/transferpage.h"

#include "editor/commands/transferedits.h"
#include "editor/context/editorcontext.h"
#include "editor/fields/transferfields.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"

namespace quadrille {

namespace {

constexpr TransferNames pageNames{.clip = "transferClip",
                                  .target = "transferTarget",
                                  .reference = "transferReference",
                                  .field = "transferField",
                                  .scale = "transferScale",
                                  .poses = "transferPoses",
                                  .stretch = "transferStretch",
                                  .surroundings = "transferSurroundings",
                                  .contacts = "transferContacts",
                                  .truth = "transferTruth"};

} // namespace

TransferPage::TransferPage(EditorContext& context)
    : EntryPage(context,
                {.section = Section::Transfers,
                 .name = "transfer",
                 .workspace = "workspace.transfer",
                 .characterTip =
                     [] { return tr("Whose body performs the clip; pairs are made anew with another one"); }})
    , m_form(new SettingForm)
    , m_fields(*m_form, [this](const QString& text, const char* property, const auto& change) {
        TransferEntry after =
            *findTransfer(EntryPage::context().document.project(), entryName().toStdString());
        change(after);
        setTransfer(EntryPage::context().document, entryName(), text, QLatin1String(property),
                    std::move(after));
    })
{
    m_pairs = addFact("transferPairs", [] { return tr("Pairs"); });
    const auto project = [&context]() -> const Project& { return context.document.project(); };
    addTransferSubjects(m_fields, pageNames, project);
    addTransferSettings(m_fields, pageNames, project);
    addWide("transferSettings", m_form);
    addOpen();
    retranslate();
}

QString TransferPage::character() const
{
    const Project& project = context().document.project();
    const TransferEntry& entry = *findTransfer(project, entryName().toStdString());
    return QString::fromStdString(characterOfClip(project, "sequences/" + entry.target.sequence));
}

void TransferPage::setCharacter(const QString& character)
{
    const Project& project = context().document.project();
    for (const SequenceEntry& sequence : project.sequences) {
        if (characterOfClip(project, "sequences/" + sequence.name) != character.toStdString())
            continue;
        TransferEntry after = *findTransfer(project, entryName().toStdString());
        setTarget(after, sequence.name, project);
        setTransfer(context().document, entryName(), tr("Let another body perform “%1”").arg(entryName()),
                    QStringLiteral("target"), std::move(after));
        return;
    }
}

void TransferPage::retranslate()
{
    EntryPage::retranslate();
    m_fields.retranslate();
}

void TransferPage::show(const QString& name)
{
    EntryPage::show(name);
    const TransferEntry& entry = *findTransfer(context().document.project(), name.toStdString());
    m_pairs->setText(entry.pairs.empty() ? tr("proposed")
                                         : tr("%n pair(s)", nullptr, static_cast<int>(entry.pairs.size())));
    m_fields.show(entry);
}

} // namespace quadrille

#include "moc_transferpage.cpp"
