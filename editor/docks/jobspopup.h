// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>
#include <vector>

class QLabel;
class QProgressBar;
class QToolButton;
class QVBoxLayout;

namespace quadrille {

class JobListModel;

/// A pop-up with a row for every running job: its name, how far it is, how long it will take, and a button
/// that cancels it alone. Closes itself when nothing runs any more.
class JobsPopup : public QFrame
{
    Q_OBJECT
public:
    /// \param jobs  outlive it.
    explicit JobsPopup(JobListModel& jobs, QWidget* parent = nullptr);

    /// Shows it with its lower right corner at a place on the screen.
    void showAbove(const QPoint& corner);

private:
    struct Row
    {
        QWidget* widget;
        QLabel* name;
        QLabel* timeLeft;
        QProgressBar* progress;
        QToolButton* cancel;
    };
    void addRow();
    void refresh();
    void cancelRow(const QWidget* widget);
    void place();

    JobListModel& m_jobs;
    QVBoxLayout* m_column;
    std::vector<Row> m_rows;
    QPoint m_corner;
};

} // namespace quadrille
