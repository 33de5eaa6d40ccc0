// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/recoveryflow.h"

#include "editor/application/autosave.h"
#include "editor/application/projectfiles.h"
#include "editor/application/recoveries.h"
#include "editor/context/editorcontext.h"

#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

namespace quadrille {

RecoveryFlow::RecoveryFlow(EditorContext& context, Autosave& autosave, ProjectFiles& files, QWidget* window)
    : QObject(window), m_context(context), m_autosave(autosave), m_files(files), m_window(window)
{
}

void RecoveryFlow::offer()
{
    const Recoveries found = findRecoveries();
    for (const QString& file : found.unreadable) {
        const QString text =
            tr("A copy of unsaved edits cannot be read. It was kept, and lies at %1 now.").arg(file);
        Issue issue;
        issue.context.values = {{"text", text.toStdString()}};
        m_context.issues.add(issue);
        emit told(text);
    }
    if (found.works.empty())
        return;
    const Recovery& newest = found.works.front();
    auto* box =
        new QMessageBox(QMessageBox::Question, tr("Unsaved edits were kept"),
                        tr("Quadrille ended unexpectedly. Edits of “%1” from %2 were never saved.")
                            .arg(newest.title(), QLocale().toString(newest.saved, QLocale::ShortFormat)),
                        QMessageBox::NoButton, m_window);
    box->setObjectName(QStringLiteral("recovery"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(tr("Recover them, or discard them for good."));
    QPushButton* recoverButton = box->addButton(tr("Recover"), QMessageBox::AcceptRole);
    QPushButton* discard = box->addButton(tr("Discard"), QMessageBox::DestructiveRole);
    QPushButton* later = box->addButton(tr("Ask again later"), QMessageBox::RejectRole);
    recoverButton->setObjectName(QStringLiteral("recoveryAccept"));
    discard->setObjectName(QStringLiteral("recoveryDiscard"));
    box->setDefaultButton(recoverButton);
    box->setEscapeButton(later);
    connect(recoverButton, &QPushButton::clicked, this, [this, newest] { recover(newest); });
    connect(discard, &QPushButton::clicked, this, [id = newest.id] { discardRecovery(id); });
    connect(box, &QMessageBox::finished, this, &RecoveryFlow::answered);
    box->open();
}

void RecoveryFlow::recover(const Recovery& recovery)
{
    if (m_files.recover(recovery))
        m_autosave.adopt(recovery.id);
    emit answered();
}

} // namespace quadrille

#include "moc_recoveryflow.cpp"
