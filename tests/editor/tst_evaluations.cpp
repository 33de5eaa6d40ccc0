// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Evaluations: added, computed, looked at, saved, taken back.
#include "editor/commands/projectedits.h"
#include "editor/docks/projecttreemodel.h"
#include "editor/documents/evaluationtexts.h"
#include "editor/evaluations/evaluationcharts.h"
#include "editor/evaluations/evaluationpanel.h"
#include "graphfixture.h"
#include "model/project/store/tablebuilder.h"
#include "tests/qt/patience.h"
#include "widgets/graph/barchart.h"
#include "widgets/graph/linechart.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>
#include <QTreeView>

namespace quadrille {

class EvaluationsTest : public GraphFixture
{
    Q_OBJECT

private:
    EvaluationPanel& panel() { return *test::find<EvaluationPanel>("evaluationPanel"); }
    QListWidget& choices() { return *test::find<QListWidget>("evaluationChoices"); }
    QAbstractItemModel& table() { return *test::find<QTableView>("evaluationTable")->model(); }
    ResultPhase phaseOf(const char* name)
    {
        const auto* resultState = context().evaluations.resultState(name);
        return resultState != nullptr ? resultState->phase : ResultPhase::Idle;
    }
    QModelIndex treeIndex(const QString& name)
    {
        auto* tree = test::find<QTreeView>("projectTree");
        return static_cast<ProjectTreeModel*>(tree->model())->indexOf({Section::Evaluations, name});
    }
    int choiceOf(const QString& title)
    {
        const auto found = choices().findItems(title, Qt::MatchExactly);
        return found.isEmpty() ? -1 : choices().row(found.front());
    }
    void addByKeyboard(const QString& title)
    {
        context().actions.action("evaluations.add")->trigger();
        QTRY_VERIFY(choices().hasFocus());
        for (int i = 0; i < choices().count() && choices().currentRow() != choiceOf(title); ++i)
            QTest::keyClick(&choices(), Qt::Key_Down);
        QCOMPARE(choices().currentRow(), choiceOf(title));
        QTest::keyClick(&choices(), Qt::Key_Return);
    }
    void compute(const char* name)
    {
        context().selection.select({Section::Evaluations, QLatin1String(name)});
        QTRY_COMPARE(phaseOf(name), ResultPhase::Stale);
        context().actions.action("evaluations.compute")->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(phaseOf(name), ResultPhase::Ready, test::patience);
    }
    void add(const char* name)
    {
        EvaluationEntry entry;
        entry.table = name;
        QCOMPARE(addEvaluation(context().document, entry), QLatin1String(name));
    }

    static std::vector<EvaluationChart> chartsOfTable(const std::string& name, TableBuilder table)
    {
        DataItem item;
        item.name = "evaluation/" + name;
        item.content = std::move(table).table();
        return chartsOf(name, {item}, UpAxis::Y);
    }

private slots:
    void oneIsAddedComputedSeenSavedAndTakenBack()
    {
        const Project before = context().document.project();
        addByKeyboard("Essential graph and motion graph");
        QCOMPARE(context().document.project().evaluations.size(), 1U);
        QCOMPARE(context().selection.current().name, QStringLiteral("fig9"));
        QCOMPARE(treeIndex("fig9").data().toString(), QStringLiteral("Essential graph and motion graph"));
        auto* button = test::find<QPushButton>("evaluationCompute");
        QTRY_VERIFY(button->hasFocus());
        QTRY_COMPARE(phaseOf("fig9"), ResultPhase::Stale);
        QCOMPARE(treeIndex("fig9").data(ProjectTreeModel::StateRole).toInt(),
                 static_cast<int>(EntryState::Stale));
        QTest::keyClick(button, Qt::Key_Return);
        QCOMPARE(phaseOf("fig9"), ResultPhase::Computing);
        QVERIFY(test::find<QProgressBar>("evaluationProgress")->isVisible());
        QTRY_COMPARE_WITH_TIMEOUT(phaseOf("fig9"), ResultPhase::Ready, test::patience);
        QCOMPARE(treeIndex("fig9").data(ProjectTreeModel::StateRole).toInt(),
                 static_cast<int>(EntryState::Fresh));

        // Three tables: the results, those of as many edges, and components; a line for each graph.
        auto* tabs = test::find<QTabBar>("evaluationTabs");
        QCOMPARE(tabs->count(), 3);
        QCOMPARE(tabs->tabText(1), QStringLiteral("As many edges in both"));
        QCOMPARE(table().rowCount(), 12);
        QCOMPARE(table().headerData(1, Qt::Horizontal).toString(), QStringLiteral("α"));
        auto* lines = test::find<widgets::LineChart>("evaluationLines");
        QVERIFY(lines->isVisible());
        QCOMPARE(lines->series().size(), 2U);
        QCOMPARE(lines->series()[1].name, QStringLiteral("Essential graph"));
        QCOMPARE(lines->series()[0].points.size(), 6U);

        // The table as it is in the store, as the command line writes it.
        const QString file = m_folder->filePath("fig9.csv");
        QTimer::singleShot(0, this, [&] {
            QFileDialog* chooser = nullptr;
            QTRY_VERIFY((chooser = panel().findChild<QFileDialog*>()) != nullptr && chooser->isVisible());
            chooser->selectFile(file);
            static_cast<QDialog*>(chooser)->accept();
        });
        context().actions.action("evaluations.save")->trigger();
        QTRY_VERIFY(QFile::exists(file));
        QFile saved(file);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QCOMPARE(saved.readLine().trimmed(),
                 QByteArray("graph,alpha,nodes,edges,transitions,density,mean-cost,cost-deviation,"
                            "unreachable-pairs,components"));
        QCOMPARE(saved.readAll().count('\n'), 12);
        context().actions.action("evaluations.copy")->trigger();
        QVERIFY(QGuiApplication::clipboard()->text().startsWith("graph,alpha,"));

        context().document.undo();
        QCOMPARE(context().document.project(), before);
        QVERIFY(!treeIndex("fig9").isValid());
        QVERIFY(choices().isVisible());
        context().document.redo();
        QCOMPARE(context().document.project().evaluations.size(), 1U);
        context().selection.select({Section::Evaluations, "fig9"});
        QTRY_COMPARE(phaseOf("fig9"), ResultPhase::Ready); // the results were kept
    }

    void aProjectThatIsOpenedAgainShowsItsResults()
    {
        add("fig7");
        compute("fig7");
        context().document.saveAs(m_folder->filePath("again.quadrille").toStdString());
        add("fig4");
        compute("fig4");                                   // now beside the file
        QTRY_COMPARE(phaseOf("fig7"), ResultPhase::Ready); // which was kept in memory, and stored there
        context().document.save();
        context().document.load(m_folder->filePath("again.quadrille").toStdString());
        QTRY_COMPARE(phaseOf("fig7"), ResultPhase::Ready);
        QCOMPARE(phaseOf("fig4"), ResultPhase::Ready);
        context().selection.select({Section::Evaluations, "fig7"});
        QTRY_COMPARE(table().rowCount(), 9);
        // What it depends on is another now.
        context().document.undoStack()->clear();
        setSequenceRange(context().document, "first", FrameRange{FrameIndex(0), FrameIndex(40)});
        QTRY_COMPARE(phaseOf("fig7"), ResultPhase::Stale);
        QCOMPARE(table().rowCount(), 9); // the results before, with a word
        QVERIFY(test::find<QWidget>("evaluationMessage")->isVisible());
        context().document.undo();
        QTRY_COMPARE(phaseOf("fig7"), ResultPhase::Ready);
    }

    void columnsSortByTheirNumbers()
    {
        add("density");
        compute("density");
        auto* view = test::find<QTableView>("evaluationTable");
        QAbstractItemModelTester tester(view->model());
        int column = 0;
        while (view->model()->headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString() !=
               "essential-density")
            ++column;
        const auto values = [&] {
            std::vector<double> shown;
            for (int row = 0; row < view->model()->rowCount(); ++row)
                shown.push_back(view->model()->index(row, column).data(Qt::UserRole).toDouble());
            return shown;
        };
        QCOMPARE(values().size(), 15U);
        QVERIFY(!std::ranges::is_sorted(values()));
        view->horizontalHeader()->setSortIndicator(column, Qt::AscendingOrder);
        QVERIFY(std::ranges::is_sorted(values()));
        view->horizontalHeader()->setSortIndicator(column, Qt::DescendingOrder);
        QVERIFY(std::ranges::is_sorted(values(), std::greater()));
        // Bars for both graphs, called by what was varied.
        auto* bars = test::find<widgets::BarChart>("evaluationBars");
        QVERIFY(bars->isVisible());
        QCOMPARE(bars->series().size(), 2U);
        QCOMPARE(bars->categories()[0], QStringLiteral("as set"));
        QVERIFY(bars->categories().contains("longest window 0.6"));
        QVERIFY(bars->csv().contains("\"as set\","));
        bars->setFocus();
        QTest::keyClick(bars, Qt::Key_Down);
        QVERIFY(bars->readOut().startsWith("as set; "));
        QCOMPARE(bars->accessibleDescription(), bars->readOut());
    }

    void columnsAreCalledInWords()
    {
        EvaluationEntry entry;
        entry.table = "junctions";
        entry.count = 3;
        addEvaluation(context().document, entry);
        compute("junctions");
        auto* tabs = test::find<QTabBar>("evaluationTabs");
        QCOMPARE(tabs->count(), 3);
        for (int tab = 0; tab < tabs->count(); ++tab) {
            tabs->setCurrentIndex(tab);
            for (int column = 0; column < table().columnCount(); ++column) {
                const QString title = table().headerData(column, Qt::Horizontal).toString();
                QVERIFY2(!title.contains('-'), qPrintable(title));
            }
        }
        // High enough for some rows of the table.
        QVERIFY(test::find<QTableView>("evaluationTable")->viewport()->height() >
                4 * test::find<QTableView>("evaluationTable")->rowHeight(0));
    }

    void severalColumnsAreLinesOfOneChart()
    {
        TableBuilder table("fig17", {});
        table.whole("components").real("texture_ssim").real("texture_ssim_naive");
        table.real("image_ssim").real("image_ssim_naive");
        table.add({std::int64_t{1}, 0.5, 0.4, 0.7, 0.6});
        table.add({std::int64_t{9}, 0.8, 1.0, 0.9, 1.0});
        const std::vector<EvaluationChart> charts = chartsOfTable("fig17", std::move(table));
        QCOMPARE(charts.size(), 1U);
        const auto& lines = std::get<EvaluationChart::Lines>(charts[0].content);
        QCOMPARE(lines.series.size(), 4U);
        QCOMPARE(lines.series[1].name, QStringLiteral("SSIM of textures, naive"));
        QCOMPARE(lines.series[1].points, (std::vector<QPointF>{{1, 0.4}, {9, 1.0}}));
        QCOMPARE(lines.series[2].points.back(), QPointF(9, 0.9));
    }

    /// As the step of IA4D's table makes it.
    void transitionsOfSpacesAreBarsWithTheirWords()
    {
        TableBuilder table("ia4d-table2", {});
        table.text("source").text("target").text("kind").real("cost").real("dissimilarity");
        table.real("mean-latency", "s").real("median-latency", "s").real("latency-95", "s");
        table.real("worst-latency", "s").whole("missed");
        table.add({"walking", "jumping", "online", 3.0, 163.0, 0.4, 0.3, 0.8, 1.1, std::int64_t{0}});
        table.add(
            {"walking", "jumping", "10 computed before", 9.0, 31.0, 1.1, 1.0, 1.7, 2.0, std::int64_t{4}});
        const std::vector<EvaluationChart> charts = chartsOfTable("ia4d-table2", std::move(table));
        QCOMPARE(charts.size(), 2U);
        const auto& latency = std::get<EvaluationChart::Bars>(charts[0].content);
        QCOMPARE(latency.categories, (QStringList{"walking · jumping · found while playing",
                                                  "walking · jumping · 10 computed before"}));
        QCOMPARE(latency.series.size(), 3U);
        QCOMPARE(latency.series[2].name, QStringLiteral("latency, 95th percentile"));
    }

    void computingIsStopped()
    {
        add("junctions");
        context().selection.select({Section::Evaluations, "junctions"});
        QTRY_COMPARE(phaseOf("junctions"), ResultPhase::Stale);
        context().actions.action("evaluations.compute")->trigger();
        QCOMPARE(phaseOf("junctions"), ResultPhase::Computing);
        QVERIFY(!context().actions.action("evaluations.compute")->isEnabled());
        context().actions.action("evaluations.stop")->trigger();
        QTRY_COMPARE(phaseOf("junctions"), ResultPhase::Stale);
        QVERIFY(context().actions.action("evaluations.compute")->isEnabled());
    }

    void whatCannotBeEvaluatedSaysWhy()
    {
        context().actions.action("evaluations.add")->trigger();
        const auto* angles = choices().item(choiceOf("Pose distances and joint angles"));
        QVERIFY(!angles->flags().testFlag(Qt::ItemIsEnabled));
        QVERIFY(angles->data(Qt::AccessibleDescriptionRole).toString().contains("joint angles (a BVH file"));
        const auto* variations = choices().item(choiceOf("What shows of variations"));
        QVERIFY(!variations->flags().testFlag(Qt::ItemIsEnabled));
        const auto* compactness = choices().item(choiceOf("Compactness, SSIM"));
        QVERIFY(!compactness->flags().testFlag(Qt::ItemIsEnabled));
        QVERIFY(compactness->data(Qt::AccessibleDescriptionRole).toString().contains("model of appearance"));
        add("fig7");
        QVERIFY(!choices().item(choiceOf("Kinds of transitions"))->flags().testFlag(Qt::ItemIsEnabled));
        // One of variations, written by hand, is there and says that there are none.
        add("variations");
        context().selection.select({Section::Evaluations, "variations"});
        QTRY_COMPARE(phaseOf("variations"), ResultPhase::Impossible);
        QVERIFY(test::find<QLabel>("evaluationEmpty")->text().contains("nothing in the project"));
        QVERIFY(!context().actions.action("evaluations.compute")->isEnabled());
    }

    void severalAreRemovedAtOnce()
    {
        add("fig7");
        add("fig9");
        const Project before = context().document.project();
        removeEntries(context().document, Section::Evaluations, {"fig7", "fig9"});
        QVERIFY(context().document.project().evaluations.empty());
        context().document.undo();
        QCOMPARE(context().document.project(), before);
        QVERIFY(treeIndex("fig9").isValid());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::EvaluationsTest);
#include "tst_evaluations.moc"
