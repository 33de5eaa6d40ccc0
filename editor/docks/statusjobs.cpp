// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/statusjobs.h"

#include "editor/jobs/jobrunner.h"
#include "editor/language/retranslate.h"
#include "model/core/mediacache.h"
#include "widgets/theme/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

namespace quadrille {

StatusJobs::StatusJobs(JobRunner& jobs, QWidget* parent)
    : QWidget(parent)
    , m_jobs(jobs)
    , m_name(new QLabel)
    , m_progress(new QProgressBar)
    , m_cancel(new QToolButton)
    , m_cache(new QLabel)
    , m_timer(new QTimer(this))
{
    m_name->setObjectName(QStringLiteral("jobName"));
    m_progress->setFixedWidth(120);
    m_progress->setTextVisible(false);
    m_cancel->setIcon(widgets::icons::icon(QStringLiteral("cancel")));
    m_cancel->setAutoRaise(true);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 8, 0);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_name, m_progress, m_cancel, m_cache})
        row->addWidget(widget);
    connect(m_cancel, &QToolButton::clicked, this, [this] { m_jobs.cancelAll(); });
    connect(m_timer, &QTimer::timeout, this, &StatusJobs::refresh);
    m_timer->start(200);
    retranslates(this, [this] { refresh(); });
}

void StatusJobs::refresh()
{
    auto jobs = m_jobs.jobs();
    std::erase_if(jobs, [](const Job* job) { return job->isBackground(); });
    const bool isBusy = !jobs.empty();
    m_name->setVisible(isBusy);
    m_progress->setVisible(isBusy);
    m_cancel->setVisible(isBusy);
    m_cancel->setToolTip(tr("Cancel all jobs"));
    m_cancel->setAccessibleName(tr("Cancel all jobs"));
    if (isBusy) {
        const int more = static_cast<int>(jobs.size()) - 1;
        m_name->setText(more > 0 ? tr("%1, and %n more", nullptr, more).arg(jobs.front()->name())
                                 : jobs.front()->name());
        m_progress->setRange(0, 100);
        m_progress->setValue(static_cast<int>(100 * std::max(0.0, jobs.front()->fraction())));
    }
    const auto cache = MediaCache::shared()->statistics();
    m_cache->setText(tr("Cache %1 of %2 MB").arg(cache.bytes >> 20).arg(cache.budget >> 20));
    m_cache->setToolTip(tr("Memory that frames and textures take, and may take"));
}

} // namespace quadrille
