// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QTimer;
class QToolButton;

namespace quadrille {

class JobRunner;

/// The status bar's corner: the job that runs longest with its progress and a button to cancel it, how many
/// more there are, and how much memory frames and textures take.
class StatusJobs : public QWidget
{
    Q_OBJECT

public:
    explicit StatusJobs(JobRunner& jobs, QWidget* parent = nullptr);

private:
    void refresh();

    JobRunner& m_jobs;
    QLabel* m_name;
    QProgressBar* m_progress;
    QToolButton* m_cancel;
    QLabel* m_cache;
    QTimer* m_timer;
};

} // namespace quadrille
