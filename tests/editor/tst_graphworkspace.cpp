// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Stories of the Graph workspace, with three small takes and real keys and clicks.
#include "editor/playback/player.h"
#include "editor/workspaces/graph/alternativeslist.h"
#include "editor/workspaces/graph/gapspanel.h"
#include "editor/workspaces/graph/graphbar.h"
#include "editor/workspaces/graph/pairpreview.h"
#include "editor/workspaces/graph/transitionpanel.h"
#include "graphfixture.h"
#include "model/graph/shortestpath.h"
#include "tests/qt/registry.h"
#include "widgets/graph/arcview.h"
#include "widgets/graph/chartscale.h"
#include "widgets/graph/linechart.h"
#include "widgets/graph/logslider.h"
#include "widgets/graph/matrixview.h"
#include "widgets/graph/takegraphview.h"

#include <QContextMenuEvent>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QTabWidget>
#include <QTreeWidget>

namespace quadrille {

class GraphWorkspaceTest : public GraphFixture
{
    Q_OBJECT

private:
    static QPoint handleOf(QSlider* slider)
    {
        QStyleOptionSlider option;
        option.initFrom(slider);
        option.minimum = slider->minimum();
        option.maximum = slider->maximum();
        option.sliderPosition = option.sliderValue = slider->value();
        option.orientation = Qt::Horizontal;
        return slider->style()
            ->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider)
            .center();
    }
    void drag(QSlider* slider, int pixels)
    {
        const QPoint from = handleOf(slider);
        QTest::mousePress(slider, Qt::LeftButton, {}, from);
        for (int step = 1; step <= 8; ++step)
            QTest::mouseMove(slider, from + QPoint(pixels * step / 8, 0));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, from + QPoint(pixels, 0));
    }

private slots:
    void anEmptyProjectOffersToImport()
    {
        context().document.reset(Project());
        m_window->workspaces().select("graph");
        QCOMPARE(text("graphStateTitle"), QString("No sequences yet"));
        QVERIFY(!context().actions.action("graph.compute")->isEnabled());
    }

    void computingCanBeStopped()
    {
        auto* button = test::find<QPushButton>("graphStateButton");
        QTRY_VERIFY(context().graphs.resultState("spire")->phase == ResultPhase::Idle);
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(text("graphStateTitle"), QString("Computing the graph"));
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_COMPARE(text("graphStateTitle"), QString("No graph yet"));
        QVERIFY(explorer().character() == nullptr);
        compute();
    }

    void draggingAlphaChangesWhatTheGraphsAmountTo()
    {
        compute();
        const QString before = text("essentialDensity");
        const double alphaBefore = projectAlpha();
        // Costs are shown beside the edges that they belong to only.
        int shown = 0;
        int wrong = 0;
        const auto watching = connect(&explorer(), &GraphExplorer::graphsChanged, this, [&] {
            const auto& measured = explorer().measured();
            const bool isKnown = measured != nullptr && measured->graphs == explorer().graphs();
            ++shown;
            wrong += (text("essentialCost") == "…") == isKnown || (text("motionCost") == "…") == isKnown;
        });
        drag(workspace().bar().alpha().slider(), 70);
        const double alpha = projectAlpha();
        QVERIFY(alpha > 2 * alphaBefore && explorer().alpha() == alpha);
        waitForPaths();
        disconnect(watching);
        QVERIFY(shown > 0);
        QCOMPARE(wrong, 0);
        const EssentialGraph essential = essentialGraph(graph().costs(), alpha);
        const auto minima = costMinima(graph().costs());
        const Digraph motion = motionGraph(graph().costs(), minima, alpha);
        const auto percent = [](const Digraph& of) {
            return widgets::chartNumber(100 * of.density()) + " %";
        };
        QVERIFY(text("essentialDensity") != before);
        QCOMPARE(text("essentialDensity"), percent(essential.graph));
        QCOMPARE(text("motionDensity"), percent(motion));
        QCOMPARE(text("essentialEdges"),
                 QLocale().toString(static_cast<qulonglong>(essential.graph.edges().size())));
        QCOMPARE(text("essentialCost"), widgets::chartNumber(summarizePathCosts(essential.pathCosts).mean));
        QCOMPARE(text("motionCost"),
                 widgets::chartNumber(summarizePathCosts(shortestPathCosts(motion)).mean));
        // The whole drag is one step.
        context().document.undoStack()->undo();
        QCOMPARE(projectAlpha(), alphaBefore);
        waitForPaths();
        QCOMPARE(text("essentialDensity"), before);
    }

    void ofManyFramesTheEdgesThatAreCertainComeFirst()
    {
        compute();
        explorer().setManyFrames(1);
        int parts = 0;
        int wrong = 0;
        const auto watching = connect(&explorer(), &GraphExplorer::graphsChanged, this, [&] {
            const bool isPart = !explorer().graphs()->isWhole;
            parts += isPart ? 1 : 0;
            for (const char* name : {"essentialEdges", "essentialDensity"})
                wrong += text(name).startsWith(QStringLiteral("≥ ")) == isPart ? 0 : 1;
            wrong += text("motionEdges").startsWith(QStringLiteral("≥ ")) ? 1 : 0;
        });
        drag(workspace().bar().alpha().slider(), 70);
        waitForPaths();
        disconnect(watching);
        QVERIFY(parts > 0);
        QCOMPARE(wrong, 0);
        QCOMPARE(text("essentialEdges"),
                 QLocale().toString(static_cast<qulonglong>(
                     essentialGraph(graph().costs(), projectAlpha()).graph.edges().size())));
    }

    /// How many values arrive while the slider moves is printed, not asserted: it depends on the machine.
    void theGraphsFollowAMovingAlpha()
    {
        compute();
        QSignalSpy graphs(&explorer(), &GraphExplorer::graphsChanged);
        QSignalSpy paths(&explorer(), &GraphExplorer::pathsChanged);
        QSlider* slider = workspace().bar().alpha().slider();
        const QPoint from = handleOf(slider);
        QTest::mousePress(slider, Qt::LeftButton, {}, from);
        QElapsedTimer clock;
        clock.start();
        int moves = 0;
        while (clock.elapsed() < 400) {
            QTest::mouseMove(slider, from + QPoint(++moves % 80, 0));
            QTest::qWait(1);
        }
        const auto edgesSeen = graphs.size();
        const auto pathsSeen = paths.size();
        qInfo("%d moves: edges %.0f times a second, mean costs %.0f times a second", moves,
              1000.0 * static_cast<double>(edgesSeen) / 400, 1000.0 * static_cast<double>(pathsSeen) / 400);
        QTest::mouseRelease(slider, Qt::LeftButton, {}, from + QPoint(40, 0));
        waitForPaths();
        QVERIFY(edgesSeen > 1);
        QVERIFY(graphs.size() <= moves + 2);
    }

    void pointingAtACellShowsBothFramesAndItsNumbers()
    {
        compute();
        const FramePair pair = someTransition();
        const auto cell = matrix().cellAt(placeOf(pair));
        // The window system tells of the real pointer, too, which is elsewhere.
        QVERIFY(QTest::qWaitFor([&] {
            QTest::mouseMove(&matrix(), {1, 1});
            QTest::mouseMove(&matrix(), placeOf(pair));
            return matrix().hoveredCell() == cell;
        }));
        QTRY_VERIFY(text("graphReadOut").startsWith(matrix().cellText(*cell)));
        const QStringList both{PairPreview::sourceName(), PairPreview::destinationName()};
        QCOMPARE(workspace().scene().shown(), both);
        QTRY_VERIFY(workspace().scene().sequenceOf(both[1]) != nullptr);
        QCOMPARE(workspace().scene().sequenceOf(both[1])->frameCount(), 1);
    }

    void clickingACellPlaysItsTransitionAndSaysWhy()
    {
        compute();
        QSignalSpy activated(&workspace().map(), &GraphMap::activated);
        const auto cell = *matrix().cellAt(placeOf(someTransition()));
        const FramePair pair{cell.row, cell.column};
        QTest::mouseClick(&matrix(), Qt::LeftButton, {}, placeOf(pair));
        QCOMPARE(activated.size(), 1);
        QTRY_VERIFY(workspace().player().isPlaying());
        const QString clip = PairPreview::clipName();
        QCOMPARE(workspace().scene().shown(), QStringList{clip});
        const int length = graph().costs().length()(pair.source, pair.destination);
        const auto& tracks = workspace().view().timeline().tracks();
        QCOMPARE(tracks.size(), std::size_t{1});
        QCOMPARE(tracks[0].spans[1].hatched, true);
        QCOMPARE(tracks[0].spans[1].last - tracks[0].spans[1].first + 1, length - 2);
        const double deformation = graph().costs().weight(pair.source, pair.destination, 0);
        QVERIFY(text("transitionDeformation").startsWith(widgets::chartNumber(deformation)));
        const CostParts parts = graph().partsOf(pair);
        QVERIFY(std::abs(parts.sum() -
                         static_cast<double>(graph().costs().cost()(pair.source, pair.destination))) < 1e-5);
        QVERIFY(text("transitionPoses").startsWith(widgets::chartNumber(parts.pose)));
        QVERIFY(text("transitionFeet").startsWith(widgets::chartNumber(parts.contacts)));
        QVERIFY(text("transitionSpeeds").startsWith(widgets::chartNumber(parts.velocity)));
        QVERIFY(text("transitionDuration").startsWith(widgets::chartNumber(projectAlpha() * length)));
        QCOMPARE(text("transitionEssential") == "Yes",
                 explorer().graphs()->essential.find(pair.source, pair.destination) != nullptr);
        // Another one, chosen from the list.
        auto* list = test::find<QTreeWidget>("transitionAlternatives");
        QVERIFY(list->topLevelItemCount() > 2);
        const QRect row = list->visualItemRect(list->topLevelItem(1));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, {10, row.center().y()});
        QVERIFY(test::find<TransitionPanel>("transitionPanel")->shown() != pair);
        QTRY_VERIFY(workspace().player().isPlaying());
    }

    void theMenuOfTheOverviewListsTheBestBetweenTwoTakes()
    {
        compute();
        workspace().map().setMode(GraphMap::Mode::Takes);
        widgets::TakeGraphView* overview = &workspace().map().takes();
        QTRY_VERIFY(overview->isVisible() && !overview->links().empty());
        const auto link =
            *std::ranges::find_if(overview->links(), [](const auto& each) { return each.from != each.to; });
        const QPoint place = overview->linkMiddle(link).toPoint();
        QContextMenuEvent event(QContextMenuEvent::Mouse, place, overview->mapToGlobal(place));
        QApplication::sendEvent(overview, &event);
        auto* menu = workspace().findChild<QMenu*>("takesMenu");
        QVERIFY(menu != nullptr && menu->isVisible());
        menu->findChild<QAction*>("listBest")->trigger();
        menu->close();
        auto* list = test::find<AlternativesList>("transitionAlternatives");
        QVERIFY(list->ends() == std::pair(link.from, link.to));
        QVERIFY(list->listed().size() > 1);
        for (const FramePair& pair : list->listed()) {
            QCOMPARE(graph().layout().sequenceOf(pair.source), link.from);
            QCOMPARE(graph().layout().sequenceOf(pair.destination), link.to);
        }
        auto* panel = test::find<TransitionPanel>("transitionPanel");
        QVERIFY(panel->shown() == list->listed().front());
        // They stay listed while one of them is looked at.
        const QRect row = list->visualItemRect(list->topLevelItem(1));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, {10, row.center().y()});
        QVERIFY(panel->shown() == list->listed()[1]);
        QVERIFY(list->ends().has_value());
    }

    void everythingIsReachedByKeyboard()
    {
        compute();
        const FramePair pair = someTransition();
        matrix().setFocus();
        matrix().setCurrentCell(widgets::MatrixCell{pair.source, pair.destination - 1});
        QTest::keyClick(&matrix(), Qt::Key_Right);
        QCOMPARE(test::find<TransitionPanel>("transitionPanel")->shown(), pair);
        QTest::keyClick(&matrix(), Qt::Key_Return);
        QTRY_COMPARE(workspace().scene().shown(), QStringList{PairPreview::clipName()});
        const double before = projectAlpha();
        QTest::keyClick(m_window.get(), Qt::Key_BracketRight);
        QVERIFY(projectAlpha() > before);
    }

    void filtersGreyWhatTheyLeaveOut()
    {
        compute();
        const FramePair pair = someTransition();
        QTest::mouseMove(&matrix(), {1, 1});
        context().actions.action("graph.essentialEdges")->setChecked(false);
        const auto colorOf = [&] {
            const QImage picture = matrix().grab().toImage();
            return picture.pixelColor(
                (matrix().cellRect({pair.source, pair.destination}).center() * picture.devicePixelRatio())
                    .toPoint());
        };
        const QColor before = colorOf();
        QVERIFY(before.hsvSaturation() > 90);
        auto* longest = test::find<QSpinBox>("filterLongest");
        longest->setFocus();
        longest->selectAll();
        QTest::keyClicks(longest, "1");
        QTRY_VERIFY(colorOf().hsvSaturation() < 60);
        QTRY_COMPARE(text("filterKept"), QString("0.0 % in colour"));
        longest->setValue(0);
        QTRY_COMPARE(colorOf(), before);
    }

    void arcsShowTheSameTransitions()
    {
        compute();
        context().actions.action("graph.arcs")->trigger();
        auto& arcs = workspace().map().arcs();
        QVERIFY(arcs.isVisible());
        QVERIFY(!arcs.shown(widgets::ArcView::Side::Above).empty());
        const widgets::Arc arc = arcs.shown(widgets::ArcView::Side::Above).front().lightest;
        QVERIFY(explorer().graphs()->essential.find(arc.from, arc.to) != nullptr);
        const widgets::ArcCurve curve = arcs.curve(widgets::ArcView::Side::Above, arc);
        QSignalSpy activated(&workspace().map(), &GraphMap::activated);
        QTest::mouseClick(&arcs, Qt::LeftButton, {},
                          QPointF((curve.from + curve.to) / 2, curve.base - curve.height).toPoint());
        QCOMPARE(activated.size(), 1);
    }

    void chartsCompareBothGraphsOverAlpha()
    {
        compute();
        context().actions.action("graph.charts")->trigger();
        auto* chart = test::find<widgets::LineChart>("densityChart");
        QVERIFY(chart->isVisible());
        QTRY_VERIFY(!chart->isEmpty());
        QCOMPARE(chart->series().size(), std::size_t{2});
        for (const QPointF& point : chart->series()[0].points)
            QCOMPARE(point.y(), 100 * essentialGraph(graph().costs(), point.x()).graph.density());
        // The line at α can be dragged.
        const QPoint from = chart->positionOf({projectAlpha(), 0}).toPoint() - QPoint(0, 20);
        const QPoint to = chart->positionOf({0.1, 0}).toPoint() - QPoint(0, 20);
        QTest::mousePress(chart, Qt::LeftButton, {}, from);
        QTest::mouseMove(chart, (from + to) / 2);
        QTest::mouseMove(chart, to);
        QTest::mouseRelease(chart, Qt::LeftButton, {}, to);
        QVERIFY(std::abs(std::log(projectAlpha() / 0.1)) < 0.2);
    }

    void gapsAreNamedWithWhatWouldHelp()
    {
        compute();
        context().actions.action("graph.gaps")->trigger();
        auto* tree = test::find<QTreeWidget>("gapsTree");
        QTRY_COMPARE(tree->topLevelItemCount(), 2);
        // The first frames of a take cannot be arrived at, and nothing leaves its last ones.
        auto* essential = tree->topLevelItem(0);
        auto* usual = essential->child(essential->childCount() - 1);
        QCOMPARE(usual->text(0), QString("Starts and ends of takes: 6"));
        QVERIFY(usual->child(0)->text(0).startsWith("first 0–"));
        usual->setExpanded(true);
        QSignalSpy chosen(test::find<GapsPanel>("gapsPanel"), &GapsPanel::chosen);
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                          tree->visualItemRect(usual->child(0)).center());
        QCOMPARE(chosen.size(), 1);
    }

    void settingsAreUndoableAndComputeTheGraphAnew()
    {
        compute();
        context().actions.action("graph.settings")->trigger();
        const auto before = explorer().character();
        auto* slope = test::find<QDoubleSpinBox>("graphSlope");
        QVERIFY(slope->isVisible());
        slope->setFocus();
        QTest::keyClick(slope, Qt::Key_Down);
        QCOMPARE(graphEntry(context().document.project(), "spire").slope, 2);
        QTRY_VERIFY(explorer().character() != before);
        QCOMPARE(graph().work().graph.slope, 2);
        context().document.undoStack()->undo();
        QCOMPARE(slope->value(), 3.0);
    }

    /// A file may say more than a field lets one enter, and more exactly than it shows.
    void anEditOfOneWindowLeavesTheOtherAlone()
    {
        compute();
        context().actions.action("graph.settings")->trigger();
        GraphEntry entry = graphEntry(context().document.project(), "spire");
        entry.durations = {0.123456, 45};
        setGraph(context().document, "", "", entry);
        auto* longest = test::find<QDoubleSpinBox>("graphLongest");
        QCOMPARE(longest->value(), 45.0);
        auto* shortest = test::find<QDoubleSpinBox>("graphShortest");
        longest->setValue(30);
        QCOMPARE(graphEntry(context().document.project(), "spire").durations,
                 (std::optional<std::pair<double, double>>({0.123456, 30})));
        shortest->setValue(31);
        QCOMPARE(graphEntry(context().document.project(), "spire").durations,
                 (std::optional<std::pair<double, double>>({31, 31})));
        shortest->setValue(shortest->minimum());
        longest->setValue(longest->minimum());
        QVERIFY(!graphEntry(context().document.project(), "spire").durations);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::GraphWorkspaceTest);
#include "tst_graphworkspace.moc"
