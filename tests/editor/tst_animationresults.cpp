// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Graphs and animations of an open project: computed when asked for, followed through edits, cancelled.
#include "animatedproject.h"
#include "editor/commands/animationedits.h"
#include "editor/commands/projectedits.h"
#include "editor/documents/projectpaths.h"
#include "editor/jobs/jobrunner.h"
#include "tests/qt/registry.h"

#include <QSignalSpy>
#include <memory>

namespace quadrille {

class AnimationResultsTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return *m_context; }
    const GraphResults::State& graph() { return *context().graphs.resultState("spire"); }
    const AnimationResults::State& dance() { return *context().animations.resultState("dance"); }
    bool waitForGraph()
    {
        return QTest::qWaitFor([&] { return graph().phase == ResultPhase::Ready; }, test::patience);
    }
    bool waitForDance() { return test::waitForResult(context(), "dance"); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<EditorContext> m_context;

private slots:
    void initTestCase() { test::isolate(); }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSwayingTakes(m_folder->path());
        m_context = std::make_unique<EditorContext>();
        context().document.reset(test::swayingProject(m_folder->path()));
    }

    void cleanup()
    {
        m_context.reset();
        m_folder.reset();
    }

    void aGraphIsComputedWhenAskedForAndNotBefore()
    {
        QTRY_VERIFY(graph().phase == ResultPhase::Idle);
        context().graphs.ask("spire");
        QVERIFY(graph().phase == ResultPhase::Computing);
        QVERIFY(waitForGraph());
        QCOMPARE(graph().opened->graph.layout().frameCount(), 180);
        QCOMPARE(graph().opened->graph.graph().nodeCount(), 180);
    }

    void aComputedGraphIsThereAgainWhenTheProjectIsOpened()
    {
        const auto file = toPath(m_folder->filePath("p.quadrille"));
        context().document.saveAs(file);
        context().graphs.ask("spire");
        QVERIFY(waitForGraph());
        m_context = std::make_unique<EditorContext>();
        context().document.load(file);
        QVERIFY(waitForGraph());
    }

    void aGraphFollowsItsSettingsAndUndo()
    {
        context().graphs.ask("spire");
        QVERIFY(waitForGraph());
        const auto edges = graph().opened->graph.graph().edges().size();
        GraphEntry entry = graphEntry(context().document.project(), "spire");
        entry.alpha = 0.3;
        setGraph(context().document, "alpha", "alpha", entry);
        QTRY_COMPARE(graph().opened->graph.alpha(), 0.3);
        QVERIFY(graph().phase == ResultPhase::Ready);
        QVERIFY(graph().opened->graph.graph().edges().size() > edges);
        context().document.undo();
        QTRY_COMPARE(graph().opened->graph.alpha(), GraphEntry().alpha);
    }

    void aCancelledGraphCanBeAskedForAgain()
    {
        QTRY_VERIFY(graph().phase == ResultPhase::Idle);
        context().graphs.ask("spire");
        context().jobs.cancelAll();
        QTRY_VERIFY(graph().phase == ResultPhase::Idle);
        context().graphs.ask("spire");
        QVERIFY(waitForGraph());
    }

    void aGraphThatCannotBeComputedSaysWhy()
    {
        const QString frame = m_folder->filePath("third/m_010.obj");
        QVERIFY(QFile::rename(frame, frame + ".kept"));
        std::ofstream(frame.toStdString()) << "v 0 0\n";
        context().graphs.ask("spire");
        QTRY_VERIFY(graph().phase == ResultPhase::Failed);
        QVERIFY(graph().error.has_value());
        QVERIFY(QFile::remove(frame));
        QVERIFY(QFile::rename(frame + ".kept", frame));
        context().graphs.ask("spire");
        QVERIFY(waitForGraph());
    }

    void anAnimationThatIsWantedIsSolvedWithItsGraph()
    {
        context().animations.want({"dance"});
        QVERIFY(dance().phase == ResultPhase::Waiting);
        QVERIFY(waitForDance());
        QVERIFY(dance().result->isFinal);
        const MeshSequence& clip = dance().result->sequence;
        QCOMPARE(clip.frameCount(), dance().result->plan.frameCount());
        QCOMPARE(clip.frameCount(), static_cast<std::int64_t>(dance().result->origins.size()));
        QCOMPARE(dance().result->walk.solution.actions.size(), 2U);
    }

    void anEditedAnimationIsSolvedAgainAndUndoBringsTheFirstBack()
    {
        context().animations.want({"dance"});
        QVERIFY(waitForDance());
        const auto walk = dance().result->walk.solution.walk;
        AnimationEntry entry = *context().document.animation("dance");
        entry.constraints = {PathEntry{.points = {{0, 0, 0}, {0.1, 0, 0.3}, {0, 0, 1}}}};
        // A search shows the best walk so far; what was found before needs none.
        int unfinished = 0;
        const QMetaObject::Connection look =
            connect(&context().animations, &AnimationResults::changed, this,
                    [&] { unfinished += dance().result != nullptr && !dance().result->isFinal ? 1 : 0; });
        setAnimation(context().document, "dance", "range", "range", entry);
        QVERIFY(waitForDance());
        QVERIFY(dance().result->walk.solution.walk != walk);
        QVERIFY(std::exchange(unfinished, 0) > 0);
        context().document.undo();
        QVERIFY(waitForDance());
        QVERIFY(dance().result->walk.solution.walk == walk);
        context().document.redo();
        QVERIFY(waitForDance());
        QVERIFY(dance().result->walk.solution.walk != walk);
        QCOMPARE(unfinished, 0);
        disconnect(look);
    }

    void postProcessingKeepsTheWalk()
    {
        context().animations.want({"dance"});
        QVERIFY(waitForDance());
        const auto solution = dance().result->walk.solution;
        const auto frames = dance().result->sequence.frameCount();
        AnimationEntry entry = *context().document.animation("dance");
        entry.post.steps.retime = RetimeSettings{.time = RetimeFactor{2}};
        setAnimation(context().document, "dance", "retime", "retime", entry);
        QVERIFY(waitForDance());
        QVERIFY(dance().result->walk.solution == solution);
        QCOMPARE(dance().result->sequence.frameCount(), 2 * frames - 1);
    }

    void whatCannotBeMetIsSaidAndTheLastResultStays()
    {
        context().animations.want({"dance"});
        QVERIFY(waitForDance());
        AnimationEntry entry = *context().document.animation("dance");
        entry.constraints.push_back(
            ActionEntry{.frames = {.label = "somersault", .sequence = {}, .range = {}}});
        setAnimation(context().document, "dance", "action", "action", entry);
        QTRY_VERIFY(dance().phase == ResultPhase::Failed);
        QVERIFY(dance().error.has_value());
        QVERIFY(dance().result != nullptr);
        context().document.undo();
        QVERIFY(waitForDance());
    }

    void aStoppedSearchStaysAsItIsUntilAskedAgain()
    {
        context().animations.want({"dance"});
        QTRY_VERIFY(dance().phase == ResultPhase::Computing || dance().phase == ResultPhase::Ready);
        context().animations.stop("dance");
        if (dance().phase != ResultPhase::Ready)
            QVERIFY(dance().phase == ResultPhase::Idle);
        context().animations.retry("dance");
        QVERIFY(waitForDance());
    }

    void renamedAndRemovedAnimationsAreFollowed()
    {
        context().animations.want({"dance"});
        QVERIFY(waitForDance());
        QVERIFY(renameEntry(context().document, {Section::Animations, "dance"}, "waltz"));
        QVERIFY(test::waitForResult(context(), "waltz"));
        QVERIFY(context().animations.resultState("dance") == nullptr);
        QCOMPARE(context().animations.result("waltz")->sequence.name, std::string("waltz"));
        removeEntries(context().document, Section::Animations, {"waltz"});
        QTRY_VERIFY(context().animations.resultState("waltz") == nullptr);
    }

    void closingWhileSearchingIsSafe()
    {
        context().animations.want({"dance"});
        QTRY_VERIFY(dance().phase == ResultPhase::Computing || dance().phase == ResultPhase::Ready);
        m_context.reset();
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::AnimationResultsTest);
#include "tst_animationresults.moc"
