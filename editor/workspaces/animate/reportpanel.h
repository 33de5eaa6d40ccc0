// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/animate/report.h"

#include <QWidget>

class QLabel;
class QTreeWidget;

namespace quadrille {

class CurrentAnimation;

namespace widgets {
class LineChart;
class MessageStrip;
} // namespace widgets

/// What was asked of the animation and what its clip does, as a table and as a chart of the deviation from
/// the path over time; to be copied and saved.
class ReportPanel : public QWidget
{
    Q_OBJECT

public:
    /// Registers the actions.
    explicit ReportPanel(CurrentAnimation& animation, QWidget* parent = nullptr);

    /// Writes the table to a file, or says in the panel why it could not. \param ofFrames  a row for each
    /// frame, instead of the table that is shown.
    void save(const QString& file, bool ofFrames);

private:
    void makeActions();
    void arrangeWidgets();
    void retranslate();
    void refresh();
    void refreshChart();
    void followPlayer(qint64 frame);
    void copy() const;
    void askAndSave(bool ofFrames);
    double fps() const;

    CurrentAnimation& m_animation;
    std::shared_ptr<const AnimationResult> m_result; ///< that is shown
    std::vector<ReportRow> m_rows;
    widgets::MessageStrip* m_message;
    QWidget* m_buttons;
    QTreeWidget* m_table;
    widgets::LineChart* m_chart;
    QLabel* m_empty;
};

} // namespace quadrille
