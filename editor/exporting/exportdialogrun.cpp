// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/editorcontext.h"
#include "editor/commands/projectedits.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"
#include "editor/exporting/exportdialog.h"
#include "model/project/runexports.h"
#include "widgets/controls/messagestrip.h"

#include <QMessageBox>
#include <QPushButton>

namespace quadrille {

bool ExportDialog::mayWriteOver()
{
    const QStringList files = m_plan.filesInTheWay(framesWritten().value_or(1));
    if (files.isEmpty() || !m_plan.edited.isEmpty())
        return true;
    const QString what = files.size() == 1 ? tr("“%1” is there already.").arg(files.front())
                                           : tr("“%1” and %n more are there already.", nullptr,
                                                static_cast<int>(files.size() - 1))
                                                 .arg(files.front());
    QMessageBox box(QMessageBox::Warning, tr("Write over files?"), what, QMessageBox::Cancel, this);
    box.setObjectName(QStringLiteral("exportOverwrite"));
    box.setInformativeText(tr("Exporting writes over them."));
    QPushButton* overwrite = box.addButton(tr("Write over"), QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() == overwrite;
}

void ExportDialog::start()
{
    readControls();
    if (!mayWriteOver())
        return;
    setBusy(true);
    m_context.jobs.start(
        {.name = tr("Exporting %1").arg(toQString(std::filesystem::path(m_plan.entry.path).filename())),
         .receiver = this,
         .failed =
             [this](const Error& error) {
                 setBusy(false);
                 const ErrorText text = describe(error);
                 m_strip->show(widgets::MessageStrip::Kind::Error,
                               text.where.isEmpty() ? text.sentence
                                                    : tr("%1 (%2)").arg(text.sentence, text.where),
                               text.remedy);
             }},
        [project = m_context.document.snapshot(), file = m_context.document.workingFile(),
         entries = m_plan.entries()](const Progress& progress) {
            return runExports(project, file, entries, progress);
        },
        [this](const std::vector<ExportResult>& results) { finish(results); });
}

void ExportDialog::finish(const std::vector<ExportResult>& results)
{
    m_context.media.refresh();
    QStringList files;
    for (const ExportResult& result : results) {
        for (const auto& file : result.files)
            files += toQString(file);
        for (const Issue& issue : result.issues)
            m_context.issues.add(issue, QString::fromStdString(m_plan.entry.name));
    }
    if (!m_plan.edited.isEmpty()) {
        setExport(m_context.document, m_plan.edited, m_plan.entries().front());
    } else if (m_plan.isKept) {
        for (ExportEntry& entry : m_plan.entries())
            addExport(m_context.document, std::move(entry));
    }
    emit exported(files);
    accept();
}

} // namespace quadrille
