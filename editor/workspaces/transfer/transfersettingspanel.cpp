// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/transfer/transfersettingspanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/transferfields.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/transfer/currenttransfer.h"
#include "editor/workspaces/view/sceneview.h"

#include <QAction>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace quadrille {

TransferSettingsPanel::TransferSettingsPanel(CurrentTransfer& transfer, QWidget* parent)
    : QWidget(parent)
    , m_transfer(transfer)
    , m_form(new SettingForm)
    , m_fields(*m_form, [this](const QString& text, const char* property, const auto& change) {
        m_transfer.edit(text, QLatin1String(property), change);
    })
{
    setObjectName(QStringLiteral("transferSettingsPanel"));
    EditorContext& context = transfer.context();
    QAction* take = context.actions.add(
        {"transfer.takeReference",
         [] { return tr("Transfer"); },
         [] { return tr("Take the shown &frame as reference pose"); },
         [] { return tr("The pose in which the take is shown is the one that the body’s is like"); },
         "pin",
         {}},
        [this] { takeReference(); });
    addTransferSettings(m_fields,
                        {.reference = "transferPanelReference",
                         .field = "transferPanelField",
                         .scale = "transferPanelScale",
                         .poses = "transferPanelPoses",
                         .stretch = "transferPanelStretch",
                         .surroundings = "transferPanelSurroundings",
                         .contacts = "transferPanelContacts",
                         .truth = "transferPanelTruth"},
                        [&context]() -> const Project& { return context.document.project(); });
    QToolButton* button = makeActionButton(take);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* content = new QWidget;
    auto* rows = new QVBoxLayout(content);
    rows->addWidget(m_form);
    rows->addWidget(button, 0, Qt::AlignLeading);
    rows->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(verticalScroll(content));
    connect(&transfer, &CurrentTransfer::changed, this, &TransferSettingsPanel::refresh);
    connect(&transfer, &CurrentTransfer::showsReferenceChanged, this, &TransferSettingsPanel::refresh);
    retranslates(this, [this, take] {
        take->setIconText(tr("Take the shown frame")); // the panel is narrower than the menu
        m_fields.retranslate();
        refresh();
    });
}

void TransferSettingsPanel::takeReference()
{
    const std::string prefix = "sequences/";
    const TransferEntry* entry = m_transfer.entry();
    if (entry == nullptr || !entry->clip.starts_with(prefix))
        return;
    const NamedFrame shown{entry->clip.substr(prefix.size()),
                           FrameIndex(m_transfer.view().player().frame().value)};
    m_transfer.edit(tr("Take the reference pose"), QStringLiteral("reference"),
                    [&](TransferEntry& transfer) { transfer.reference = shown; });
}

void TransferSettingsPanel::refresh()
{
    const TransferEntry* entry = m_transfer.entry();
    m_form->setEnabled(entry != nullptr);
    m_fields.show(entry != nullptr ? *entry : TransferEntry());
    const bool isTake = entry != nullptr && entry->clip.starts_with("sequences/");
    m_transfer.context()
        .actions.action(QStringLiteral("transfer.takeReference"))
        ->setEnabled(isTake && !m_transfer.showsReference());
}

} // namespace quadrille

#include "moc_transfersettingspanel.cpp"
