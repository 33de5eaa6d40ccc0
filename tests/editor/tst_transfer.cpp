// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// A performance on another body: from the pairs of triangles to the clip.
#include "editor/documents/projectpaths.h"
#include "exporting.h"
#include "model/core/file.h"
#include "tests/qt/registry.h"
#include "transferfixture.h"
#include "widgets/controls/elidedlabel.h"
#include "widgets/graph/linechart.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QProcess>
#include <QPushButton>
#include <QToolButton>
#include <filesystem>

namespace quadrille {

class TransferTest : public TransferFixture
{
    Q_OBJECT

private slots:
    void theEmptyStateMakesATransferOntoTheOtherBody()
    {
        open(takes());
        QTRY_VERIFY(message().text().contains("another body"));
        QTest::mouseClick(message().findChild<QPushButton*>(), Qt::LeftButton);
        QCOMPARE(document().project().transfers.size(), std::size_t{1});
        QCOMPARE(entry().clip, std::string("sequences/dance"));
        QCOMPARE(entry().target, (NamedFrame{"stone", FrameIndex(0)}));
        // Strips have no limbs: nothing can be proposed, but both are there to be clicked on.
        QTRY_COMPARE(phase(), ResultPhase::Failed);
        QTRY_COMPARE(message().kind(), widgets::MessageStrip::Kind::Error);
        QTRY_VERIFY(advice().contains("Click on a place of the template"));
        QTRY_VERIFY(workspace().scene().figureOf(TransferWorkspace::targetName()) >= 0);
        document().undoStack()->undo();
        QVERIFY(document().project().transfers.empty());
        QTRY_VERIFY(workspace().scene().shown().isEmpty());
    }

    void theBodyDoesWhatTheTemplateDoes()
    {
        openReady();
        QCOMPARE(find<widgets::ElidedLabel>("transferState")->text(), QStringLiteral("Ready: 7 frames"));
        const Frame made = transfer().result()->sequence.frame(FrameIndex(3));
        const Frame wanted = context().media.sequence("dance")->frame(FrameIndex(3));
        const auto rise = [](const Frame& frame) {
            return (frame.positions().back() - frame.positions().front()).normalized().y();
        };
        QVERIFY(std::abs(rise(made) - rise(wanted)) < 0.05F);
        QVERIFY(!find<widgets::LineChart>("transferChartLines")->isEmpty());
        QCOMPARE(find<widgets::LineChart>("transferChartLines")->marker(), std::optional(0.0));
        workspace().player().goTo(4);
        QCOMPARE(find<widgets::LineChart>("transferChartLines")->marker(), std::optional(4.0));
    }

    void clicksOnBothBodiesMakeAPairThatIsUndone()
    {
        openReady(6);
        const auto before = list()->topLevelItemCount();
        QCOMPARE(before, 6);
        click(0, 6);
        QVERIFY(editor().hint().contains("of the body"));
        click(1, 7);
        QCOMPARE(entry().pairs.size(), std::size_t{7});
        QCOMPARE(entry().pairs.back(), (TrianglePair{TriangleIndex(6), TriangleIndex(7)}));
        QCOMPARE(list()->topLevelItemCount(), 7);
        QCOMPARE(list()->indexOfTopLevelItem(list()->currentItem()), 6);
        QVERIFY(transfer().result() == nullptr); // it is of other pairs
        QTRY_VERIFY(transfer().result() != nullptr);
        // A triangle of the body moves as one of the template only.
        click(0, 7);
        click(1, 0);
        QCOMPARE(entry().pairs.size(), std::size_t{7});
        document().undoStack()->undo();
        QCOMPARE(entry().pairs.size(), std::size_t{6});
        QCOMPARE(list()->topLevelItemCount(), 6);
    }

    void theViewStaysWhereItIsWhilePairsAreEdited()
    {
        openReady(6);
        QTRY_COMPARE(workspace().scene().shown().size(), 2);
        click(0, 6);
        const widgets::Turntable camera = workspace().view().viewport().camera();
        const int figure = workspace().scene().figureOf(TransferWorkspace::targetName());
        click(1, 7);
        QVERIFY(transfer().result() == nullptr);
        QTRY_VERIFY(transfer().result() != nullptr);
        document().undo();
        QTRY_VERIFY(transfer().result() != nullptr && entry().pairs.size() == 6);
        QCOMPARE(workspace().scene().figureOf(TransferWorkspace::targetName()), figure);
        QCOMPARE(workspace().view().viewport().camera(), camera);
    }

    void listAndViewSelectTheSamePair()
    {
        openReady();
        list()->setCurrentItem(list()->topLevelItem(3));
        QCOMPARE(editor().selected(), 3);
        editor().setSelected(5);
        QCOMPARE(list()->indexOfTopLevelItem(list()->currentItem()), 5);
        QVERIFY(!action("transfer.mirror")->isEnabled()); // nothing tells sides of strips
        action("transfer.removePair")->trigger();
        QCOMPARE(entry().pairs.size(), std::size_t{triangles - 1});
        QCOMPARE(transfer().selected(), -1);
        QVERIFY(!action("transfer.removePair")->isEnabled());
    }

    /// From no pairs to a file that the program writes again without the editor.
    void tenPairsMakeAClipThatTheProgramRepeats()
    {
        open(transferred(0));
        document().saveAs(toPath(place("strips.quadrille")));
        QTRY_COMPARE(phase(), ResultPhase::Failed);
        QTRY_VERIFY(workspace().scene().figureOf(TransferWorkspace::targetName()) >= 0);
        lookDown();
        constexpr std::uint32_t count = 10;
        for (std::uint32_t pair = 0; pair < count; ++pair) {
            // Bodies are drawn anew while one clicks.
            QTRY_VERIFY((click(0, pair), editor().hint().contains("of the body")));
            QTRY_VERIFY((click(1, pair), entry().pairs.size() == pair + 1));
            QTRY_COMPARE(phase(), ResultPhase::Ready);
        }
        list()->setCurrentItem(list()->topLevelItem(4));
        action("transfer.removePair")->trigger();
        QCOMPARE(entry().pairs.size(), std::size_t{count - 1});
        document().undo();
        for (std::uint32_t pair = 0; pair < count; ++pair)
            QCOMPARE(entry().pairs[pair], (TrianglePair{TriangleIndex(pair), TriangleIndex(pair)}));
        QTRY_VERIFY(transfer().preview() != nullptr && transfer().preview()->posed);
        QTRY_VERIFY(transfer().result() != nullptr);

        action("transfer.export")->trigger();
        QTRY_VERIFY(test::exportDialog() != nullptr);
        test::chooseExportFormat("pc2");
        test::typeExportPlace("out/strip.pc2");
        test::acceptAndCloseExport();
        document().save();
        const FileContent written = readFile(toPath(place("out/strip.pc2")));
        namespace fs = std::filesystem;
        fs::create_directory(toPath(place("elsewhere")));
        for (const char* name : {"dance", "stone.obj", "strips.quadrille"})
            fs::copy(toPath(place(name)), toPath(place(QStringLiteral("elsewhere/") + name)),
                     fs::copy_options::recursive);
        QProcess program;
        program.start(QStringLiteral(QUADRILLE_PROGRAM), {"rebuild", place("elsewhere/strips.quadrille")});
        QVERIFY(program.waitForFinished(120000));
        QVERIFY2(program.exitCode() == 0, program.readAllStandardError().constData());
        QVERIFY(readFile(toPath(place("elsewhere/out/strip.pc2"))).text() == written.text());
    }

    void aDragIsOneStep()
    {
        openReady(4);
        const int steps = document().undoStack()->count();
        const QPoint from = pixel(1, 3);
        const QPoint to = pixel(1, 6);
        mouse(QEvent::MouseButtonPress, from);
        for (int step = 1; step <= 6; ++step)
            mouse(QEvent::MouseMove, from + (to - from) * step / 6);
        QCOMPARE(entry().pairs[3].onTarget, TriangleIndex(6));
        mouse(QEvent::MouseButtonRelease, to);
        QCOMPARE(entry().pairs[3].onTemplate, TriangleIndex(3));
        QCOMPARE(document().undoStack()->count(), steps + 1);
        document().undoStack()->undo();
        QCOMPARE(entry().pairs[3].onTarget, TriangleIndex(3));
    }

    void referencePosesStandStill()
    {
        openReady();
        action("transfer.reference")->trigger();
        QTRY_COMPARE(workspace().scene().frameCount(), std::int64_t{1});
        QVERIFY(!action("transfer.takeReference")->isEnabled());
        action("transfer.reference")->trigger();
        QTRY_COMPARE(workspace().scene().frameCount(), std::int64_t{frames});
        workspace().player().goTo(2);
        action("transfer.takeReference")->trigger();
        QCOMPARE(entry().reference, (NamedFrame{"dance", FrameIndex(2)}));
        QTRY_VERIFY(transfer().result() != nullptr);
    }

    void settingsAreEditedInPanelAndProperties()
    {
        openReady();
        find<QDockWidget>("transferSettingsDock")->raise();
        QTRY_VERIFY(find<QCheckBox>("transferPanelPoses")->isVisible());
        find<QCheckBox>("transferPanelPoses")->click();
        QCOMPARE(entry().correctsPose, false);
        find<QComboBox>("transferPanelField")->setCurrentIndex(1);
        QCOMPARE(entry().field, FieldKind::Logarithms);
        context().selection.select({Section::Transfers, "stone dances"});
        QCOMPARE(find<QComboBox>("transferField")->currentIndex(), 1);
        auto* truth = find<QComboBox>("transferPanelTruth");
        QCOMPARE(truth->count(), 2); // none, and the only take of the body
        truth->setCurrentIndex(truth->findText("stone"));
        QCOMPARE(entry().truth, std::string("sequences/stone"));
        QCOMPARE(find<QComboBox>("transferTruth")->currentText(), QStringLiteral("stone"));
        // Another body: its triangles are others.
        auto* target = find<QComboBox>("transferBarTarget");
        target->setCurrentIndex(target->findText("dance"));
        QCOMPARE(entry().target.sequence, std::string("dance"));
        QVERIFY(entry().pairs.empty());
        QVERIFY(entry().truth.empty());
    }

    /// What is wider than its place is cut off: panels of windows 1280 wide are 240 wide.
    void settingsFitTheirPanelInSmallWindows()
    {
        openReady();
        const auto* area = find<QWidget>("transferSettingsPanel")->findChild<QScrollArea*>();
        const auto* button = area->findChild<QToolButton*>();
        const auto back = qScopeGuard([&] { context().languages.setLanguage("en"); });
        for (const char* language : {"fr", "en"}) {
            const QString before = button->text();
            context().languages.setLanguage(language);
            QTRY_VERIFY(button->text() != before);
            QVERIFY2(area->widget()->minimumSizeHint().width() <= 240, language);
        }
    }

    void theClipBecomesATake()
    {
        openReady();
        action("transfer.addSequence")->trigger();
        QCOMPARE(document().project().sequences.size(), std::size_t{3});
        const SequenceEntry& added = document().project().sequences.back();
        QCOMPARE(added.source, std::string("clip:transfers/stone dances"));
        QCOMPARE(added.character, std::string("scan"));
        QVERIFY(test::waitForSequence(*m_window, QString::fromStdString(added.name)));
        QCOMPARE(context().media.sequence(QString::fromStdString(added.name))->frameCount(),
                 std::int64_t{frames});
    }

    void anotherNameKeepsTheResult()
    {
        openReady();
        QVERIFY(renameEntry(document(), {Section::Transfers, "stone dances"}, "statue"));
        QCOMPARE(transfer().name(), QStringLiteral("statue"));
        QTRY_VERIFY(transfer().result() != nullptr);
        QCOMPARE(transfer().result()->entry.name, std::string("statue"));
    }

    void picturesOfCamerasAreProjectedOntoIt()
    {
        openReady();
        context().selection.select({Section::Transfers, "stone dances"});
        const QString cameras = QDir(m_folder->path()).filePath("cameras.json");
        QCOMPARE(transfer().addProjection(cameras), QStringLiteral("stone dances, filmed"));
        const auto projection = [this]() -> const ProjectionEntry& {
            return document().project().projections.front();
        };
        QCOMPARE(projection().clip, std::string("transfers/stone dances"));
        QCOMPARE(QString::fromStdString(projection().cameras), cameras);
        find<QCheckBox>("projectionFills")->click();
        QCOMPARE(projection().fills, false);
        document().undoStack()->undo();
        QCOMPARE(projection().fills, true);
        // Of a take where that is what is selected.
        context().selection.selectSequences({"dance"});
        transfer().addProjection(cameras);
        QCOMPARE(document().project().projections.back().clip, std::string("sequences/dance"));
    }

    void nobodyLooksNothingIsComputed()
    {
        document().reset(transferred());
        m_window->workspaces().select("sequences");
        QTest::qWait(200);
        QVERIFY(context().transfers.resultState("stone dances") == nullptr);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::TransferTest);
#include "tst_transfer.moc"
