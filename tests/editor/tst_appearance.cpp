// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// A model of textures from its making to what is seen of it.
#include "appearancefixture.h"
#include "editor/workspaces/appearance/componentpictures.h"
#include "tests/qt/registry.h"
#include "widgets/controls/elidedlabel.h"
#include "widgets/controls/legendbar.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/graph/linechart.h"

#include <QDoubleSpinBox>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScopeGuard>
#include <QSlider>
#include <QSpinBox>

namespace quadrille {

class AppearanceTest : public AppearanceFixture
{
    Q_OBJECT

private:
    widgets::MessageStrip& message() { return workspace().view().message(); }
    QString stateText() { return find<widgets::ElidedLabel>("appearanceState")->text(); }
    void choose(const char* box, int index)
    {
        auto* combo = find<QComboBox>(box);
        combo->setFocus();
        while (combo->currentIndex() < index)
            QTest::keyClick(combo, Qt::Key_Down);
        while (combo->currentIndex() > index)
            QTest::keyClick(combo, Qt::Key_Up);
        QCOMPARE(combo->currentIndex(), index);
    }
    void chooseMode(TextureMode mode) { choose("appearanceMode", static_cast<int>(mode)); }
    /// The widest difference of two pictures, grey levels.
    static int differenceOf(const QImage& first, const QImage& second)
    {
        int widest = 0;
        for (int y = 0; y < first.height(); ++y) {
            for (int x = 0; x < first.width(); ++x)
                widest = std::max(widest, std::abs(qRed(first.pixel(x, y)) - qRed(second.pixel(x, y))));
        }
        return widest;
    }

private slots:
    void aCharacterWithoutTexturesIsToldWhatItNeeds()
    {
        open(project(false));
        QTRY_VERIFY(message().text().contains("no") && !message().isEmpty());
        QVERIFY2(message().text().contains("texture for each frame"), qPrintable(message().text()));
        QVERIFY(!action("appearance.build")->isEnabled());
    }

    void theButtonOfTheEmptyStateMakesAModel()
    {
        open(project());
        QTRY_VERIFY(message().text().contains("Eigen textures"));
        QTest::mouseClick(message().findChild<QPushButton*>(), Qt::LeftButton);
        QCOMPARE(document().project().appearances.size(), 1U);
        QCOMPARE(find<QComboBox>("appearanceNames")->currentText(), QString("textures"));
        QTRY_COMPARE(stateText(), QString("Not built yet"));
        document().undo();
        QVERIFY(document().project().appearances.empty());
    }

    void settingsAreEditedInTheBarAndUndone()
    {
        open(modelled());
        auto* components = find<QDoubleSpinBox>("appearanceBarComponents");
        components->setFocus();
        components->selectAll();
        QTest::keyClicks(components, "12\r");
        QCOMPARE(entry().components, std::int64_t{12});
        auto* warps = find<QDoubleSpinBox>("appearanceBarWarps");
        warps->setFocus();
        warps->selectAll();
        QTest::keyClicks(warps, "50\r");
        QCOMPARE(entry().warpShare, 0.5);
        choose("appearanceBarFlow", 0);
        QCOMPARE(entry().flow, FlowMethod::TvL1);
        QSignalSpy others(&context().appearances, &AppearanceResults::texturesMade);
        choose("appearanceBarVaried", 1);
        QCOMPARE(entry().varied, VariedTextures::Nearest);
        QCOMPARE(others.size(), 1); // clips of variations have other textures
        document().undo();
        QCOMPARE(others.size(), 2);
        document().undo();
        document().undo();
        document().undo();
        QCOMPARE(entry(), modelled().appearances.front());
        QCOMPARE(components->value(), 6.0);
    }

    /// What a window cannot be made as small as is cut off at the screen's edge.
    void theWindowFitsASmallScreenInEachLanguage()
    {
        Project project = modelled();
        project.appearances.front().name = "all that was captured of a dancer with a long name";
        open(std::move(project));
        const QComboBox& flow = *find<QComboBox>("appearanceBarFlow");
        QVERIFY(flow.isVisible());
        const auto back = qScopeGuard([&] { context().languages.setLanguage("en"); });
        for (const char* language : {"fr", "en"}) {
            const QString before = flow.currentText();
            context().languages.setLanguage(language);
            QTRY_VERIFY(flow.currentText() != before);
            const QSize least = flow.window()->minimumSizeHint();
            QVERIFY2(least.width() <= 1180, qPrintable(QString("%1 %2").arg(language).arg(least.width())));
            QVERIFY2(least.height() <= 680, qPrintable(QString("%1 %2").arg(language).arg(least.height())));
        }
    }

    void aModelIsBuiltAndGoesStaleWithItsSettings()
    {
        build();
        QVERIFY2(stateText().contains("18"), qPrintable(stateText())); // textures of both takes
        QVERIFY(!action("appearance.build")->isEnabled());
        QVERIFY(pair().quality->similarity > 0.8);
        QVERIFY(find<QLabel>("appearanceQuality")->text().contains("SSIM"));
        AppearanceEntry other = entry();
        other.components = 4;
        workspace().appearance().edit("change", "components",
                                      [&](AppearanceEntry& edited) { edited = other; });
        QTRY_COMPARE(phase(), ResultPhase::Stale);
        QVERIFY(stateText().contains("Out of date"));
        QVERIFY(action("appearance.build")->isEnabled());
        document().undo();
        QTRY_COMPARE(phase(), ResultPhase::Ready);
    }

    void buildingIsCancelled()
    {
        open(modelled());
        QTRY_COMPARE(phase(), ResultPhase::Stale);
        context().appearances.build("look");
        QVERIFY(find<QToolButton>("tool.appearance.stop")->isVisible());
        QVERIFY(find<QProgressBar>("appearanceProgress")->isVisible());
        press("tool.appearance.stop");
        QTRY_COMPARE(phase(), ResultPhase::Stale);
        QVERIFY(find<QToolButton>("tool.appearance.build")->isVisible());
    }

    void whatFailsSaysWhy()
    {
        pattern(0).scaled(32, 32).save(m_folder->filePath("looks/quick/0003.png"));
        open(modelled());
        QTRY_COMPARE(phase(), ResultPhase::Stale);
        press("tool.appearance.build");
        QTRY_COMPARE(phase(), ResultPhase::Failed);
        QVERIFY2(stateText().contains("32"), qPrintable(stateText()));
        QVERIFY(message().kind() == widgets::MessageStrip::Kind::Error);
        pattern(0).save(m_folder->filePath("looks/quick/0003.png"));
        QTest::mouseClick(message().findChild<QPushButton*>(), Qt::LeftButton);
        QTRY_COMPARE(phase(), ResultPhase::Ready);
    }

    void everyModeShowsWhatItSays()
    {
        build();
        const QImage original = pair().first.image;
        const QImage made = pair().second.image;
        QVERIFY(differenceOf(original, pattern(0)) == 0);
        QVERIFY(differenceOf(original, made) > 0);
        chooseMode(TextureMode::First);
        QTRY_COMPARE(view().image(), original);
        chooseMode(TextureMode::Difference);
        QTRY_VERIFY(find<widgets::LegendBar>("appearanceLegend")->isVisible());
        QTRY_COMPARE(find<widgets::LegendBar>("appearanceLegend")->range().minimum,
                     -find<widgets::LegendBar>("appearanceLegend")->range().maximum);
        QVERIFY(view().image() == pair().difference.image);
        chooseMode(TextureMode::AbsoluteDifference);
        QTRY_COMPARE(find<widgets::LegendBar>("appearanceLegend")->range().minimum, 0.0);
        chooseMode(TextureMode::SideBySide);
        auto* right = find<widgets::ComparedView>("appearanceTextureRight");
        QTRY_VERIFY(right->isVisible() && right->image() == made);
        view().zoomAbout({20, 20}, 3);
        QCOMPARE(right->zoom(), view().zoom());
        QCOMPARE(right->positionOf({0, 0}), view().positionOf({0, 0}));
        chooseMode(TextureMode::Swipe);
        QTRY_VERIFY(!right->isVisible());
        QCOMPARE(view().other(), made);
    }

    void theLineOfTheSwipeIsDraggedAndMovedByKeys()
    {
        build();
        shown().setMode(TextureMode::Swipe);
        QTRY_VERIFY(!view().other().isNull());
        const QPoint line = view().positionOf({0.5, 0.5}).toPoint();
        const QPoint to = view().positionOf({0.2, 0.5}).toPoint();
        QTest::mousePress(&view(), Qt::LeftButton, {}, line);
        QTest::mouseMove(&view(), to);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
        QVERIFY(std::abs(view().split() - 0.2) < 0.02);
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(std::abs(view().split() - 0.25) < 0.02);
        QTest::keyClick(&view(), Qt::Key_End, Qt::ShiftModifier);
        QCOMPARE(view().split(), 1.0);
    }

    void fewerComponentsLoseMore()
    {
        build();
        const double all = pair().quality->meanSquaredError;
        auto* number = find<QSpinBox>("appearanceUsedNumber");
        QCOMPARE(number->value(), 6);
        number->setFocus();
        number->selectAll();
        QTest::keyClicks(number, "0\r");
        QCOMPARE(shown().used(), 0);
        QTRY_VERIFY(pair().quality && pair().quality->meanSquaredError > 2 * all);
        find<QSlider>("appearanceUsed")->setFocus();
        QTest::keyClick(find<QSlider>("appearanceUsed"), Qt::Key_End);
        QCOMPARE(shown().used(), 6);
        QTRY_VERIFY(pair().quality && pair().quality->meanSquaredError == all);
    }

    void theEdgesOfTheLayoutAreDrawn()
    {
        build();
        press("tool.appearance.edges");
        QTRY_VERIFY(!view().uvEdges().isEmpty());
        press("tool.appearance.edges");
        QVERIFY(view().uvEdges().isEmpty());
    }

    void aSliderChangesTextureAndBody()
    {
        build();
        Workspace::showPanel(find<QWidget>("coefficientsPanel"));
        const QImage before = pair().second.image;
        QTRY_COMPARE(workspace().scene().textureOf("slow"), before.convertToFormat(QImage::Format_RGBA8888));
        auto* slider = find<QSlider>("coefficientTexture1");
        auto* number = find<QDoubleSpinBox>("coefficientTexture1Number");
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_End);
        QCOMPARE(number->value(), 3.0);
        QVERIFY(shown().isEdited());
        QTRY_VERIFY(pair().second.image != before);
        QTRY_COMPARE(workspace().scene().textureOf("slow"), pair().second.image);
        QVERIFY(find<QLabel>("coefficientsFrame")->text().contains("by hand"));
        QTest::mouseClick(find<QPushButton>("coefficientsMean"), Qt::LeftButton);
        QCOMPARE(number->value(), 0.0);
        QTest::mouseClick(find<QPushButton>("coefficientsReset"), Qt::LeftButton);
        QTRY_COMPARE(pair().second.image, before);
        QVERIFY(!shown().isEdited());
    }

    void whatWasMadeByHandIsNotOfAnotherFrame()
    {
        build();
        shown().setDeviations({}, 2);
        QVERIFY(shown().isEdited());
        workspace().player().goTo(3);
        QTRY_VERIFY(!shown().isEdited());
    }

    void aComponentOfTheGalleryIsShownLarge()
    {
        build();
        Workspace::showPanel(find<QWidget>("componentsPanel"));
        auto* warps = find<QListWidget>("eigenWarps");
        QTRY_COMPARE(warps->count(), 2);
        QTRY_COMPARE(find<QListWidget>("eigenTextures")->count(), 4);
        QVERIFY2(warps->item(0)->text().contains("%"), qPrintable(warps->item(0)->text()));
        QVERIFY(!warps->item(0)->icon().isNull());
        QTest::mouseClick(warps->viewport(), Qt::LeftButton, {},
                          warps->visualItemRect(warps->item(1)).center());
        QCOMPARE(shown().content(), TextureContent::Component);
        QCOMPARE(shown().component(), (ShownTexture::Component{ShownTexture::Space::Warps, 1}));
        QTRY_VERIFY(!pair().difference.image.isNull() && view().image() == pair().difference.image);
        const AppearanceDecoder& decoder = *workspace().appearance().opened()->decoder;
        QVERIFY(eigenWarpPicture(decoder, 1, 4) != eigenWarpPicture(decoder, 1, 0)); // arrows
        QTest::keyClick(warps, Qt::Key_Home);
        QTRY_COMPARE(shown().component().index, 0);
        chooseMode(TextureMode::SideBySide);
        QTRY_VERIFY(differenceOf(pair().first.image, pair().second.image) > 10);
    }

    void clipsAreOpenedAgainWhenAModelIsReady()
    {
        open(modelled());
        context().graphs.ask({});
        const auto graph = [this] { return context().graphs.resultState({}); };
        QTRY_VERIFY(graph() != nullptr && graph()->phase == ResultPhase::Ready);
        const auto before = graph()->opened;
        press("tool.appearance.build");
        QTRY_COMPARE(phase(), ResultPhase::Ready);
        QTRY_VERIFY(graph()->phase == ResultPhase::Ready && graph()->opened != before);
    }

    void theChartSaysWhatComponentsExplain()
    {
        build();
        const auto& series = find<widgets::LineChart>("qualityChart")->series();
        QCOMPARE(series.size(), 2U);
        QCOMPARE(series[0].points.front(), QPointF(0, 0));
        QVERIFY(std::abs(series[0].points.back().y() - 100) < 1e-6);
        for (std::size_t i = 1; i < series[1].points.size(); ++i)
            QVERIFY(series[1].points[i].y() >= series[1].points[i - 1].y());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::AppearanceTest);
#include "tst_appearance.moc"
