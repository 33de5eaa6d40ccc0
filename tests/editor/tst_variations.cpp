// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Variations of a movement from the choice of takes to the data set.
#include "editor/commands/projectedits.h"
#include "editor/docks/projecttreemodel.h"
#include "editor/documents/projectpaths.h"
#include "editor/workspaces/variations/latentpanel.h"
#include "model/project/opensequence.h"
#include "model/project/rebuild.h"
#include "variedproject.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/graph/linechart.h"
#include "widgets/latent/latentview.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDirIterator>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>
#include <memory>

namespace quadrille {

class VariationsTest : public QObject
{
    Q_OBJECT

private:
    using State = VariationMedia::State;

    EditorContext& context() { return m_window->context(); }
    ProjectDocument& document() { return context().document; }
    CurrentVariation& variation() { return m_window->variations().variation(); }
    const VariationEntry& entry() { return *document().variation("sways"); }
    const VariationMedia::Medium& medium() { return *context().variations.medium("sways"); }
    QAction* action(const char* id) { return context().actions.action(QLatin1String(id)); }
    void show(const char* panel) { Workspace::showPanel(test::find<QWidget>(QLatin1String(panel))); }
    QStringList stage() { return m_window->variations().stage().shown(); }

    void open()
    {
        document().reset(test::variedProject(m_folder->path()));
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForState(context(), "sways", State::NotLearned));
    }
    void learn()
    {
        open();
        action("variations.learn")->trigger();
        QVERIFY(test::waitForVariations(context(), "sways"));
    }
    /// All files under a folder with what they hold, but for the project's own.
    static std::map<QString, QByteArray> contentsOf(const QString& folder)
    {
        std::map<QString, QByteArray> contents;
        QDirIterator files(folder, QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            if (file.open(QIODevice::ReadOnly))
                contents[QDir(folder).relativeFilePath(file.fileName())] = file.readAll();
        }
        return contents;
    }
    QTreeWidgetItem* row(const char* tree, int index)
    {
        return test::find<QTreeWidget>(QLatin1String(tree))->topLevelItem(index);
    }
    void clickBox(const char* tree, int index)
    {
        auto* view = test::find<QTreeWidget>(QLatin1String(tree));
        const QRect place = view->visualItemRect(view->topLevelItem(index));
        QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                          QPoint(place.left() + 10, place.center().y()));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase() { test::isolate(); }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSwayingTakes(m_folder->path());
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1400, 900);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }

    void cleanup()
    {
        m_window.reset();
        m_folder.reset();
    }

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
        QVERIFY(test::waitForState(context(), "sways", State::NotLearned));
        QTRY_COMPARE(medium().movement->alignment.takes.size(), 4U);
        auto* blends = test::find<QTreeWidget>("blends");
        blends->setCurrentItem(blends->topLevelItem(0));
        QTest::keyClick(blends, Qt::Key_Delete);
        QVERIFY(entry().blends.empty());
    }

    void takesAreAlignedByThemselvesAndTheirWarpsShown()
    {
        open();
        QCOMPARE(medium().movement->capturedCount(), 2U);
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
        QCOMPARE(entry().chain.leastAcceptance, entry().chain.greatestAcceptance);
        test::find<QDoubleSpinBox>("limitVolume")->setValue(5);
        QCOMPARE(entry().limits.volumeChange, 0.05);
        test::find<QToolButton>("learnAdvanced")->click();
        QTRY_VERIFY(!tolerance->isVisible());
    }

    void limitsAreAskedOfDrawingsAlone()
    {
        learn();
        const auto movement = medium().movement;
        variation().edit("strict", "limits", [](VariationEntry& after) { after.limits.poseDistance = 1e-6; });
        QTRY_VERIFY_WITH_TIMEOUT(medium().drawn->at(0).variations.empty(), 30000);
        QCOMPARE(medium().movement, movement);
        const DrawnSet& set = medium().drawn->at(0);
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
        endless.learning.greatestIterations = 100'000'000;
        endless.learning.restarts = 1'000'000;
        const auto aligned = medium().movement;
        variation().edit("endless", "learning", [&](VariationEntry& after) { after = endless; });
        QTRY_VERIFY_WITH_TIMEOUT(medium().movement != aligned, 30000);
        QCOMPARE(medium().state, State::NotLearned);
        show("learningPanel");
        action("variations.learn")->trigger();
        QCOMPARE(medium().state, State::Learning);
        auto* chart = test::find<widgets::LineChart>("objectiveChart");
        QTRY_VERIFY(!chart->isEmpty() && chart->series()[0].points.size() > 3);
        QVERIFY(action("variations.stop")->isEnabled());
        action("variations.stop")->trigger();
        QVERIFY(test::waitForVariations(context(), "sways"));
        QVERIFY(medium().isStopped);
        QVERIFY(medium().parts[0].error);
        QCOMPARE(medium().drawn->at(0).variations.size(), 3U);
        QVERIFY(test::find<widgets::MessageStrip>("variationsViewMessage")->text().contains("stopped"));
        // Reading again finds nothing better: the best so far stays.
        context().variations.readStopped();
        QCOMPARE(medium().state, State::Opening);
        QVERIFY(test::waitForVariations(context(), "sways"));
        QVERIFY(medium().isStopped);

        const auto stopped = medium().movement;
        document().undo();
        QTRY_VERIFY_WITH_TIMEOUT(medium().movement != stopped, 30000);
        QCOMPARE(medium().state, State::NotLearned);
        action("variations.learn")->trigger();
        QVERIFY(test::waitForVariations(context(), "sways"));
        QVERIFY(!medium().isStopped);
        QVERIFY(medium().parts[0].stop && *medium().parts[0].stop != GpdmStop::Cancelled);
        QVERIFY(medium().parts[0].objective.back() < medium().parts[0].objective.front());
    }

    void whatWasLearnedIsThereAgainWhenTheProjectIsOpened()
    {
        document().reset(test::variedProject(m_folder->path()));
        const auto file = toPath(m_folder->filePath("p.quadrille"));
        document().saveAs(file);
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForState(context(), "sways", State::NotLearned));
        action("variations.learn")->trigger();
        QVERIFY(test::waitForVariations(context(), "sways"));
        const double objective = medium().parts[0].objective.back();
        document().reset({});
        document().load(file);
        m_window->workspaces().select("sequences");
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForVariations(context(), "sways"));
        QCOMPARE(medium().parts[0].objective.back(), objective);
    }

    void samplesFollowTheirSettingsAndOneIsThrownAway()
    {
        learn();
        show("samplesPanel");
        QTRY_COMPARE(stage().size(), 3);
        test::find<QSpinBox>("sampleCount")->setValue(5);
        QCOMPARE(entry().samples[0].count, 5);
        QTRY_COMPARE_WITH_TIMEOUT(stage().size(), 5, 30000);
        auto* drawn = test::find<QTreeWidget>("drawnVariations");
        QCOMPARE(drawn->topLevelItemCount(), 5);
        drawn->setCurrentItem(drawn->topLevelItem(1));
        QTest::keyClick(drawn, Qt::Key_Delete);
        QCOMPARE(entry().samples[0].discarded, std::vector<int>{2});
        QTRY_COMPARE(stage().size(), 4);
        QCOMPARE(medium().state, State::Ready);
        clickBox("drawnVariations", 0);
        QTRY_COMPARE(stage().size(), 3);
        QTest::keyClick(drawn, Qt::Key_Insert);
        QVERIFY(entry().samples[0].discarded.empty());
        document().undo();
        QCOMPARE(entry().samples[0].discarded, std::vector<int>{2});
        const auto before = medium().drawn;
        action("variations.again")->trigger();
        QCOMPARE(entry().samples[0].seed, 2U);
        QTRY_VERIFY(medium().drawn != before);
        QVERIFY(test::waitForVariations(context(), "sways"));
        QVERIFY(medium().drawn->at(0).variations[0].latents != before->at(0).variations[0].latents);
    }

    void standingFeetAreKeptStillUnlessTheEntrySaysOtherwise()
    {
        learn();
        show("learningPanel");
        auto* box = test::find<QCheckBox>("drawContacts");
        QVERIFY(box->isChecked());
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
        QVERIFY(!entry().correctsContacts);
        // What was learned stays; variations are drawn again.
        QVERIFY(medium().state == State::Drawing || medium().state == State::Ready);
        QVERIFY(test::waitForVariations(context(), "sways"));
        document().undo();
        QVERIFY(entry().correctsContacts && box->isChecked());
    }

    void whatIsShownIsWhatARebuildWrites()
    {
        learn();
        const auto shown = loadFrames(*context().variations.clip("sways", 2));
        const Project project = document().snapshot();
        const auto file = document().workingFile();
        rebuild(project, file, {.targets = {"variations/sways/2"}});
        SequenceOpener opener(project, file.parent_path(), cacheFolder(file));
        QVERIFY(loadFrames(opener.openClip("variations/sways/2")->sequence) == shown);
    }

    void aBlendIsDrawnAtTheWeightOfTheSlider()
    {
        learn();
        show("samplesPanel");
        const auto before = medium().drawn;
        auto* towards = test::find<QComboBox>("sampleTo");
        towards->setCurrentIndex(1);
        emit towards->activated(1);
        QCOMPARE(entry().samples[0].to, std::string("second"));
        QCOMPARE(entry().samples[0].weight, 0.5);
        auto* slider = test::find<QSlider>("sampleWeight");
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(entry().samples[0].weight, 0.51);
        QTRY_VERIFY_WITH_TIMEOUT(medium().drawn != before, 30000);
        QVERIFY(test::waitForVariations(context(), "sways"));
        QCOMPARE(medium().drawn->at(0).variations.size(), 3U);
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
        QTRY_VERIFY_WITH_TIMEOUT(view.paths()[0].values.size() == 20, 20000);
        action("variations.confidence")->trigger();
    }

    void aVariationBecomesASequence()
    {
        learn();
        show("samplesPanel");
        auto* drawn = test::find<QTreeWidget>("drawnVariations");
        drawn->setCurrentItem(drawn->topLevelItem(2));
        action("variations.addSequence")->trigger();
        const SequenceEntry& added = document().project().sequences.back();
        QCOMPARE(added.source, std::string("clip:variations/sways/3"));
        const QString name = QString::fromStdString(added.name);
        QVERIFY(QTest::qWaitFor([&] { return context().media.sequence(name) != nullptr; }, 60000));
        const MeshSequence& sequence = *context().media.sequence(name);
        const MeshSequence& shown = *context().variations.clip("sways", 3);
        QCOMPARE(sequence.frameCount(), shown.frameCount());
        for (const std::int64_t frame : {0, 10, 19}) {
            const auto a = sequence.frame(FrameIndex(frame)).positions();
            const auto b = shown.frame(FrameIndex(frame)).positions();
            QVERIFY(std::ranges::equal(a, b));
        }
    }

    void theDataSetIsWrittenAndRebuiltWithTheSameBytes()
    {
        document().reset(test::variedProject(m_folder->path()));
        document().saveAs(toPath(m_folder->filePath("p.quadrille")));
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForState(context(), "sways", State::NotLearned));
        action("variations.learn")->trigger();
        QVERIFY(test::waitForVariations(context(), "sways"));
        variation().edit("discard", "discarded",
                         [](VariationEntry& after) { after.samples[0].discarded = {1}; });
        action("variations.export")->trigger();
        auto* format = test::find<QComboBox>("exportFormat");
        format->setCurrentIndex(format->findData("pc2"));
        emit format->activated(format->currentIndex());
        auto* place = test::find<QLineEdit>("exportPlace");
        const QString folder = m_folder->filePath("out");
        place->setText(folder + "/sways.pc2");
        emit place->textEdited(place->text());
        test::find<QPushButton>("exportAccept")->click();
        QTRY_COMPARE_WITH_TIMEOUT(document().project().exports.size(), 1U, 60000);
        QCOMPARE(document().project().exports[0].what, std::string("variations/sways"));
        const auto written = contentsOf(folder);
        QVERIFY(written.contains("sways_2.pc2"));
        QVERIFY(!written.contains("sways_1.pc2"));
        QVERIFY(written.contains("sways.json"));
        document().save();
        const Project project = loadProject(document().file());
        QDir(folder).removeRecursively();
        QDir(m_folder->filePath("p.quadrille.cache")).removeRecursively();
        const RebuildReport report = rebuild(project, document().file(), {.jobs = 1});
        QVERIFY(!report.hasFailures());
        QVERIFY(contentsOf(folder) == written);
    }

    void whatCannotBeLearnedSaysWhy()
    {
        Project project = test::variedProject(m_folder->path());
        project.variations[0].training[1].range = FrameRange{FrameIndex(0), FrameIndex(1)};
        document().reset(project);
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForState(context(), "sways", State::Failed));
        QCOMPARE(medium().error->code(), ErrorCode::TakeTooShort);
        QVERIFY(test::find<QWidget>("variationsViewMessage")->isVisible());
        document().reset(test::variedProject(m_folder->path()));
        context().selection.select({Section::Variations, "sways"});
        QVERIFY(test::waitForState(context(), "sways", State::NotLearned));
    }
};

} // namespace quadrille

QTEST_MAIN(quadrille::VariationsTest)
#include "tst_variations.moc"
