// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Textures that are completed, textures between two frames, and what a session keeps of them.
#include "appearancefixture.h"
#include "editor/workspaces/appearance/maskcanvas.h"
#include "model/project/steps/completionmask.h"
#include "tests/qt/registry.h"
#include "widgets/graph/linechart.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>

namespace quadrille {

class AppearanceMasksTest : public AppearanceFixture
{
    Q_OBJECT

private:
    void beginPainting()
    {
        Workspace::showPanel(find<QWidget>("masksPanel"));
        QTRY_VERIFY(action("appearance.paint")->isEnabled());
        press("tool.appearance.paint");
        QTRY_VERIFY(view().brush().has_value());
        QTRY_VERIFY(!view().image().isNull());
    }
    QPoint at(double u, double v) { return view().positionOf({u, v}).toPoint(); }
    void stroke(const QPointF& from, const QPointF& to)
    {
        QTest::mousePress(&view(), Qt::LeftButton, {}, at(from.x(), from.y()));
        QTest::mouseMove(&view(), at((from.x() + to.x()) / 2, (from.y() + to.y()) / 2));
        QTest::mouseMove(&view(), at(to.x(), to.y()));
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, at(to.x(), to.y()));
    }
    const CompletionEntry& completion() { return entry().completions.front(); }
    int marked(const std::vector<MaskStrokeEntry>& strokes)
    {
        std::vector<std::uint8_t> mask(std::size_t{side} * side);
        paintStrokes(strokes, side, side, mask);
        return static_cast<int>(std::ranges::count(mask, 1));
    }
    int tinted() { return static_cast<int>(qAlpha(view().tint().pixel(view().tint().rect().center()))); }

private slots:
    void strokesArePaintedErasedAndUndoneOneByOne()
    {
        open(modelled());
        beginPainting();
        stroke({0.3, 0.5}, {0.7, 0.5});
        QCOMPARE(entry().completions.size(), 1U);
        QCOMPARE(completion().frame, (NamedFrame{"slow", FrameIndex(0)}));
        QCOMPARE(completion().strokes.size(), 1U);
        QVERIFY(tinted() > 0);
        auto* tool = find<QComboBox>("maskTool");
        tool->setFocus();
        QTest::keyClick(tool, Qt::Key_Down);
        QVERIFY(view().brush()->erases);
        stroke({0.4, 0.5}, {0.6, 0.5});
        QCOMPARE(completion().strokes.size(), 2U);
        QVERIFY(completion().strokes.back().erases);
        QCOMPARE(tinted(), 0);
        QVERIFY(marked(completion().strokes) < marked({completion().strokes.front()}));
        document().undo();
        QCOMPARE(completion().strokes.size(), 1U);
        QVERIFY(tinted() > 0);
        document().undo();
        QVERIFY(entry().completions.empty());
        document().redo();
        QCOMPARE(completion().strokes.size(), 1U);
        press("tool.appearance.clearMask");
        QVERIFY(completion().strokes.empty());
        document().undo();
        QCOMPARE(completion().strokes.size(), 1U);
    }

    void theBrushIsMovedAndPressedByKeys()
    {
        open(modelled());
        beginPainting();
        view().setFocus();
        const QPointF before = view().brushPlace();
        QTest::keyClick(&view(), Qt::Key_Right);
        QTest::keyClick(&view(), Qt::Key_Up);
        QVERIFY(view().brushPlace().x() > before.x() && view().brushPlace().y() > before.y());
        QTest::keyClick(&view(), Qt::Key_Space);
        QCOMPARE(completion().strokes.size(), 1U);
        auto* size = find<QSlider>("maskSize");
        size->setFocus();
        QTest::keyClick(size, Qt::Key_End);
        QVERIFY(view().brush()->radius > completion().strokes.front().radius);
        // Escape takes back what is being painted.
        view().setFocus();
        QTest::mousePress(&view(), Qt::LeftButton, {}, at(0.2, 0.2));
        QTest::keyClick(&view(), Qt::Key_Escape);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, at(0.2, 0.2));
        QCOMPARE(completion().strokes.size(), 1U);
    }

    void aChartIsFilled()
    {
        open(modelled());
        beginPainting();
        auto* tool = find<QComboBox>("maskTool");
        tool->setFocus();
        QTest::keyClick(tool, Qt::Key_Down);
        QTest::keyClick(tool, Qt::Key_Down);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, at(0.5, 0.5));
        QTRY_VERIFY(!entry().completions.empty());
        // The chart has 56 × 56 texels; strokes reach no farther than its gutter.
        const int texels = marked(completion().strokes);
        QVERIFY2(texels >= 56 * 56 && texels <= 60 * 60, qPrintable(QString::number(texels)));
        document().undo();
        QVERIFY(entry().completions.empty());
    }

    void framesAreAddedGoneToAndTakenOut()
    {
        open(modelled());
        Workspace::showPanel(find<QWidget>("masksPanel"));
        workspace().player().goTo(4);
        QTRY_VERIFY(action("appearance.addCompletion")->isEnabled());
        press("tool.appearance.addCompletion");
        context().selection.selectSequences({"quick"});
        QTRY_VERIFY(action("appearance.addCompletion")->isEnabled());
        press("tool.appearance.addCompletion");
        QCOMPARE(entry().completions.size(), 2U);
        auto* list = find<QListWidget>("maskList");
        QCOMPARE(list->count(), 2);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
        QTRY_COMPARE(workspace().appearance().frame(), std::optional(NamedFrame{"slow", FrameIndex(4)}));
        list->setFocus();
        for (const int key : {Qt::Key_End, Qt::Key_Home}) {
            QKeyEvent event(QEvent::ShortcutOverride, key, Qt::NoModifier);
            event.ignore();
            QApplication::sendEvent(list, &event);
            QVERIFY(event.isAccepted()); // else it is for playing
            QTest::keyClick(list, static_cast<Qt::Key>(key));
            QCOMPARE(list->currentRow(), key == Qt::Key_End ? 1 : 0);
        }
        press("tool.appearance.removeCompletion");
        QCOMPARE(entry().completions.size(), 1U);
        QCOMPARE(completion().frame.sequence, std::string("quick"));
    }

    void whatIsMaskedIsFilledIn()
    {
        // A texture with a white patch, which no other has.
        QImage patched = pattern(2.5 * std::sin(0.35 * 4));
        for (int y = 24; y < 36; ++y) {
            for (int x = 24; x < 36; ++x)
                patched.setPixel(x, y, qRgb(255, 255, 255));
        }
        patched.save(m_folder->filePath("looks/slow/0004.png"));
        open(modelled());
        workspace().player().goTo(4);
        beginPainting();
        for (const double v : {0.60, 0.56, 0.52, 0.48, 0.45})
            stroke({0.38, v}, {0.56, v});
        press("tool.appearance.paint");
        press("tool.appearance.complete");
        QTRY_COMPARE(phase(), ResultPhase::Ready);
        QTRY_VERIFY(!pair().second.image.isNull() && shown().mode() == TextureMode::Swipe);
        QVERIFY(qRed(pair().first.image.pixel(30, 30)) > 250);
        QVERIFY(qRed(pair().second.image.pixel(30, 30)) < 240);
        QCOMPARE(pair().second.image.pixel(10, 50), pair().first.image.pixel(10, 50));
        QTRY_COMPARE(workspace().scene().textureOf("slow"), pair().second.image);
    }

    void theTextureBetweenTwoFramesIsComparedWithABlend()
    {
        build();
        const auto heightOfEnd = [this] {
            const MeshSequence dressed = shown().dressed(*context().media.sequence("quick"));
            return dressed.frame(FrameIndex(2)).positions().back().y();
        };
        const float heightOfLast = heightOfEnd();
        QVERIFY(heightOfLast > 3);
        Workspace::showPanel(find<QWidget>("betweenPanel"));
        QTest::mouseClick(find<QPushButton>("betweenFromTake"), Qt::LeftButton);
        QCOMPARE(shown().content(), TextureContent::Between);
        QVERIFY(!find<QSlider>("betweenWeight")->isEnabled());
        context().selection.selectSequences({"quick"});
        QTRY_COMPARE(workspace().scene().shown(), QStringList{"quick"});
        QTRY_COMPARE(workspace().scene().frameCount(), std::int64_t{frames});
        workspace().player().goTo(2);
        QTest::mouseClick(find<QPushButton>("betweenToTake"), Qt::LeftButton);
        QCOMPARE(find<QLabel>("betweenToFrame")->text(), QString("quick 2"));
        QTRY_VERIFY(!view().other().isNull());
        auto* weight = find<QSlider>("betweenWeight");
        QVERIFY(weight->isEnabled());
        weight->setFocus();
        QTest::keyClick(weight, Qt::Key_Home);
        QCOMPARE(find<QSpinBox>("betweenPercent")->value(), 0);
        // At its ends both are what was captured.
        QTRY_COMPARE(pair().second.image.convertToFormat(QImage::Format_RGB32), pattern(0));
        QTRY_COMPARE(pair().first.image.convertToFormat(QImage::Format_RGB32), pattern(0));
        shown().setWeight(0.5);
        QTRY_VERIFY(pair().second.image != pair().first.image);
        QTRY_COMPARE(workspace().scene().textureOf("quick"), pair().second.image);
        QVERIFY(heightOfEnd() > 0.3F * heightOfLast && heightOfEnd() < 0.7F * heightOfLast);
        shown().setWeight(0);
        QCOMPARE(heightOfEnd(), 0.0F);
        shown().setContent(TextureContent::Frame);
        QCOMPARE(heightOfEnd(), heightOfLast);
        QTest::mouseClick(find<QPushButton>("betweenFromShow"), Qt::LeftButton);
        QTRY_COMPARE(workspace().appearance().frame(), std::optional(NamedFrame{"slow", FrameIndex(0)}));
    }

    void qualityIsComputedAndDrawnOverTheComponents()
    {
        Project project = modelled();
        project.characters = {{.name = "card", .mesh = m_folder->filePath("slow/f_0.obj").toStdString()}};
        open(project);
        press("tool.appearance.build");
        QTRY_COMPARE(phase(), ResultPhase::Ready);
        auto* chart = find<widgets::LineChart>("qualityChart");
        QTRY_VERIFY(!chart->isEmpty()); // of the explained variance
        auto* what = find<QComboBox>("qualityWhat");
        what->setCurrentIndex(what->findData(QStringLiteral("fig17")));
        QCOMPARE(what->currentIndex(), 1);
        QVERIFY(chart->isEmpty());
        find<QPushButton>("qualityCompute")->click();
        QCOMPARE(document().project().evaluations.size(), 1U);
        QTRY_COMPARE(chart->series().size(), 4U); // textures and pictures, ours and naive
        QVERIFY(find<QPushButton>("qualityCompute")->isHidden());
        document().undoStack()->undo();
        QVERIFY(document().project().evaluations.empty());
    }

    void aSessionKeepsWhatIsShown()
    {
        open(modelled());
        document().saveAs(m_folder->filePath("p.quadrille").toStdString());
        QTRY_COMPARE(phase(), ResultPhase::Stale);
        press("tool.appearance.build");
        QTRY_COMPARE(phase(), ResultPhase::Ready);
        workspace().player().goTo(5);
        shown().setMode(TextureMode::Swipe);
        shown().setUsed(3);
        m_window->close();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->open({m_folder->filePath("p.quadrille")});
        QTRY_COMPARE(m_window->workspaces().current(), QString("appearance"));
        QCOMPARE(shown().mode(), TextureMode::Swipe);
        QTRY_COMPARE(workspace().appearance().frame(), std::optional(NamedFrame{"slow", FrameIndex(5)}));
        QTRY_COMPARE(phase(), ResultPhase::Ready);
        QCOMPARE(shown().used(), 3);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::AppearanceMasksTest);
#include "tst_appearancemasks.moc"
