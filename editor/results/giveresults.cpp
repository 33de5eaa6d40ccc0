// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/results/giveresults.h"

#include "editor/errors/issuelog.h"
#include "editor/jobs/jobrunner.h"
#include "model/core/caughterror.h"
#include "model/project/store/carryresults.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QPointer>
#include <QProgressDialog>

namespace quadrille {

namespace {

struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::GiveResults)
};

/// Copies by a job, and waits while the interface goes on.
void copyAndWait(const std::filesystem::path& from, const std::filesystem::path& to, JobRunner& jobs,
                 IssueLog& issues, QWidget* window)
{
    QProgressDialog dialog(Texts::tr("Copying the results to the new place…"), Texts::tr("Skip"), 0, 1000,
                           window);
    dialog.setObjectName(QStringLiteral("givingResults"));
    dialog.setWindowModality(Qt::WindowModal);
    dialog.setAutoReset(false);
    dialog.setMinimumDuration(0);
    dialog.show(); // nothing else may be done with the project meanwhile
    QEventLoop loop;
    const QPointer<Job> job = jobs.start(
        {.name = Texts::tr("Copying results"),
         .receiver = &dialog,
         .failed = [&issues](const Error& error) { issues.add(error); }},
        [from, to](const Progress& progress) { copyResults(from, to, progress); }, [] {});
    QObject::connect(job, &Job::changed, &dialog,
                     [&] { dialog.setValue(static_cast<int>(1000 * job->fraction())); });
    QObject::connect(job, &Job::ended, &loop, &QEventLoop::quit);
    QObject::connect(&dialog, &QProgressDialog::canceled, job, &Job::cancel);
    loop.exec();
}

} // namespace

void giveResults(const std::filesystem::path& fromProject, const std::filesystem::path& toProject,
                 JobRunner& jobs, IssueLog& issues, QWidget* window)
{
    try {
        if (!linkResults(fromProject, toProject))
            copyAndWait(fromProject, toProject, jobs, issues, window);
    } catch (...) {
        issues.add(caughtError(toProject));
    }
}

} // namespace quadrille
