// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/evaluations/evaluationpanel.h"

#include "editor/context/editorcontext.h"
#include "editor/documents/evaluationtexts.h"
#include "editor/errors/errortext.h"
#include "editor/evaluations/evaluationchooser.h"
#include "editor/evaluations/evaluationtablemodel.h"
#include "editor/language/retranslate.h"
#include "model/project/store/dataitem.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabBar>
#include <QTableView>

namespace quadrille {

namespace {

/// "fig9-equal-density" of fig9: what is behind the name, or the results themselves.
QString tabTitle(const QString& table, const QString& evaluation)
{
    QString word = table == evaluation ? QStringLiteral("results") : table.mid(evaluation.size() + 1);
    return capitalized(evaluationWord(word));
}

} // namespace

EvaluationPanel::EvaluationPanel(EditorContext& context, QWidget* parent)
    : QWidget(parent), m_context(context)
{
    setObjectName(QStringLiteral("evaluationPanel"));
    makeActions();
    arrangeWidgets();
    connectParts();
    retranslates(this, [this] {
        m_table->setAccessibleName(tr("What was measured"));
        m_chartChoice->setAccessibleName(tr("What the chart shows"));
        m_tabs->setAccessibleName(tr("Tables"));
        m_compute->setText(tr("&Compute"));
        refresh();
    });
}

const EvaluationResults::State* EvaluationPanel::resultState() const
{
    return m_name.isEmpty() ? nullptr : m_context.evaluations.resultState(m_name);
}

void EvaluationPanel::connectParts()
{
    connect(&m_context.selection, &Selection::changed, this, &EvaluationPanel::followSelection);
    connect(&m_context.evaluations, &EvaluationResults::changed, this, [this](const QString& name) {
        if (name == m_name)
            refresh();
    });
    connect(&m_context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.touches(Section::Evaluations) && !m_name.isEmpty() &&
            m_context.document.evaluation(m_name) == nullptr)
            showChooser();
    });
    connect(m_chooser, &EvaluationChooser::added, this, [this](const QString& name) {
        m_context.selection.select({Section::Evaluations, name});
        m_compute->setFocus();
    });
    connect(m_message, &widgets::MessageStrip::actionTriggered, this, [this] {
        const auto* shown = resultState();
        const bool computes = shown != nullptr && shown->phase == ResultPhase::Computing;
        m_context.actions.action(computes ? "evaluations.stop" : "evaluations.compute")->trigger();
    });
    connect(m_compute, &QPushButton::clicked, this,
            [this] { m_context.actions.action("evaluations.compute")->trigger(); });
    connect(m_tabs, &QTabBar::currentChanged, this, &EvaluationPanel::showTable);
    connect(m_chartChoice, &QComboBox::currentIndexChanged, this, &EvaluationPanel::showChart);
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &EvaluationPanel::showCharts);
}

void EvaluationPanel::followSelection()
{
    const EntryRef& current = m_context.selection.current();
    if (current.section != Section::Evaluations)
        updateActions();
    else if (current.name.isEmpty())
        showChooser();
    else
        show(current.name);
}

void EvaluationPanel::show(const QString& name)
{
    if (m_name == name && m_pages->currentIndex() == 1)
        return;
    m_name = name;
    m_pages->setCurrentIndex(1);
    refresh();
}

void EvaluationPanel::showChooser()
{
    m_name.clear();
    m_pages->setCurrentIndex(0);
    updateActions();
}

void EvaluationPanel::refresh()
{
    const auto* shown = resultState();
    updateActions();
    if (shown == nullptr)
        return;
    m_title->setText(evaluationTitle(m_name));
    m_sentence->setText(evaluationSentence(m_name) + QLatin1Char('.'));
    showState(*shown);
    showTables();
}

void EvaluationPanel::showState(const EvaluationResults::State& shown)
{
    using Kind = widgets::MessageStrip::Kind;
    const bool isComputing = shown.phase == ResultPhase::Computing;
    const bool hasTables = !shown.tables.empty();
    m_results->setCurrentIndex(hasTables ? 1 : 0);
    m_progress->setVisible(isComputing);
    if (shown.job != m_job) {
        m_job = shown.job;
        if (m_job)
            connect(m_job, &Job::changed, this, &EvaluationPanel::showProgress);
    }
    showProgress();
    m_compute->setVisible(!isComputing && shown.phase != ResultPhase::Impossible);
    m_message->clear();
    m_message->setAction({});
    switch (shown.phase) {
    case ResultPhase::Idle:
    case ResultPhase::Waiting:
    case ResultPhase::Ready:
        m_empty->setText(shown.phase != ResultPhase::Ready ? tr("Looking for results…")
                                                           : tr("There was nothing to measure."));
        break;
    case ResultPhase::Impossible:
        m_empty->setText(tr("There is nothing in the project that this could be about: takes of a character "
                            "that it names, or variations that are learned."));
        break;
    case ResultPhase::Stale:
        m_empty->setText(
            tr("Not computed yet. It takes from seconds to minutes; you can go on working meanwhile."));
        if (hasTables) {
            m_message->show(Kind::Warning, tr("The project has changed since this was computed."));
            m_message->setAction(tr("Compute"));
        }
        break;
    case ResultPhase::Computing:
        m_empty->setText(tr("Computing, with all that it needs…"));
        m_message->show(Kind::Info, hasTables ? tr("Computed anew; these are the results before.")
                                              : tr("Being computed."));
        m_message->setAction(tr("Stop"));
        break;
    case ResultPhase::Failed:
        if (shown.error) {
            const ErrorText text = describe(*shown.error);
            m_message->show(Kind::Error, text.placed(), text.remedy);
            m_message->setAction(tr("Try again"));
        }
        m_empty->setText(tr("This could not be computed."));
        break;
    }
}

void EvaluationPanel::showProgress()
{
    if (m_job)
        m_progress->setValue(static_cast<int>(m_job->fraction() * m_progress->maximum()));
}

void EvaluationPanel::showTables()
{
    const QString evaluation = m_name.section(QLatin1Char('/'), 0, 0);
    QStringList names;
    for (const DataItem& item : resultState()->tables) {
        const QString name = QString::fromStdString(item.name).section(QLatin1Char('/'), 1);
        if (!names.contains(name))
            names += name;
    }
    {
        const QSignalBlocker quiet(m_tabs);
        while (m_tabs->count() > names.size())
            m_tabs->removeTab(m_tabs->count() - 1);
        for (int tab = 0; tab < names.size(); ++tab) {
            if (tab == m_tabs->count())
                m_tabs->addTab(QString());
            m_tabs->setTabText(tab, tabTitle(names[tab], evaluation));
            m_tabs->setTabToolTip(tab, QStringLiteral("evaluation/") + names[tab]);
            m_tabs->setTabData(tab, names[tab]);
        }
    }
    m_tabs->setVisible(names.size() > 1);
    showTable(m_tabs->currentIndex());
    showCharts();
}

void EvaluationPanel::showTable(int tab)
{
    const std::string name = "evaluation/" + m_tabs->tabData(tab).toString().toStdString();
    std::vector<DataItem> shown;
    if (const auto* evaluation = resultState())
        for (const DataItem& item : evaluation->tables)
            if (item.name == name)
                shown.push_back(item);
    m_model->show(std::move(shown));
    m_sorted->sort(-1);
    m_table->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    m_table->resizeColumnsToContents();
}

void EvaluationPanel::showCharts()
{
    const auto* evaluation = resultState();
    if (evaluation == nullptr)
        return;
    const QString before = m_chartChoice->currentText();
    m_charts = chartsOf(m_name.section(QLatin1Char('/'), 0, 0).toStdString(), evaluation->tables,
                        m_context.document.project().settings.axes.up);
    {
        const QSignalBlocker quiet(m_chartChoice);
        m_chartChoice->clear();
        for (const EvaluationChart& chart : m_charts)
            m_chartChoice->addItem(chart.title);
        m_chartChoice->setCurrentIndex(std::max(0, m_chartChoice->findText(before)));
    }
    m_chartChoice->setVisible(m_charts.size() > 1);
    m_splitter->widget(1)->setVisible(!m_charts.empty());
    showChart(m_chartChoice->currentIndex());
}

void EvaluationPanel::showChart(int index)
{
    if (index < 0 || index >= static_cast<int>(m_charts.size()))
        return;
    const auto& content = m_charts[static_cast<std::size_t>(index)].content;
    if (const auto* bars = std::get_if<EvaluationChart::Bars>(&content)) {
        m_bars->setBars(bars->axis, bars->categories, bars->series);
        m_chartPages->setCurrentIndex(1);
        return;
    }
    const auto& lines = std::get<EvaluationChart::Lines>(content);
    m_lines->setAxes(lines.x, lines.y);
    m_lines->setSeries(lines.series);
    m_chartPages->setCurrentIndex(0);
}

} // namespace quadrille

#include "moc_evaluationpanel.cpp"
