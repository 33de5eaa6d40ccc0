// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/statusjobs.h"

#include "editor/docks/jobspopup.h"
#include "editor/jobs/joblistmodel.h"
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
    , m_jobs(new JobListModel(jobs, this))
    , m_popup(new JobsPopup(*m_jobs, this))
    , m_name(new QToolButton)
    , m_progress(new QProgressBar)
    , m_timeLeft(new QLabel)
    , m_cancel(new QToolButton)
    , m_cache(new QLabel)
    , m_timer(new QTimer(this))
{
    m_name->setObjectName(QStringLiteral("jobName"));
    m_name->setAutoRaise(true);
    m_name->setFocusPolicy(Qt::TabFocus);
    m_progress->setFixedWidth(120);
    m_progress->setTextVisible(false);
    m_progress->setRange(0, 1000);
    m_timeLeft->setObjectName(QStringLiteral("jobTimeLeft"));
    m_cancel->setObjectName(QStringLiteral("cancelJob"));
    m_cancel->setIcon(widgets::icons::icon(QStringLiteral("cancel")));
    m_cancel->setAutoRaise(true);
    m_cancel->setFocusPolicy(Qt::TabFocus);
    m_cache->setObjectName(QStringLiteral("cacheUse"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 8, 0);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_name, m_progress, m_timeLeft, m_cancel, m_cache})
        row->addWidget(widget);
    connect(m_name, &QToolButton::clicked, this, &StatusJobs::showJobs);
    connect(m_cancel, &QToolButton::clicked, this, [this] { m_jobs->cancel(m_jobs->index(0)); });
    connect(m_jobs, &QAbstractItemModel::rowsInserted, this, &StatusJobs::refreshJobs);
    connect(m_jobs, &QAbstractItemModel::rowsRemoved, this, &StatusJobs::refreshJobs);
    connect(m_jobs, &QAbstractItemModel::dataChanged, this, &StatusJobs::refreshJobs);
    connect(m_timer, &QTimer::timeout, this, &StatusJobs::refreshCache);
    constexpr std::chrono::milliseconds cacheInterval{500};
    m_timer->start(cacheInterval);
    retranslates(this, [this] {
        // The window must not jump when jobs come and go.
        setMinimumHeight(std::max(
            {m_name->sizeHint().height(), m_cancel->sizeHint().height(), m_progress->sizeHint().height()}));
        m_name->setToolTip(tr("List the running jobs"));
        refreshJobs();
        refreshCache();
    });
}

void StatusJobs::showJobs()
{
    if (m_jobs->rowCount() > 0)
        m_popup->showAbove(mapToGlobal(QPoint(width(), 0)));
}

void StatusJobs::refreshJobs()
{
    const int count = m_jobs->rowCount();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_name, m_progress, m_timeLeft, m_cancel})
        widget->setVisible(count > 0);
    if (count == 0)
        return;
    const QModelIndex first = m_jobs->index(0);
    const QString name = first.data(Qt::DisplayRole).toString();
    m_cancel->setToolTip(tr("Cancel “%1”").arg(name));
    m_cancel->setAccessibleName(m_cancel->toolTip());
    m_name->setText(count > 1 ? tr("%1, and %n more", nullptr, count - 1).arg(name) : name);
    m_progress->setAccessibleName(name);
    m_progress->setValue(
        static_cast<int>(1000 * std::max(0.0, first.data(JobListModel::FractionRole).toDouble())));
    m_timeLeft->setText(first.data(JobListModel::TimeLeftRole).toString());
    fit();
}

/// At once: while the machine computes, the next layout may be long in coming, and words would be cut.
void StatusJobs::fit()
{
    layout()->activate();
    updateGeometry();
    if (parentWidget() != nullptr && parentWidget()->layout() != nullptr)
        parentWidget()->layout()->activate();
}

void StatusJobs::refreshCache()
{
    const auto cache = MediaCache::shared()->statistics();
    m_cache->setText(tr("Cache %1 of %2 MB").arg(cache.bytes >> 20).arg(cache.budget >> 20));
    m_cache->setToolTip(tr("Memory that frames and textures take, and may take"));
    fit();
}

} // namespace quadrille

#include "moc_statusjobs.cpp"
