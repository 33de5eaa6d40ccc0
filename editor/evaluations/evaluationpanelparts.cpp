// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What the panel of evaluations is made of, and its actions.
#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"
#include "editor/evaluations/evaluationchooser.h"
#include "editor/evaluations/evaluationpanel.h"
#include "editor/evaluations/evaluationtablemodel.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/rightmenu.h"
#include "editor/workspaces/workspace.h"
#include "model/core/stagedfiles.h"
#include "model/project/media/projectguard.h"
#include "widgets/controls/messagestrip.h"

#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMainWindow>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>

namespace quadrille {

void EvaluationPanel::makeActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto group = [] { return tr("Evaluations"); };
    actions.add(
        {"evaluations.add",
         group,
         [] { return tr("&Add an evaluation…"); },
         [] { return tr("Lists what can be measured of the project’s takes, and of what is made of them"); },
         "add",
         {}},
        [this] {
            showChooser();
            bring();
            m_chooser->begin();
        });
    actions.add({"evaluations.show",
                 group,
                 [] { return tr("&Show the evaluation"); },
                 [] { return tr("Shows tables and charts of the selected evaluation"); },
                 "evaluation",
                 {}},
                [this] {
                    bring();
                    (m_results->currentIndex() == 1 ? static_cast<QWidget*>(m_table) : m_compute)->setFocus();
                });
    actions.add({"evaluations.compute",
                 group,
                 [] { return tr("&Compute the evaluation"); },
                 [] { return tr("Computes the selected evaluation and what it needs, as a rebuild does"); },
                 "refresh",
                 {}},
                [this] {
                    bring();
                    m_context.evaluations.compute(m_name);
                });
    actions.add({"evaluations.stop",
                 group,
                 [] { return tr("S&top computing"); },
                 [] { return tr("Stops computing the selected evaluation"); },
                 "stop",
                 {}},
                [this] { m_context.evaluations.stop(m_name); });
    actions.add({"evaluations.copy",
                 group,
                 [] { return tr("C&opy the table"); },
                 [] { return tr("Copies the table that is shown as comma-separated values"); },
                 "copy",
                 {}},
                [this] { copy(); });
    actions.add({"evaluations.save",
                 group,
                 [] { return tr("Sa&ve the table…"); },
                 [] { return tr("Saves the table that is shown as a CSV file"); },
                 "save",
                 {}},
                [this] { askAndSave(); });
}

/// To the front, as high as two fifths of the window where it was hidden.
void EvaluationPanel::bring()
{
    auto* dock = qobject_cast<QDockWidget*>(parentWidget());
    const bool wasHidden = dock != nullptr && dock->isHidden();
    Workspace::showPanel(this);
    auto* window = qobject_cast<QMainWindow*>(this->window());
    if (wasHidden && window != nullptr)
        window->resizeDocks({dock}, {window->height() * 2 / 5}, Qt::Vertical);
}

QWidget* EvaluationPanel::makeHead()
{
    auto* head = new QWidget;
    m_title = new QLabel;
    m_sentence = new QLabel;
    m_progress = new QProgressBar;
    m_title->setObjectName(QStringLiteral("evaluationTitle"));
    m_sentence->setObjectName(QStringLiteral("evaluationSentence"));
    m_progress->setObjectName(QStringLiteral("evaluationProgress"));
    QFont heavier = font();
    heavier.setWeight(QFont::DemiBold);
    m_title->setFont(heavier);
    m_sentence->setForegroundRole(QPalette::PlaceholderText);
    m_sentence->setWordWrap(true);
    m_sentence->setMinimumWidth(80);
    m_progress->setRange(0, 1000);
    m_progress->setFixedWidth(140);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(12, 4, 8, 4);
    row->setSpacing(8);
    row->addWidget(m_title);
    row->addWidget(m_sentence, 1);
    row->addWidget(m_progress);
    for (const char* id : {"evaluations.compute", "evaluations.copy", "evaluations.save", "evaluations.add"})
        row->addWidget(makeActionButton(m_context.actions.action(QLatin1String(id))));
    return head;
}

QWidget* EvaluationPanel::makeTables()
{
    m_tabs = new QTabBar;
    m_table = new QTableView;
    m_model = new EvaluationTableModel(this);
    m_sorted = new QSortFilterProxyModel(this);
    m_tabs->setObjectName(QStringLiteral("evaluationTabs"));
    m_tabs->setDrawBase(false);
    m_tabs->setExpanding(false);
    m_table->setObjectName(QStringLiteral("evaluationTable"));
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(EvaluationTableModel::SortRole);
    m_sorted->setSortLocaleAware(true);
    m_table->setModel(m_sorted);
    m_table->setSortingEnabled(true);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->hide();
    constexpr int rowHeight = 24;
    m_table->verticalHeader()->setDefaultSectionSize(rowHeight);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->setMinimumHeight(3 * rowHeight);
    addRightMenu(*m_table, {m_context.actions.action("evaluations.copy"),
                            m_context.actions.action("evaluations.save")});
    auto* tables = new QWidget;
    auto* column = new QVBoxLayout(tables);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_tabs);
    column->addWidget(m_table, 1);
    return tables;
}

QWidget* EvaluationPanel::makeCharts()
{
    m_chartChoice = new QComboBox;
    m_chartPages = new QStackedWidget;
    m_lines = new widgets::LineChart;
    m_bars = new widgets::BarChart;
    m_barArea = new QScrollArea;
    m_chartChoice->setObjectName(QStringLiteral("evaluationChartChoice"));
    m_lines->setObjectName(QStringLiteral("evaluationLines"));
    m_bars->setObjectName(QStringLiteral("evaluationBars"));
    m_chartChoice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_chartChoice->setMinimumContentsLength(12);
    m_barArea->setWidget(m_bars);
    m_barArea->setWidgetResizable(true);
    m_barArea->setFrameShape(QFrame::NoFrame);
    m_barArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_barArea->setFocusPolicy(Qt::NoFocus);
    connect(m_bars, &widgets::BarChart::readingMoved, m_barArea, [this](int top, int bottom) {
        if (m_bars->hasFocus())
            m_barArea->ensureVisible(0, (top + bottom) / 2, 0, bottom - top);
    });
    m_chartPages->addWidget(m_lines);
    m_chartPages->addWidget(m_barArea);
    auto* charts = new QWidget;
    auto* column = new QVBoxLayout(charts);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_chartChoice);
    column->addWidget(m_chartPages, 1);
    return charts;
}

void EvaluationPanel::arrangeWidgets()
{
    m_pages = new QStackedWidget;
    m_results = new QStackedWidget;
    m_chooser = new EvaluationChooser(m_context);
    m_message = new widgets::MessageStrip;
    m_empty = new QLabel;
    m_compute = new QPushButton;
    m_splitter = new QSplitter;
    m_pages->setObjectName(QStringLiteral("evaluationPages"));
    m_message->setObjectName(QStringLiteral("evaluationMessage"));
    m_empty->setObjectName(QStringLiteral("evaluationEmpty"));
    m_compute->setObjectName(QStringLiteral("evaluationCompute"));
    m_splitter->setObjectName(QStringLiteral("evaluationSplitter"));
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    auto* empty = new QWidget;
    auto* centre = new QVBoxLayout(empty);
    centre->setContentsMargins(24, 8, 24, 8);
    centre->addStretch(1);
    centre->addWidget(m_empty);
    centre->addWidget(m_compute, 0, Qt::AlignHCenter);
    centre->addStretch(1);
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeHead());
    column->addWidget(m_message);
    m_splitter->addWidget(makeTables());
    m_splitter->addWidget(makeCharts());
    m_splitter->setStretchFactor(0, 3);
    m_splitter->setStretchFactor(1, 2);
    m_splitter->setChildrenCollapsible(false);
    m_results->addWidget(empty);
    m_results->addWidget(m_splitter);
    column->addWidget(m_results, 1);
    m_pages->addWidget(m_chooser);
    m_pages->addWidget(page);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(m_pages);
}

void EvaluationPanel::updateActions()
{
    const auto* shown = resultState();
    const bool isComputing = shown != nullptr && shown->phase == ResultPhase::Computing;
    const bool hasTables = shown != nullptr && !shown->tables.empty();
    const auto enable = [this](const char* id, bool on) {
        m_context.actions.action(QLatin1String(id))->setEnabled(on);
    };
    enable("evaluations.show", shown != nullptr);
    enable("evaluations.compute", shown != nullptr && !isComputing &&
                                      shown->phase != ResultPhase::Impossible &&
                                      shown->phase != ResultPhase::Ready);
    enable("evaluations.stop", isComputing);
    enable("evaluations.copy", hasTables);
    enable("evaluations.save", hasTables);
}

void EvaluationPanel::copy() const
{
    QGuiApplication::clipboard()->setText(m_model->csv());
}

void EvaluationPanel::askAndSave()
{
    const QString file = QFileDialog::getSaveFileName(this, tr("Save the table"),
                                                      m_tabs->tabData(m_tabs->currentIndex()).toString() +
                                                          QStringLiteral(".csv"),
                                                      tr("Comma-separated values (*.csv)"));
    if (!file.isEmpty())
        save(file);
}

void EvaluationPanel::save(const QString& file)
{
    try {
        // Whether a file may be replaced was asked where its name was chosen.
        const ProjectDocument& document = m_context.document;
        const auto guard =
            projectGuard(document.snapshot(), document.workingFile(), {.overwrite = true, .outside = true});
        const WrittenNote note(*guard, document.workingFile());
        writeGuarded(toPath(file), m_model->csv().toStdString(), guard.get());
        refresh();
    } catch (const Error& error) {
        const ErrorText text = describe(error);
        m_message->show(widgets::MessageStrip::Kind::Error, text.placed(), text.remedy);
    }
}

} // namespace quadrille
