// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QTimer;
class QToolButton;

namespace quadrille {

class JobListModel;
class JobRunner;
class JobsPopup;

/// The status bar's corner: the job that runs longest with its progress, the time it still takes and a button
/// to cancel, how many more there are (a click lists them all), and how much memory frames and textures take.
class StatusJobs : public QWidget
{
    Q_OBJECT

public:
    /// \param jobs  outlive it. Its button cancels the one that it shows.
    explicit StatusJobs(JobRunner& jobs, QWidget* parent = nullptr);

    /// Lists all running jobs, each with its own button to cancel it.
    void showJobs();

private:
    void refreshJobs();
    void refreshCache();
    void fit();

    JobListModel* m_jobs;
    JobsPopup* m_popup;
    QToolButton* m_name;
    QProgressBar* m_progress;
    QLabel* m_timeLeft;
    QToolButton* m_cancel;
    QLabel* m_cache;
    QTimer* m_timer;
};

} // namespace quadrille
