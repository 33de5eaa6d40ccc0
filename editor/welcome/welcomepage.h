// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/welcome/samplegoal.h"

#include <QWidget>
#include <array>

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace quadrille {

class RecentProjects;
class Settings;
class WelcomeTile;

namespace widgets {
class MessageStrip;
} // namespace widgets

/// What is shown while no project is open: the first step is one click, and three clicks lead to a new
/// performance of the sample.
class WelcomePage : public QWidget
{
    Q_OBJECT

public:
    explicit WelcomePage(Settings& settings, QWidget* parent = nullptr);

    /// Puts a row above everything else: something that is worth looking at first. It becomes the page's.
    void addNotice(QWidget* row);

public slots:
    /// Shows on its tile how far the sample is. \param fraction 0 … 1.
    void showSampleProgress(quadrille::SampleGoal goal, double fraction);
    void endSampleProgress();

signals:
    /// An action of the program, e.g. "file.open".
    void actionRequested(const QString& id);
    void projectRequested(const QString& file);
    void sampleRequested(quadrille::SampleGoal goal);
    /// Somebody does not want to wait for the sample.
    void sampleCancelled();

protected:
    void showEvent(QShowEvent* event) override;

private:
    QLabel* addHeading(QVBoxLayout& column, const QString& name);
    void addOwnTiles(QGridLayout& tiles);
    void addSampleTiles(QGridLayout& tiles);
    void askSample(SampleGoal goal);
    void showRecent();
    void offerToForget(const QString& file);
    void retranslate();

    QLabel* m_title;
    QLabel* m_lead;
    QVBoxLayout* m_notices;
    QLabel* m_ownTitle = nullptr;
    QLabel* m_sampleTitle = nullptr;
    QLabel* m_recentTitle = nullptr;
    std::array<WelcomeTile*, 3> m_own{};    ///< takes, a folder, a project
    std::array<WelcomeTile*, 3> m_sample{}; ///< in the order of SampleGoal
    widgets::MessageStrip* m_missing;
    QString m_missingFile;
    RecentProjects* m_recent;
};

} // namespace quadrille
