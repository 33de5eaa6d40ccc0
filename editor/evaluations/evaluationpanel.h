// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/evaluationresults.h"
#include "editor/evaluations/evaluationcharts.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QSortFilterProxyModel;
class QSplitter;
class QStackedWidget;
class QTabBar;
class QTableView;

namespace quadrille {

class EvaluationChooser;
class EvaluationTableModel;
struct EditorContext;

namespace widgets {
class MessageStrip;
} // namespace widgets

/// Content of the Evaluation dock: what the selected evaluation measured, as tables and charts; or what can
/// be evaluated.
class EvaluationPanel : public QWidget
{
    Q_OBJECT

public:
    explicit EvaluationPanel(EditorContext& context, QWidget* parent = nullptr);

    /// Writes the table that is shown as comma-separated values. Where it cannot be written, the panel says
    /// why.
    void save(const QString& file);
    /// Less than what is in it: a low window must not grow with it.
    QSize minimumSizeHint() const override { return {200, 60}; }
    QSize sizeHint() const override { return {640, 320}; }

private:
    void makeActions();
    QWidget* makeHead();
    QWidget* makeTables();
    QWidget* makeCharts();
    void arrangeWidgets();
    void connectParts();
    void bring();
    void followSelection();
    void show(const QString& name);
    using QWidget::show;
    void showChooser();
    void refresh();
    void showState(const EvaluationResults::State& resultState);
    void showProgress();
    void showTables();
    void showTable(int tab);
    void showCharts();
    void showChart(int index);
    void updateActions();
    void copy() const;
    void askAndSave();
    const EvaluationResults::State* resultState() const;

    EditorContext& m_context;
    QString m_name; ///< see evaluationName()
    QStackedWidget* m_pages;
    EvaluationChooser* m_chooser;
    QLabel* m_title;
    QLabel* m_sentence;
    widgets::MessageStrip* m_message;
    QProgressBar* m_progress;
    QStackedWidget* m_results;
    QLabel* m_empty;
    QPushButton* m_compute;
    QSplitter* m_splitter;
    QTabBar* m_tabs;
    QTableView* m_table;
    EvaluationTableModel* m_model;
    QSortFilterProxyModel* m_sorted;
    QComboBox* m_chartChoice;
    QStackedWidget* m_chartPages;
    widgets::LineChart* m_lines;
    widgets::BarChart* m_bars;
    QScrollArea* m_barArea;
    std::vector<EvaluationChart> m_charts;
    QPointer<Job> m_job; ///< whose progress is followed
};

} // namespace quadrille
