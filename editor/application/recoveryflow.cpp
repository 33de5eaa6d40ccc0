// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/recoveryflow.h"

#include "editor/application/autosave.h"
#include "editor/application/editorcontext.h"
#include "editor/documents/projectpaths.h"

#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

namespace quadrille {

RecoveryFlow::RecoveryFlow(EditorContext& context, Autosave& autosave, QWidget* window)
    : QObject(window), m_context(context), m_autosave(autosave), m_window(window)
{
}

void RecoveryFlow::offer()
{
    const std::optional<Recovery> found = Autosave::findRecovery();
    if (!found)
        return;
    auto* box =
        new QMessageBox(QMessageBox::Question, tr("Unsaved edits were kept"),
                        tr("Quadrille ended unexpectedly. Edits of “%1” from %2 were never saved.")
                            .arg(found->title(), QLocale().toString(found->saved, QLocale::ShortFormat)),
                        QMessageBox::NoButton, m_window);
    box->setObjectName(QStringLiteral("recovery"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(tr("Recover them, or discard them for good."));
    QPushButton* recover = box->addButton(tr("Recover"), QMessageBox::AcceptRole);
    QPushButton* discard = box->addButton(tr("Discard"), QMessageBox::DestructiveRole);
    QPushButton* later = box->addButton(tr("Ask again later"), QMessageBox::RejectRole);
    recover->setObjectName(QStringLiteral("recoveryAccept"));
    discard->setObjectName(QStringLiteral("recoveryDiscard"));
    box->setDefaultButton(recover);
    box->setEscapeButton(later);
    connect(recover, &QPushButton::clicked, this, [this, recovery = *found] {
        if (recovery.projectFile.isEmpty())
            m_context.document.reset(recovery.project, true);
        else
            m_context.document.recover(recovery.project, toPath(recovery.projectFile));
        m_autosave.adopt(recovery);
    });
    connect(discard, &QPushButton::clicked, this, [recovery = *found] { Autosave::discard(recovery); });
    box->open();
}

} // namespace quadrille
