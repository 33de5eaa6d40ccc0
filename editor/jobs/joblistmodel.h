// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/jobs/job.h"

#include <QAbstractListModel>
#include <vector>

namespace quadrille {

class JobRunner;

/// The running jobs that the status bar shows, one per row; background jobs are left out.
class JobListModel : public QAbstractListModel
{
    Q_OBJECT
public:
    enum Role
    {
        FractionRole = Qt::UserRole, ///< double, 0 … 1
        SecondsLeftRole,             ///< double; invalid while unknown
        StateRole,                   ///< Job::State
        TimeLeftRole,                ///< QString, "2 min left"; empty while unknown
    };

    /// \param runner  outlives the model.
    explicit JobListModel(JobRunner& runner, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    /// Cancels the job of a row.
    void cancel(const QModelIndex& index);
    /// Mean of the rows' fractions; 0 without rows.
    double totalFraction() const;

private:
    void add(Job* job);
    void changed(const Job* job);
    void remove(const Job* job);

    std::vector<Job*> m_jobs;
};

/// "less than a second left", "12 s left", "3 min left", "2 h left": rounded as far as an estimate deserves.
QString timeLeftText(Seconds left);

} // namespace quadrille
