// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Variations that are drawn: chosen, thrown away, put into the project, exported.
#include "editor/documents/projectpaths.h"
#include "model/project/file/projectfile.h"
#include "model/project/media/opensequence.h"
#include "model/project/results/rebuild.h"
#include "model/project/store/resultplaces.h"
#include "tests/qt/registry.h"
#include "variationsfixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDirIterator>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTreeWidget>

namespace quadrille {

class VariationSamplesTest : public VariationsFixture
{
    Q_OBJECT

private:
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

private slots:
    void samplesFollowTheirSettingsAndOneIsThrownAway()
    {
        learn();
        show("samplesPanel");
        QTRY_COMPARE(scene().size(), 3);
        test::find<QDoubleSpinBox>("sampleCount")->setValue(5);
        QCOMPARE(entry().samples[0].count, 5);
        QTRY_COMPARE(scene().size(), 5);
        auto* drawn = test::find<QTreeWidget>("drawnVariations");
        QCOMPARE(drawn->topLevelItemCount(), 5);
        drawn->setCurrentItem(drawn->topLevelItem(1));
        QTest::keyClick(drawn, Qt::Key_Delete);
        QCOMPARE(entry().samples[0].discarded, std::vector<int>{2});
        QTRY_COMPARE(scene().size(), 4);
        QCOMPARE(resultState().phase, ResultPhase::Ready);
        clickBox("drawnVariations", 0);
        QTRY_COMPARE(scene().size(), 3);
        QTest::keyClick(drawn, Qt::Key_Insert);
        QVERIFY(entry().samples[0].discarded.empty());
        document().undo();
        QCOMPARE(entry().samples[0].discarded, std::vector<int>{2});
        const auto before = resultState().drawn;
        action("variations.again")->trigger();
        QCOMPARE(entry().samples[0].seed, 2U);
        QTRY_VERIFY(resultState().drawn != before);
        QVERIFY(test::waitForVariations(context(), "sways"));
        QVERIFY(resultState().drawn->at(0).variations[0].latents != before->at(0).variations[0].latents);
    }

    void theSpreadStandsWhereSamplesAreDrawn()
    {
        learn();
        show("samplesPanel");
        auto* spread = test::find<QDoubleSpinBox>("spread");
        QVERIFY(spread->isVisible());
        QVERIFY(test::find<QWidget>("samplesPanel")->isAncestorOf(spread));
        QCOMPARE(spread->value(), entry().extent.spread);
        const auto before = resultState().drawn;
        spread->setValue(0.4);
        QCOMPARE(entry().extent.spread, 0.4);
        QTRY_VERIFY(resultState().drawn != before);
        document().undo();
        QCOMPARE(spread->value(), TrajectoryLimits().spread);
    }

    void aSpreadThatIsAGuessOrIsNotReachedIsSaid_data()
    {
        QTest::addColumn<bool>("isAlone");
        QTest::newRow("two takes of a movement") << false;
        QTest::newRow("two takes of two movements") << true;
    }
    void aSpreadThatIsAGuessOrIsNotReachedIsSaid()
    {
        QFETCH(bool, isAlone);
        const auto summary = [] { return test::find<QLabel>("samplesSummary")->text(); };
        Project project = test::variedProject(m_folder->path());
        project.variations.at(0).extent.spread = 0.15; // well within what the model is sure of
        for (std::size_t take = 0; take < 2; ++take)
            project.sequences.at(take).labels = {
                {.label = isAlone && take > 0 ? "other" : "sway", .frames = {FrameIndex(0), FrameIndex(19)}}};
        document().reset(project);
        m_window->workspaces().select("variations");
        QVERIFY(test::waitForState(context(), "sways", test::isNotLearned));
        action("variations.learn")->trigger();
        QVERIFY(test::waitForVariations(context(), "sways"));
        show("samplesPanel");
        QCOMPARE(resultState().drawn->at(0).isSpreadGuess, isAlone);
        QCOMPARE(summary().contains("a guess"), isAlone);
        QVERIFY2(!summary().contains("apart by"), qPrintable(summary()));
        const auto before = resultState().drawn;
        variation().edit("far", "spread", [](VariationEntry& after) { after.extent.spread = 3; });
        QTRY_VERIFY(resultState().drawn != before);
        QVERIFY(test::waitForVariations(context(), "sways"));
        QVERIFY(resultState().drawn->at(0).spread < 2);
        QVERIFY2(summary().contains("apart by"), qPrintable(summary()));
    }

    void theTakesOfABlendShowTheFramesThatAreLearnedFrom()
    {
        learn();
        const auto blended = resultState().drawn;
        variation().edit("blend", "to", [](VariationEntry& after) {
            after.samples[0].to = "second";
            after.samples[0].weight = 0.5;
        });
        QTRY_VERIFY(resultState().drawn != blended);
        QVERIFY(test::waitForVariations(context(), "sways"));
        action("variations.original")->setChecked(true);
        QTRY_VERIFY(scene().contains("first") && scene().contains("second"));
        for (const char* take : {"first", "second"}) {
            QTRY_VERIFY(m_window->variations().scene().sequenceOf(take) != nullptr);
            QCOMPARE(m_window->variations().scene().sequenceOf(take)->frameCount(), 20);
        }
        action("variations.original")->setChecked(false);
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
        QVERIFY(resultState().does(VariationResults::Work::Drawing) ||
                resultState().phase == ResultPhase::Ready);
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
        const auto before = resultState().drawn;
        auto* towards = test::find<QComboBox>("sampleTo");
        towards->setCurrentIndex(1);
        emit towards->activated(1);
        QCOMPARE(entry().samples[0].to, std::string("second"));
        QCOMPARE(entry().samples[0].weight, 0.5);
        auto* slider = test::find<QSlider>("sampleWeight");
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(entry().samples[0].weight, 0.51);
        QTRY_VERIFY(resultState().drawn != before);
        QVERIFY(test::waitForVariations(context(), "sways"));
        QCOMPARE(resultState().drawn->at(0).variations.size(), 3U);
    }

    void aSeedMayBeAsLongAsTheFileHasIt()
    {
        open();
        show("samplesPanel");
        auto* seed = test::find<QDoubleSpinBox>("sampleSeed");
        for (const std::uint64_t typed : {std::uint64_t{3'000'000'001}, std::uint64_t{9007199254740991}}) {
            seed->setFocus();
            seed->selectAll();
            QTest::keyClicks(seed, QString::number(typed));
            QTest::keyClick(seed, Qt::Key_Return);
            QCOMPARE(entry().samples[0].seed, typed);
            QCOMPARE(static_cast<std::uint64_t>(seed->value()), typed);
        }
        action("variations.again")->trigger();
        QCOMPARE(entry().samples[0].seed, std::uint64_t{9007199254740991});
        document().undo();
        QCOMPARE(entry().samples[0].seed, std::uint64_t{3'000'000'001});
        action("variations.again")->trigger();
        QCOMPARE(entry().samples[0].seed, std::uint64_t{3'000'000'002});
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
        QVERIFY(QTest::qWaitFor([&] { return context().media.sequence(name) != nullptr; }, test::patience));
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
        QVERIFY(test::waitForState(context(), "sways", test::isNotLearned));
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
        QTRY_COMPARE(document().project().exports.size(), 1U);
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
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::VariationSamplesTest);
#include "tst_variationsamples.moc"
