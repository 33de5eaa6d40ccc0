// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Variations of a movement from the choice of takes to what is learned.
#include "dropping.h"
#include "editor/docks/projecttreemodel.h"
#include "editor/documents/projectpaths.h"
#include "editor/workspaces/variations/latentpanel.h"
#include "model/project/results/rebuild.h"
#include "tests/qt/registry.h"
#include "variationsfixture.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/graph/linechart.h"
#include "widgets/latent/latentview.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>

namespace quadrille {

class VariationsTest : public VariationsFixture
{
    Q_OBJECT

private slots:
    void takesAreChosenByTheirBoxes()
    {
        document().reset(test::swayingProject(m_folder->path()));
        m_window->workspaces().select("variations");
        show("movementPanel");
        clickBox("trainingTakes", 0);
        QCOMPARE(document().project().variations.size(), 1U);
        clickBox("trainingTakes", 2);
        const VariationEntry& made = document().project().variations.front();
        QCOMPARE(made.training.size(), 2U);
        QCOMPARE(made.training[1].sequence, std::string("third"));
        QCOMPARE(made.samples.size(), 1U);
        QCOMPARE(made.samples[0].of, std::string("first"));
        clickBox("trainingTakes", 0);
        QCOMPARE(document().project().variations.front().training.size(), 1U);
        QVERIFY(document().project().variations.front().samples.empty());
        document().undo();
        QCOMPARE(document().project().variations.front().samples.size(), 1U);
        QCOMPARE(row("trainingTakes", 0)->checkState(0), Qt::Checked);
    }

    void takesAreDroppedFromTheirCards()
    {
        document().reset(test::swayingProject(m_folder->path()));
        m_window->workspaces().select("variations");
        show("movementPanel");
        QWidget& list = *test::find<QTreeWidget>("trainingTakes")->viewport();
        test::dropCard("second", list, {20, 20});
        test::dropCard("third", list, {20, 20});
        test::dropCard("second", list, {20, 20}); // it is there already
        QCOMPARE(document().project().variations.size(), 1U);
        const VariationEntry& made = document().project().variations.front();
        QCOMPARE(made.training.size(), 2U);
        QCOMPARE(made.training[0].sequence, std::string("second"));
        QCOMPARE(made.training[1].sequence, std::string("third"));
        QCOMPARE(row("trainingTakes", 1)->checkState(0), Qt::Checked);
        document().undo();
        QCOMPARE(document().project().variations.front().training.size(), 1U);
    }

    void thePanelsFitASmallScreen()
    {
        constexpr QSize small(1280, 720);
        m_window->resize(small);
        open();
        QTest::qWait(100);
        QCOMPARE(m_window->size(), small);
    }

    void aPairIsBlendedBeforeLearning()
    {
        open();
        show("movementPanel");
        test::find<QPushButton>("blendAdd")->click();
        QCOMPARE(entry().blends.size(), 1U);
        QCOMPARE(entry().blends[0].to, std::string("second"));
        row("blends", 0)->setText(1, "25 %, 75");
        QCOMPARE(entry().blends[0].weights, (std::vector<double>{0.25, 0.75}));
        row("blends", 0)->setText(1, "nothing");
        QCOMPARE(entry().blends[0].weights, (std::vector<double>{0.25, 0.75}));
        QVERIFY(test::waitForState(context(), "sways", test::isNotLearned));
        QTRY_COMPARE(resultState().movement->alignment.takes.size(), 4U);
        auto* blends = test::find<QTreeWidget>("blends");
        blends->setCurrentItem(blends->topLevelItem(0));
        QTest::keyClick(blends, Qt::Key_Delete);
        QVERIFY(entry().blends.empty());
    }

    void takesAreAlignedByThemselvesAndTheirWarpsShown()
    {
        open();
        QCOMPARE(resultState().movement->capturedCount(), 2U);
        show("warpPanel");
        auto* chart = test::find<widgets::LineChart>("warpChart");
        QCOMPARE(chart->series().size(), 2U);
        QCOMPARE(chart->series()[0].points.size(), 20U);
        QCOMPARE(row("warpedTakes", 0)->text(1), "0–19");
        QCOMPARE(row("trainingTakes", 0)->text(2), "0–19");
        QVERIFY(row("trainingTakes", 2)->text(2).isEmpty());
    }

    void settingsForThoseWhoKnowAreFoldedAway()
    {
        open();
        show("learningPanel");
        auto* tolerance = test::find<QDoubleSpinBox>("learnTolerance");
        QVERIFY(!tolerance->isVisible());
        test::find<QToolButton>("learnAdvanced")->click();
        QTRY_VERIFY(tolerance->isVisible());
        QCOMPARE(tolerance->value(), 1.0);
        tolerance->setValue(4);
        QCOMPARE(entry().learning.tolerance, 4e-6);
        test::find<QToolButton>("learnToleranceReset")->click();
        QCOMPARE(entry().learning.tolerance, GpdmSettings().tolerance);
        test::find<QDoubleSpinBox>("chainLeast")->setValue(99);
        QCOMPARE(entry().chain.leastAcceptance, entry().chain.greatestAcceptance - 0.01);
        auto* distance = test::find<QDoubleSpinBox>("limitDistance");
        distance->setValue(6);
        QCOMPARE(entry().limits.poseDistance.value(), 0.06);
        distance->setValue(0);
        QVERIFY(!entry().limits.poseDistance);
        QCOMPARE(distance->text(), QStringLiteral("As the takes"));
        test::find<QDoubleSpinBox>("limitVolume")->setValue(35);
        QVERIFY(entry().limits.volumeChange == 0.35); // as it is typed, to the last digit
        test::find<QDoubleSpinBox>("limitVolume")->setValue(5);
        QCOMPARE(entry().limits.volumeChange, 0.05);
        test::find<QToolButton>("learnAdvanced")->click();
        QTRY_VERIFY(!tolerance->isVisible());
    }

    void limitsAreAskedOfDrawingsAlone()
    {
        learn();
        const auto movement = resultState().movement;
        variation().edit("strict", "limits", [](VariationEntry& after) { after.limits.poseDistance = 1e-6; });
        QTRY_VERIFY(resultState().drawn->at(0).variations.empty());
        QCOMPARE(resultState().movement, movement);
        const DrawnSet& set = resultState().drawn->at(0);
        QVERIFY(set.rejected > 0);
        QCOMPARE(set.faults[static_cast<std::size_t>(VariationFault::PoseDistance)], set.rejected);
        QVERIFY(test::find<QLabel>("samplesSummary")->text().contains("3 were asked for"));
    }

    void theProjectTreeTellsHowFarItIs()
    {
        open();
        auto* model = qobject_cast<ProjectTreeModel*>(test::find<QTreeView>("projectTree")->model());
        const auto state = [model] {
            return static_cast<EntryState>(
                model->indexOf({Section::Variations, "sways"}).data(ProjectTreeModel::StateRole).toInt());
        };
        QCOMPARE(state(), EntryState::Stale);
        action("variations.learn")->trigger();
        QCOMPARE(state(), EntryState::Computing);
        QVERIFY(test::waitForVariations(context(), "sways"));
        QCOMPARE(state(), EntryState::Fresh);
    }

    void learningIsStoppedAndBegunAgain()
    {
        open();
        VariationEntry endless = entry();
        endless.learning.tolerance = 1e-300;
        endless.learning.window = 1'000'000;
        endless.learning.greatestIterations = 1'000'000;
        endless.learning.restarts = 100;
        const auto aligned = resultState().movement;
        variation().edit("endless", "learning", [&](VariationEntry& after) { after = endless; });
        QTRY_VERIFY(resultState().movement != aligned);
        QVERIFY(resultState().isNotLearned());
        show("learningPanel");
        action("variations.learn")->trigger();
        QVERIFY(resultState().does(VariationResults::Work::Learning));
        auto* chart = test::find<widgets::LineChart>("objectiveChart");
        QTRY_VERIFY(!chart->isEmpty() && chart->series()[0].points.size() > 3);
        QVERIFY(action("variations.stop")->isEnabled());
        action("variations.stop")->trigger();
        QVERIFY(test::waitForVariations(context(), "sways"));
        QVERIFY(resultState().isStopped);
        QVERIFY(resultState().parts[0].error);
        QCOMPARE(resultState().drawn->at(0).variations.size(), 3U);
        QVERIFY(test::find<widgets::MessageStrip>("variationsViewMessage")->text().contains("stopped"));
        // Reading again finds nothing better: the best so far stays.
        context().variations.readStopped();
        QVERIFY(resultState().does(VariationResults::Work::Opening));
        QVERIFY(test::waitForVariations(context(), "sways"));
        QVERIFY(resultState().isStopped);

        const auto stopped = resultState().movement;
        document().undo();
        QTRY_VERIFY(resultState().movement != stopped);
        QVERIFY(resultState().isNotLearned());
        action("variations.learn")->trigger();
        QVERIFY(test::waitForVariations(context(), "sways"));
        QVERIFY(!resultState().isStopped);
        QVERIFY(resultState().parts[0].stop && *resultState().parts[0].stop != GpdmStop::Cancelled);
        QVERIFY(resultState().parts[0].objective.back() < resultState().parts[0].objective.front());
    }

    void whatWasLearnedIsThereAgainWhenTheProjectIsOpened()
    {
        document().reset(test::variedProject(m_folder->path()));
        const auto file = toPath(m_folder->filePath("p.quadrille"));
        document().saveAs(file);
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForState(context(), "sways", test::isNotLearned));
        action("variations.learn")->trigger();
        QVERIFY(test::waitForVariations(context(), "sways"));
        const double objective = resultState().parts[0].objective.back();
        document().reset({});
        document().load(file);
        m_window->workspaces().select("sequences");
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForVariations(context(), "sways"));
        QCOMPARE(resultState().parts[0].objective.back(), objective);
    }

    void whatWasDrawnIsThereAgainWhenTheProjectIsOpened()
    {
        document().reset(test::variedProject(m_folder->path()));
        const auto file = toPath(m_folder->filePath("p.quadrille"));
        document().saveAs(file);
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForState(context(), "sways", test::isNotLearned));
        action("variations.learn")->trigger();
        QVERIFY(test::waitForVariations(context(), "sways"));
        const auto before = resultState().drawn;
        // What is drawn is kept in the background.
        QTRY_VERIFY(context().jobs.jobs().empty());
        document().reset({});
        QVERIFY(context().variations.resultState("sways") == nullptr);
        bool wasDrawn = false;
        connect(&context().variations, &VariationResults::changed, this, [&] {
            const auto* now = context().variations.resultState("sways");
            wasDrawn = wasDrawn || (now != nullptr && now->does(VariationResults::Work::Drawing));
        });
        document().load(file);
        m_window->workspaces().select("sequences");
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForVariations(context(), "sways"));
        QVERIFY(!wasDrawn);
        const DrawnSet& was = before->at(0);
        const DrawnSet& is = resultState().drawn->at(0);
        QCOMPARE(is.rejected, was.rejected);
        QCOMPARE(is.variations.size(), was.variations.size());
        QVERIFY(was.spread > 0);
        QCOMPARE(is.spread, was.spread);
        QCOMPARE(is.isSpreadGuess, was.isSpreadGuess);
        for (std::size_t i = 0; i < was.variations.size(); ++i) {
            QVERIFY(loadFrames(is.variations[i].sequence) == loadFrames(was.variations[i].sequence));
            QVERIFY(is.variations[i].latents == was.variations[i].latents);
            QCOMPARE(is.variations[i].quality.meanPoseDistance, was.variations[i].quality.meanPoseDistance);
        }
        // What was kept is what a rebuild takes: it computes nothing.
        const RebuildReport report = rebuild(document().snapshot(), document().workingFile(),
                                             {.targets = {"variations/sways"}, .dryRun = true});
        QCOMPARE(report.count(StepState::Stale), 0U);
        // Other settings are drawn anew.
        variation().edit("more", "count", [](VariationEntry& after) { after.samples[0].count = 4; });
        QTRY_VERIFY(wasDrawn && resultState().phase == ResultPhase::Ready);
        QCOMPARE(resultState().drawn->at(0).variations.size(), 4U);
    }

    void otherVariationsAreLookedAtAndTheFirstAreStillThere()
    {
        learn();
        const auto drawn = resultState().drawn;
        action("variations.duplicate")->trigger();
        const QString copy = context().selection.shownVariation();
        QVERIFY(copy != "sways");
        // What is known of the first is known of its copy.
        QVERIFY(test::waitForState(context(), copy, test::isReady));
        QVERIFY(resultState().drawn == drawn);
        context().selection.select({Section::Variations, "sways"});
        QCOMPARE(resultState().phase, ResultPhase::Ready);
        QVERIFY(resultState().drawn == drawn);
        document().undo();
        QTRY_VERIFY(context().variations.resultState(copy) == nullptr);
    }

    void theLatentViewGoesToTheFrameThatIsClicked()
    {
        learn();
        show("latentPanel");
        widgets::LatentView& view = m_window->variations().latent().view();
        QTRY_COMPARE(view.paths().size(), 5U);
        QVERIFY(!view.paths()[0].isSample);
        QVERIFY(view.paths()[2].isSample);
        emit view.activated(0, 7);
        QTRY_COMPARE(m_window->variations().player().frame().value, 7);
        action("variations.confidence")->trigger();
        QTRY_VERIFY(view.paths()[0].values.size() == 20);
        action("variations.confidence")->trigger();
    }

    void whatCannotBeLearnedSaysWhy()
    {
        Project project = test::variedProject(m_folder->path());
        project.variations[0].training[1].range = FrameRange{FrameIndex(0), FrameIndex(1)};
        document().reset(project);
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForState(context(), "sways", test::isFailed));
        QCOMPARE(resultState().error->code(), ErrorCode::TakeTooShort);
        QVERIFY(test::find<QWidget>("variationsViewMessage")->isVisible());
        document().reset(test::variedProject(m_folder->path()));
        context().selection.select({Section::Variations, "sways"});
        QVERIFY(test::waitForState(context(), "sways", test::isNotLearned));
        QVERIFY(!test::find<QWidget>("variationsViewMessage")->isVisible());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::VariationsTest);
#include "tst_variations.moc"
