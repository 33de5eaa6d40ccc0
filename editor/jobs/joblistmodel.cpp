// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/jobs/joblistmodel.h"

#include "editor/jobs/jobrunner.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace quadrille {

JobListModel::JobListModel(JobRunner& runner, QObject* parent) : QAbstractListModel(parent)
{
    for (Job* job : runner.jobs())
        add(job);
    connect(&runner, &JobRunner::started, this, &JobListModel::add);
    connect(&runner, &JobRunner::ended, this, &JobListModel::remove);
}

int JobListModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_jobs.size());
}

QVariant JobListModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Job& job = *m_jobs[static_cast<std::size_t>(index.row())];
    const std::optional<Seconds> left = job.timeLeft();
    switch (role) {
    case Qt::DisplayRole:
        return job.name();
    case FractionRole:
        return job.fraction();
    case SecondsLeftRole:
        return left ? QVariant(left->value) : QVariant();
    case StateRole:
        return QVariant::fromValue(job.state());
    case TimeLeftRole:
        return left ? timeLeftText(*left) : QString();
    default:
        return {};
    }
}

void JobListModel::cancel(const QModelIndex& index)
{
    if (checkIndex(index, CheckIndexOption::IndexIsValid))
        m_jobs[static_cast<std::size_t>(index.row())]->cancel();
}

double JobListModel::totalFraction() const
{
    if (m_jobs.empty())
        return 0;
    const double sum = std::accumulate(m_jobs.begin(), m_jobs.end(), 0.0,
                                       [](double s, const Job* job) { return s + job->fraction(); });
    return sum / static_cast<double>(m_jobs.size());
}

void JobListModel::add(Job* job)
{
    if (job->isBackground())
        return;
    const int row = static_cast<int>(m_jobs.size());
    beginInsertRows({}, row, row);
    m_jobs.push_back(job);
    endInsertRows();
    connect(job, &Job::changed, this, [this, job] { changed(job); });
    connect(job, &QObject::destroyed, this, [this, job] { remove(job); });
}

void JobListModel::changed(const Job* job)
{
    const auto found = std::find(m_jobs.begin(), m_jobs.end(), job);
    if (found == m_jobs.end())
        return;
    const QModelIndex changedIndex = index(static_cast<int>(found - m_jobs.begin()));
    emit dataChanged(changedIndex, changedIndex);
}

void JobListModel::remove(const Job* job)
{
    const auto found = std::find(m_jobs.begin(), m_jobs.end(), job);
    if (found == m_jobs.end())
        return;
    const int row = static_cast<int>(found - m_jobs.begin());
    beginRemoveRows({}, row, row);
    m_jobs.erase(found);
    endRemoveRows();
}

QString timeLeftText(Seconds left)
{
    constexpr double minute = 60;
    constexpr double hour = 3600;
    if (left.value < 1)
        return JobListModel::tr("less than a second left");
    if (left.value < minute)
        return JobListModel::tr("%n s left", nullptr, static_cast<int>(std::ceil(left.value)));
    if (left.value < hour)
        return JobListModel::tr("%n min left", nullptr, static_cast<int>(std::ceil(left.value / minute)));
    return JobListModel::tr("%n h left", nullptr, static_cast<int>(std::ceil(left.value / hour)));
}

} // namespace quadrille

#include "moc_joblistmodel.cpp"
