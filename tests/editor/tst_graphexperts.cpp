// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What those do in the Graph workspace who know what they look for.
#include "editor/commands/animationedits.h"
#include "editor/playback/player.h"
#include "editor/workspaces/graph/alternativeslist.h"
#include "editor/workspaces/graph/framenames.h"
#include "editor/workspaces/graph/graphbar.h"
#include "editor/workspaces/graph/transitionpanel.h"
#include "graphfixture.h"
#include "tests/qt/languages.h"
#include "tests/qt/registry.h"
#include "widgets/graph/arcview.h"
#include "widgets/graph/linechart.h"
#include "widgets/graph/logslider.h"
#include "widgets/graph/takegraphview.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QFileDialog>
#include <QHeaderView>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

namespace quadrille {

class GraphExpertsTest : public GraphFixture
{
    Q_OBJECT

private slots:
    void theMapShowsFromAfarWhileTheGraphIsOpened()
    {
        compute();
        const int frames = graph().layout().frameCount();
        const QList<QString> takes = [this] {
            QList<QString> names;
            for (const widgets::MatrixBlock& block : matrix().blocks())
                names += block.name;
            return names;
        }();
        const Project project = context().document.project();
        int shown = 0;
        const auto watching = connect(&context().graphs, &GraphResults::changed, this, [&] {
            const auto* state = context().graphs.resultState("spire");
            if (state == nullptr || state->overview == nullptr)
                return;
            ++shown;
            QVERIFY(state->opened == nullptr && explorer().character() == nullptr);
            QVERIFY(workspace().map().isVisible() && !matrix().isEnabled());
            QCOMPARE(matrix().values().side, frames);
            QVERIFY(!matrix().values().values);
            QCOMPARE(matrix().blocks().size(), static_cast<std::size_t>(takes.size()));
            QCOMPARE(matrix().blocks().back().name, takes.back());
            QCOMPARE(text("graphReadOut"), QString("The graph is being opened…"));
        });
        QEventLoop loop;
        connect(&explorer(), &GraphExplorer::characterChanged, &loop, [&] {
            if (explorer().character() != nullptr)
                loop.quit();
        });
        context().document.reset(project);
        loop.exec();
        disconnect(watching);
        QVERIFY(shown > 0);
        QVERIFY(matrix().isEnabled());
        QTRY_VERIFY(matrix().values().values != nullptr);
        QCOMPARE(text("graphReadOut"), QString("Point at the map to read costs"));
        QVERIFY(context().graphs.resultState("spire")->overview == nullptr);
    }

    void selectedTakesFilterMatrixArcsAndLists()
    {
        compute();
        const FramePair pair = someTransition();
        context().selection.selectSequences({"second"});
        QCOMPARE(explorer().filter().takes, std::vector<int>{1});
        context().selection.selectSequences({"first"});
        QCOMPARE(explorer().filter().takes, std::vector<int>{0});
        auto* chip = test::find<QToolButton>("takeFilter");
        QCOMPARE(chip->isVisible(), true);
        QCOMPARE(chip->text(), QString("Only first"));
        const NodeIndex second = graph().layout().firstOf(1) + 5;
        QVERIFY(matrix().passesFilter({pair.source, pair.destination}));
        QVERIFY(matrix().passesFilter({second, 5}));
        QVERIFY(!matrix().passesFilter({second, second + 9}));
        context().actions.action("graph.arcs")->trigger();
        const auto& arcs = workspace().map().arcs();
        const auto touchesFirst = [&](const widgets::ArcBundle& bundle) {
            return bundle.lightest.from < 60 || bundle.lightest.to < 60;
        };
        const auto& shown = arcs.shown(widgets::ArcView::Side::Above);
        QVERIFY(!shown.empty());
        QVERIFY(std::ranges::all_of(shown, touchesFirst));
        context().actions.action("graph.matrix")->trigger();
        // Two takes: what leads from one to the other, and inside them.
        context().selection.selectSequences({"first", "second"});
        QVERIFY(!matrix().passesFilter({5, graph().layout().firstOf(2) + 5}));
        workspace().activate(pair);
        const auto& listed = test::find<AlternativesList>("transitionAlternatives")->listed();
        QVERIFY(!listed.empty());
        for (const FramePair& each : listed)
            QVERIFY(graph().layout().sequenceOf(each.destination) < 2);
        QTest::mouseClick(chip, Qt::LeftButton);
        QVERIFY(explorer().filter().isEmpty());
        QVERIFY(!chip->isVisible());
        QVERIFY(matrix().passesFilter({second, second + 9}));
    }

    void takesShowWithTheTransitionsCountedBetweenThem()
    {
        compute();
        context().actions.action("graph.takes")->trigger();
        auto& takes = workspace().map().takes();
        QVERIFY(takes.isVisible());
        int counted = 0;
        for (const widgets::TakeLink& link : takes.links())
            counted += link.count;
        QCOMPARE(counted, static_cast<int>(explorer().graphs()->essential.count(EdgeKind::Transition)));
        const auto link = std::ranges::find_if(
            takes.links(), [](const widgets::TakeLink& each) { return each.from == 0 && each.to == 2; });
        QVERIFY(link != takes.links().end());
        QTest::mouseClick(&takes, Qt::LeftButton, {}, takes.nodeRect(1).center().toPoint());
        QCOMPARE(explorer().filter().takes, std::vector<int>{1});
        QTest::mouseClick(&takes, Qt::LeftButton, {}, takes.linkMiddle(*link).toPoint());
        QCOMPARE(explorer().filter().takes, (std::vector<int>{0, 2}));
    }

    void speedsOfTransitionsAreMeasuredBesideTheInterface()
    {
        compute();
        const FramePair pair = someTransition();
        workspace().activate(pair);
        auto* list = test::find<AlternativesList>("transitionAlternatives");
        constexpr int slideColumn = 2;
        constexpr int jumpColumn = 3;
        QCOMPARE(list->topLevelItem(0)->text(jumpColumn), QString("…"));
        QTRY_VERIFY(text("transitionJump") != "…");
        for (int row = 0; row < list->topLevelItemCount(); ++row) {
            QTRY_VERIFY(list->topLevelItem(row)->text(jumpColumn) != "…");
            QVERIFY(list->topLevelItem(row)->text(slideColumn) != "…");
        }
        QVERIFY(list->topLevelItem(0)->text(0).contains("› "));
        QVERIFY(list->topLevelItem(0)->toolTip(0).contains(" › "));
        // What it costs is seen beside it.
        QTRY_VERIFY(list->header()->sectionViewportPosition(jumpColumn) < list->viewport()->width());
        QTRY_VERIFY(!list->topLevelItem(0)->icon(0).isNull());
        // Other blending, other speeds.
        context().actions.action("graph.gentle")->setChecked(true);
        QCOMPARE(text("transitionJump"), QString("…"));
        QTRY_VERIFY(text("transitionJump") != "…");
    }

    void theMenuOfACellBansItsTransition()
    {
        compute();
        const FramePair pair = someTransition();
        context().selection.select(
            {Section::Animations, addAnimation(context().document, {.name = "tour", .character = "spire"})});
        const auto openMenu = [&] {
            QContextMenuEvent event(QContextMenuEvent::Mouse, placeOf(pair),
                                    matrix().mapToGlobal(placeOf(pair)));
            QApplication::sendEvent(&matrix(), &event);
            return workspace().findChild<QMenu*>("graphCellMenu");
        };
        QMenu* menu = openMenu();
        QVERIFY(menu != nullptr && menu->isVisible());
        QCOMPARE(test::find<TransitionPanel>("transitionPanel")->shown(), pair);
        menu->findChild<QAction*>("banInAnimation")->trigger();
        menu->close();
        const JunctionEntry junction{graph().nameOf(pair.source), graph().nameOf(pair.destination)};
        QCOMPARE(context().document.animation("tour")->junctions.banned, std::vector{junction});
        context().document.undo();
        QVERIFY(context().document.animation("tour")->junctions.banned.empty());
        context().actions.action("graph.copyFrames")->trigger();
        QCOMPARE(QGuiApplication::clipboard()->text(), pairName(explorer(), pair));
    }

    void theDividerStaysWhereItIs_data()
    {
        QTest::addColumn<QList<int>>("wanted");
        QTest::newRow("where it begins") << QList<int>();
        QTest::newRow("where the map is as narrow as it can be") << QList<int>{1, 10'000};
        QTest::newRow("where the view is as narrow as it can be") << QList<int>{10'000, 1};
    }
    void theDividerStaysWhereItIs()
    {
        QFETCH(QList<int>, wanted);
        compute();
        m_window->resize(1280, 720);
        auto* splitter = test::find<QSplitter>("graphSplitter");
        QTRY_VERIFY(splitter->width() < 1280);
        if (!wanted.isEmpty())
            splitter->setSizes(wanted);
        const QList<int> sizes = splitter->sizes();
        const FramePair pair = someTransition();
        QTest::mouseMove(&matrix(), placeOf(pair));
        QTRY_VERIFY(!workspace().scene().shown().isEmpty());
        QTRY_VERIFY(!workspace().scene().isEmpty());
        QCOMPARE(splitter->sizes(), sizes);
        QTest::mouseClick(&matrix(), Qt::LeftButton, {}, placeOf(pair));
        QTRY_VERIFY(workspace().player().isPlaying());
        QCOMPARE(splitter->sizes(), sizes);
        context().selection.selectSequences({"first"});
        QCOMPARE(splitter->sizes(), sizes);
    }

    void linesOfGapsAreWholeOnASmallScreen_data() { test::addLanguages(); }
    void linesOfGapsAreWholeOnASmallScreen()
    {
        QFETCH(QString, language);
        compute();
        context().languages.setLanguage(language);
        m_window->resize(1280, 688);
        context().actions.action("graph.gaps")->trigger();
        auto* tree = test::find<QTreeWidget>("gapsTree");
        QTRY_VERIFY(tree->isVisible() && tree->topLevelItemCount() > 0);
        tree->expandAll();
        for (QTreeWidgetItemIterator item(tree); *item != nullptr; ++item) {
            const auto needed = [&] {
                return tree->fontMetrics()
                    .boundingRect(0, 0, tree->visualItemRect(*item).width(), 10'000, Qt::TextWordWrap,
                                  (*item)->text(0))
                    .height();
            };
            QTRY_VERIFY2(tree->visualItemRect(*item).height() >= needed(), qPrintable((*item)->text(0)));
        }
        context().languages.setLanguage("en");
    }

    void theSliderShowsHowDenseTheGraphBecomes()
    {
        compute();
        const auto& curve = workspace().bar().alpha().curve();
        QTRY_VERIFY(curve.size() == explorer().comparison().size() && curve.size() > 8);
        QCOMPARE(curve.front().x(), explorer().comparison().front().alpha);
        QVERIFY(curve.front().y() < curve.back().y());
        QCOMPARE(text("logSliderLow").isEmpty(), false);
    }

    void manyFramesAreComparedOnDemand()
    {
        explorer().setMostFramesCompared(1);
        compute();
        context().actions.action("graph.charts")->trigger();
        auto* button = test::find<QPushButton>("compareOverAlpha");
        QTRY_VERIFY(explorer().gaps() != nullptr && button->isVisible());
        QVERIFY(!explorer().isComparing() && explorer().comparison().empty());
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(explorer().isComparing() && !button->isVisible());
        // It goes on by itself where α moved.
        explorer().setAlpha(0.3);
        QTRY_VERIFY(explorer().comparison().size() > 8);
        QVERIFY(!button->isVisible());
        QVERIFY(!test::find<widgets::LineChart>("densityChart")->isEmpty());
    }

    void tablesAreSavedAsCsv()
    {
        compute();
        QDir(m_folder->path()).mkdir("tables");
        const QString folder = m_folder->filePath("tables");
        QTimer::singleShot(0, this, [&] {
            QFileDialog* chooser = nullptr;
            QTRY_VERIFY((chooser = workspace().findChild<QFileDialog*>()) != nullptr && chooser->isVisible());
            chooser->setDirectory(folder);
            chooser->selectFile(folder);
            QTest::keyClick(chooser, Qt::Key_Return);
            if (chooser->isVisible())
                static_cast<QDialog*>(chooser)->accept();
        });
        context().actions.action("graph.saveTables")->trigger();
        QTRY_VERIFY(QFile::exists(folder + "/graph-components.csv"));
        QFile edges(folder + "/essential-graph-edges.csv");
        QVERIFY(edges.open(QIODevice::ReadOnly));
        QCOMPARE(edges.readAll().count('\n'),
                 static_cast<qsizetype>(explorer().graphs()->essential.edges().size()) + 1);
        QFile statistics(folder + "/graph-statistics.csv");
        QVERIFY(statistics.open(QIODevice::ReadOnly));
        QVERIFY(statistics.readAll().contains("motion,0.01,180,"));
        edges.seek(0);
        QCOMPARE(edges.readLine().trimmed(),
                 QByteArray("i,j,weight,kind,cost,pose-cost,contact-cost,velocity-cost,length (frame),"
                            "from-sequence,from-frame (frame),to-sequence,to-frame (frame)"));
        const QList<QByteArray> first = edges.readLine().trimmed().split(',');
        const NamedFrame from = graph().nameOf(first.at(0).toInt());
        const NamedFrame to = graph().nameOf(first.at(1).toInt());
        QCOMPARE(
            first.mid(9),
            (QList<QByteArray>{QByteArray::fromStdString(from.sequence), QByteArray::number(from.frame.value),
                               QByteArray::fromStdString(to.sequence), QByteArray::number(to.frame.value)}));
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::GraphExpertsTest);
#include "tst_graphexperts.moc"
