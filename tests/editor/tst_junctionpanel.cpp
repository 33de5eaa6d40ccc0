// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Decisions about the transitions of a clip, by mouse and keys.
#include "animatedproject.h"
#include "editor/commands/animationedits.h"
#include "editor/commands/projectedits.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/animate/junctions.h"
#include "editor/workspaces/animate/transitionpreview.h"
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>

namespace quadrille {

class JunctionPanelTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    const AnimationEntry& entry() { return *context().document.animation("dance"); }
    const AnimationResult& result() { return *context().animations.result("dance"); }
    QTreeWidget& list(const char* name) { return *test::find<QTreeWidget>(name); }
    bool waitForResult() { return test::waitForResult(context(), "dance"); }
    bool isInClip(const JunctionEntry& wanted)
    {
        return std::ranges::any_of(junctionsOf(result()), [&](const ClipJunction& junction) {
            return junction.transition.names == wanted;
        });
    }
    JunctionEntry junction(std::size_t place) { return junctionsOf(result()).at(place).transition.names; }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(&m_window->animate().viewport(), key, modifiers);
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        test::writeSwayingTakes(m_folder.path());
    }

    void init()
    {
        m_window = test::openAnimated(m_folder.path());
        QVERIFY(m_window != nullptr);
        m_window->resize(1000, 700);
        test::find<QDockWidget>("junctionDock")->raise();
        QVERIFY(test::activate(*m_window));
        QVERIFY(waitForResult());
        QTRY_VERIFY(list("junctionList").topLevelItemCount() > 0);
        m_window->animate().viewport().setFocus();
    }

    void cleanup()
    {
        context().document.reset({});
        m_window.reset();
    }

    void listsTheTransitionsWithTheirCosts()
    {
        const auto junctions = junctionsOf(result());
        QCOMPARE(list("junctionList").topLevelItemCount(), static_cast<int>(junctions.size()));
        QVERIFY(result().walk.solution.walk.transitionCount() == junctions.size());
        double weights = 0;
        for (const ClipJunction& junction : junctions) {
            weights += junction.transition.weight();
            QVERIFY(junction.transition.deformation >= 0 && junction.transition.duration > 0);
            QVERIFY(junction.shown.has_value());
        }
        QVERIFY(weights <= result().walk.solution.cost.edges * (1 + 1e-6));
        key(Qt::Key_Period);
        const auto& first = junctions.front();
        QTRY_COMPARE(m_window->animate().player().frame().value, first.shown->first);
        QVERIFY(test::find<QLabel>("junctionDetails")->text().contains("deformation"));
        // It is measured as soon as it is selected.
        auto* quality = test::find<QLabel>("junctionQuality");
        QTRY_VERIFY(quality->isVisible());
        QVERIFY(quality->text().contains("slip") && quality->text().contains("%"));
    }

    void aClickGoesThereAndPlaysAround()
    {
        auto& player = m_window->animate().player();
        QTreeWidget& all = list("junctionList");
        QTest::mouseClick(all.viewport(), Qt::LeftButton, {},
                          all.visualItemRect(all.topLevelItem(0)).center());
        QVERIFY(player.isPlaying());
        const ClipFrames shown = *junctionsOf(result()).front().shown;
        QVERIFY(player.frame().value <= shown.first);
        QTRY_VERIFY(player.frame().value >= shown.last);
        // It does not play to the end of the clip, but again.
        QTRY_VERIFY(player.frame().value < shown.first);
        key(Qt::Key_Space);
        QVERIFY(!player.isPlaying());
    }

    void theSelectedTransitionStaysWhereATakeIsRenamed()
    {
        QTreeWidget& all = list("junctionList");
        const int last = all.topLevelItemCount() - 1;
        all.setCurrentItem(all.topLevelItem(last));
        const AnimationResult* before = &result();
        const QString take = QString::fromStdString(context().document.project().sequences.front().name);
        QVERIFY(renameEntry(context().document, {Section::Sequences, take}, "renamed"));
        QTRY_VERIFY(context().animations.result("dance") && &result() != before);
        QVERIFY(waitForResult());
        QTRY_COMPARE(all.topLevelItemCount(), last + 1);
        QCOMPARE(all.indexOfTopLevelItem(all.currentItem()), last);
    }

    void aBannedTransitionGivesWayToAnother()
    {
        const JunctionEntry banned = junction(0);
        key(Qt::Key_Period);
        key(Qt::Key_B, Qt::ShiftModifier);
        QCOMPARE(entry().junctions.banned, std::vector{banned});
        QVERIFY(waitForResult());
        QVERIFY(!isInClip(banned));
        QCOMPARE(list("decisionList").topLevelItemCount(), 1);
        context().document.undo();
        QVERIFY(entry().junctions.isEmpty());
        QVERIFY(waitForResult());
        QVERIFY(isInClip(banned));
        context().document.redo();
        QVERIFY(waitForResult());
        QVERIFY(!isInClip(banned));
        // What was decided can be taken back from the list of decisions.
        QTreeWidget& decisions = list("decisionList");
        QTest::mouseClick(decisions.viewport(), Qt::LeftButton, {},
                          decisions.visualItemRect(decisions.topLevelItem(0)).center());
        QTest::mouseClick(test::find<QToolButton>("tool.junction.forget"), Qt::LeftButton);
        QVERIFY(entry().junctions.isEmpty());
        QVERIFY(!decisions.isVisible());
    }

    void neighboursAreBannedInOneStep()
    {
        const FramePair banned = junctionsOf(result()).front().transition.frames;
        key(Qt::Key_Period);
        key(Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
        const auto all = entry().junctions.banned;
        QVERIFY(all.size() > 1);
        QVERIFY(waitForResult());
        for (const ClipJunction& now : junctionsOf(result())) {
            const FramePair& frames = now.transition.frames;
            QVERIFY(std::abs(frames.source - banned.source) > 2 ||
                    std::abs(frames.destination - banned.destination) > 2);
        }
        context().document.undo();
        QVERIFY(entry().junctions.isEmpty());
    }

    void anotherIsSeenAndTaken()
    {
        GraphEntry graph = GraphEntry::paper(); // its windows leave room for other junctions in short takes
        graph.character = "spire";
        const auto usual = context().animations.result("dance");
        setGraph(context().document, "Windows", "durations", graph);
        QTRY_VERIFY(context().animations.result("dance") != usual);
        QVERIFY(waitForResult());
        const JunctionEntry before = junction(0);
        key(Qt::Key_Period);
        key(Qt::Key_E, Qt::ShiftModifier);
        QTreeWidget& others = list("alternativeList");
        QTRY_VERIFY(others.isVisible() && others.topLevelItemCount() > 1);
        const auto offered = alternativesTo(result(), 0, entry().junctions);
        QVERIFY(std::ranges::is_sorted(offered, {}, &PricedJunction::weight));
        // The one under the keyboard plays in the view.
        auto& scene = m_window->animate().scene();
        QTest::keyClick(&others, Qt::Key_Down);
        QTRY_COMPARE(scene.shown(), QStringList{TransitionPreview::name()});
        QTRY_VERIFY(scene.frameCount() > 0 && m_window->animate().player().isPlaying());
        const int place = others.indexOfTopLevelItem(others.currentItem());
        QVERIFY(place >= 0);
        const JunctionEntry chosen = offered[static_cast<std::size_t>(place)].names;
        QTest::keyClick(&others, Qt::Key_Return);
        QCOMPARE(entry().junctions.chosen, std::vector{chosen});
        QTRY_COMPARE(scene.shown(), QStringList{"dance"});
        QVERIFY(waitForResult());
        QVERIFY(isInClip(chosen));
        QVERIFY(chosen != before);
        context().document.undo();
        QVERIFY(waitForResult());
        QVERIFY(isInClip(before) && !isInClip(chosen));
    }

    void lookingElsewhereEndsThePreview()
    {
        key(Qt::Key_Period);
        key(Qt::Key_E, Qt::ShiftModifier);
        auto& scene = m_window->animate().scene();
        QTest::keyClick(&list("alternativeList"), Qt::Key_Down);
        QTRY_COMPARE(scene.shown(), QStringList{TransitionPreview::name()});
        // It is shown where it would be in the clip.
        auto& animate = m_window->animate();
        QTRY_VERIFY(scene.frameCount() > 0);
        const ClipFrames shown = *junctionsOf(result()).front().shown;
        animate.player().pause();
        animate.player().goTo(0);
        const int begin = animate.view().timeline().currentFrame();
        QVERIFY2(begin <= shown.first && begin + scene.frameCount() > shown.first,
                 qPrintable(QString::number(begin)));
        QTest::keyClick(&list("alternativeList"), Qt::Key_Escape);
        QTRY_COMPARE(scene.shown(), QStringList{"dance"});
        QCOMPARE(animate.player().frame().value, shown.first);
        QCOMPARE(animate.view().timeline().currentFrame(), static_cast<int>(shown.first));
        key(Qt::Key_E, Qt::ShiftModifier);
        QTest::keyClick(&list("alternativeList"), Qt::Key_Down);
        QTRY_COMPARE(scene.shown(), QStringList{TransitionPreview::name()});
        test::find<QDockWidget>("reportDock")->raise();
        QTRY_COMPARE(scene.shown(), QStringList{"dance"});
        QVERIFY(!context().actions.action("junction.choose")->isChecked());
        QVERIFY(entry().junctions.isEmpty());
    }

    void whatIsLockedStays()
    {
        const JunctionEntry locked = junction(0);
        key(Qt::Key_Period);
        key(Qt::Key_L, Qt::ShiftModifier);
        QCOMPARE(entry().junctions.locked, std::vector{locked});
        QVERIFY(test::find<QToolButton>("tool.junction.lock")->isChecked());
        QVERIFY(waitForResult());
        QVERIFY(isInClip(locked));
        key(Qt::Key_L, Qt::ShiftModifier);
        QVERIFY(entry().junctions.isEmpty());
        QVERIFY(!test::find<QToolButton>("tool.junction.lock")->isChecked());
        // A segment is kept by its ends.
        m_window->animate().player().goTo(junctionsOf(result()).front().shown->last + 1);
        key(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(contains(entry().junctions.locked, locked));
        QVERIFY(entry().junctions.locked.size() <= 2);
    }

    void whatIsNotDecidedStaysUntilSomethingElseIsRequested()
    {
        const Walk walk = result().walk.solution.walk;
        auto* strip = test::find<widgets::MessageStrip>("junctionMessage");
        QVERIFY(!strip->isVisible());
        key(Qt::Key_Period);
        key(Qt::Key_L, Qt::ShiftModifier);
        QCOMPARE(entry().junctions.walk, walkSpansOf(result()));
        QVERIFY(waitForResult());
        // The lock seeks nothing.
        QCOMPARE(result().walk.solution.walk, walk);
        QCOMPARE(result().walk.solution.expansions, 0);
        QTRY_VERIFY(strip->isVisible());
        QTest::mouseClick(strip->findChild<QPushButton*>("messageStripAction"), Qt::LeftButton);
        QVERIFY(entry().junctions.walk.empty() && !entry().junctions.isEmpty());
        QVERIFY(waitForResult());
        QVERIFY(result().walk.solution.expansions > 0);
        QTRY_VERIFY(!strip->isVisible());
        context().document.undo();
        QVERIFY(!entry().junctions.walk.empty());
        // Something else is asked for: nothing is kept to any more.
        AnimationEntry other = entry();
        other.search.budget = 5000;
        setAnimation(context().document, "dance", "Budget", "budget", other);
        QVERIFY(entry().junctions.walk.empty() && !entry().junctions.isEmpty());
    }

    void anAcceptedWalkStaysAsItIs()
    {
        const Walk walk = result().walk.solution.walk;
        const auto frames = result().sequence.frameCount();
        const Vec3d centre = result().plan.frames.back().centre;
        context().actions.action("animate.acceptWalk")->trigger();
        QVERIFY(entry().walk.has_value());
        QVERIFY(waitForResult());
        QCOMPARE(result().walk.solution.walk, walk);
        QCOMPARE(result().sequence.frameCount(), frames);
        QVERIFY((result().plan.frames.back().centre - centre).norm() < 1e-6);
        auto* strip = test::find<widgets::MessageStrip>("junctionMessage");
        QTRY_VERIFY(strip->isVisible());
        QVERIFY(!context().actions.action("junction.ban")->isEnabled());
        QTest::mouseClick(strip->findChild<QPushButton*>("messageStripAction"), Qt::LeftButton);
        QVERIFY(!entry().walk.has_value());
        QTRY_VERIFY(!strip->isVisible());
        QVERIFY(context().document.undoStack()->undoText().contains("Seek"));
    }

    void findsTransitionsInALoop()
    {
        AnimationEntry looped = entry();
        looped.post.steps.loop.emplace();
        looped.post.steps.repeats = 2;
        setAnimation(context().document, "dance", "Loop", "loop", looped);
        QVERIFY(waitForResult());
        for (const ClipJunction& junction : junctionsOf(result())) {
            if (!junction.shown)
                continue;
            const FrameProvenance& first = result().origins[static_cast<std::size_t>(junction.shown->first)];
            QCOMPARE(first.source, junction.transition.frames.source);
        }
        QCOMPARE(list("junctionList").topLevelItemCount(), static_cast<int>(result().plan.junctions.size()));
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::JunctionPanelTest);
#include "tst_junctionpanel.moc"
