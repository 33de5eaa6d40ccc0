// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The project file of the window: what is told of it, its copies and their recovery.
#include "editor/application/projectfiles.h"
#include "editor/application/projectstrips.h"
#include "editor/application/recoveryflow.h"
#include "editor/application/recoverynotice.h"
#include "editor/application/refusalnotes.h"
#include "editor/application/sessionkeeper.h"
#include "editor/errors/errortext.h"
#include "editor/mainwindow.h"
#include "editor/relinking/relinkflow.h"
#include "editor/welcome/welcomepage.h"

#include <QDockWidget>

namespace quadrille {

void MainWindow::connectFiles()
{
    connect(m_files, &ProjectFiles::aboutToLeave, this, [this] { m_session->keep(); });
    connect(m_files, &ProjectFiles::saved, this, [this] {
        m_session->keep();
        m_relink->noteContents();
    });
    connect(&m_context.settings, &Settings::changed, this, [this] {
        m_autosave.setDelay(m_context.settings.autosaveSeconds());
        m_context.document.setHistoryBytes(static_cast<std::size_t>(m_context.settings.historyMegabytes())
                                           << 20U);
    });
    connect(m_files, &ProjectFiles::failed, this, &MainWindow::showProblem);
    connect(&m_files->guard(), &ProjectGuard::accessChanged, this, &MainWindow::showTitle);
    connect(m_strips, &ProjectStrips::aboutToRefresh, this, [this] { m_session->keep(); });
    connect(m_strips, &ProjectStrips::brokenShown, this, [this] {
        for (auto* dock : {findChild<QDockWidget*>(QStringLiteral("projectDock")), m_propertiesDock}) {
            dock->show();
            dock->raise();
        }
    });
    connect(new RefusalNotes(m_context.document, this), &RefusalNotes::told, this,
            [this](const QString& message) { showMessage(message, {message}); });
    m_recovery = new RecoveryFlow(m_context, m_autosave, *m_files, this);
    connect(m_recovery, &RecoveryFlow::told, this, &MainWindow::showProblem);
    auto* notice = new RecoveryNotice;
    m_welcome->addNotice(notice);
    connect(notice, &RecoveryNotice::recoverRequested, m_recovery, &RecoveryFlow::recover);
    connect(m_recovery, &RecoveryFlow::answered, notice, &RecoveryNotice::refresh);
    connect(&m_autosave, &Autosave::failed, this, [this](const Error& error) {
        m_context.issues.add(error);
        showProblem(describe(error).oneLine());
    });
}

void MainWindow::offerRecovery()
{
    m_recovery->offer();
}

void MainWindow::showTitle()
{
    const bool isWritable = m_files->guard().access() == ProjectGuard::Access::Full;
    const QString title = m_context.document.title();
    setWindowTitle((isWritable ? title : tr("%1 (read only)").arg(title)) +
                   QStringLiteral("[*] – Quadrille"));
}

} // namespace quadrille
