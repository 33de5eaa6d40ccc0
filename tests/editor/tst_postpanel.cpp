// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The settings of an animation, by mouse and keys, and what becomes of its clip.
#include "animatedproject.h"
#include "editor/commands/animationedits.h"
#include "editor/commands/projectedits.h"
#include "editor/commands/variationedits.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "tests/qt/registry.h"
#include "variedproject.h"
#include "widgets/charts/curveeditor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>

namespace quadrille {

class PostPanelTest : public QObject
{
    Q_OBJECT

private:
    template <typename Widget>
    Widget* field(const char* name)
    {
        auto* found = m_panel->findChild<Widget*>(QLatin1String(name));
        if (found == nullptr)
            QTest::qFail(name, __FILE__, __LINE__);
        return found;
    }
    void type(const char* name, const QString& text)
    {
        auto* spin = field<QDoubleSpinBox>(name);
        spin->setFocus();
        spin->selectAll();
        QTest::keyClicks(spin, text);
        QTest::keyClick(spin, Qt::Key_Return);
    }
    void toggle(const char* name)
    {
        auto* box = field<QCheckBox>(name);
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    }
    void choose(const char* name, int index)
    {
        auto* box = field<QComboBox>(name);
        box->setFocus();
        while (box->currentIndex() != index)
            QTest::keyClick(box, box->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
    }
    EditorContext& context() { return m_window->context(); }
    const AnimationEntry& entry() { return *context().document.animation("dance"); }
    PostProcessing steps() { return entry().post.steps; }
    std::int64_t clipFrames() { return context().animations.result("dance")->sequence.frameCount(); }
    bool waitForResult() { return test::waitForResult(context(), "dance"); }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    QWidget* m_panel = nullptr;

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
        m_panel = test::find<QWidget>("postPanel");
        m_window->resize(1000, 1500);
        test::find<QDockWidget>("finishDock")->raise();
        QVERIFY(test::activate(*m_window));
        QVERIFY(waitForResult());
    }

    void cleanup()
    {
        context().document.reset({});
        m_window.reset();
    }

    void saysWhatBelongsHereWhileThereIsNoAnimation()
    {
        auto* empty = field<QLabel>("postEmpty");
        QVERIFY(!empty->isVisible());
        removeEntries(context().document, Section::Animations, {"dance"});
        QVERIFY(empty->isVisible());
        QVERIFY(!field<QCheckBox>("postLoop")->isVisible());
        QTest::mouseClick(field<QToolButton>("postNew"), Qt::LeftButton);
        QCOMPARE(context().document.project().animations.size(), 1U);
        QVERIFY(field<QCheckBox>("postLoop")->isVisible());
    }

    void buttonsThatResetAreWholeWhereThePanelIsNarrow()
    {
        toggle("postLoop");
        choose("postRetime", 1);
        auto* dock = test::find<QDockWidget>("finishDock");
        dock->setFloating(true);
        auto* area = m_panel->findChild<QScrollArea*>();
        for (const QString& language : {QStringLiteral("fr"), QStringLiteral("en")}) {
            context().languages.setLanguage(language);
            dock->resize(1, 500);
            QTRY_VERIFY(dock->width() < 500);
            int shown = 0;
            for (const auto* button : m_panel->findChildren<QToolButton*>()) {
                if (!button->objectName().endsWith("Reset") || !button->isVisible())
                    continue;
                ++shown;
                const int right = button->mapTo(area->widget(), QPoint(button->width(), 0)).x();
                QTRY_VERIFY2(right <= area->viewport()->width(), qPrintable(language + button->objectName()));
            }
            QVERIFY(shown >= 2);
        }
    }

    void loopsAndRepeatsInStepsThatCanBeUndone()
    {
        const std::int64_t once = clipFrames();
        auto* repeats = field<QDoubleSpinBox>("postRepeats");
        auto* why = field<QLabel>("postRepeatsProblem");
        QVERIFY(!repeats->isEnabled());
        QVERIFY(why->isVisible() && why->text().contains("loop"));
        QVERIFY(!field<QDoubleSpinBox>("postCutStart")->isVisible());

        toggle("postLoop");
        QVERIFY(steps().loop.has_value());
        QVERIFY(repeats->isEnabled() && !why->isVisible());
        QVERIFY(field<QDoubleSpinBox>("postCutStart")->isVisible());
        QVERIFY(waitForResult());
        const std::int64_t cycle = clipFrames();
        type("postRepeats", "3");
        QCOMPARE(steps().repeats, 3);
        QVERIFY(waitForResult());
        QCOMPARE(clipFrames(), 3 * cycle);
        type("postCutEnd", "0.5");
        QCOMPARE(steps().loop->cutEnd->value, 0.5);
        QVERIFY(!steps().loop->cutStart.has_value());
        toggle("postInPlace");
        QVERIFY(steps().loop->inPlace);

        auto& document = context().document;
        QVERIFY(document.undoStack()->undoText().contains("Stay in place"));
        for (int i = 0; i < 4; ++i)
            document.undo();
        QVERIFY(!steps().loop.has_value());
        QVERIFY(!field<QCheckBox>("postLoop")->isChecked());
        QVERIFY(waitForResult());
        QCOMPARE(clipFrames(), once);
        for (int i = 0; i < 4; ++i)
            document.redo();
        QCOMPARE(steps().repeats, 3);
        // Without a loop there are no repeats either, in one step.
        toggle("postLoop");
        QCOMPARE(steps().repeats, 1);
    }

    void everyValueGoesBackToTheUsual()
    {
        auto* reset = field<QToolButton>("postStrengthReset");
        QVERIFY(!reset->isVisible());
        type("postStrength", "40");
        QVERIFY(std::abs(steps().contacts->strength - 0.4) < 1e-12);
        type("postTurn", "45");
        QVERIFY(std::abs(steps().contacts->greatestTurn - std::numbers::pi / 4) < 1e-9);
        QVERIFY(reset->isVisible());
        QTest::mouseClick(reset, Qt::LeftButton);
        QCOMPARE(steps().contacts->strength, 1.0);
        QVERIFY(!reset->isVisible());
        QVERIFY(field<QToolButton>("postTurnReset")->isVisible());
        context().document.undo();
        QVERIFY(reset->isVisible());
        QCOMPARE(field<QDoubleSpinBox>("postStrength")->value(), 40.0);
    }

    void retimesByFactorDurationAndCurve()
    {
        const std::int64_t once = clipFrames();
        const double fps = context().document.project().settings.fps;
        choose("postRetime", 1);
        type("postFactor", "2");
        QVERIFY(waitForResult());
        QCOMPARE(clipFrames(), 2 * (once - 1) + 1);
        choose("postRetime", 2);
        QCOMPARE(std::get<Seconds>(steps().retime->time).value, static_cast<double>(once - 1) / fps);
        type("postDuration", "1");
        QVERIFY(waitForResult());
        QCOMPARE(clipFrames(), static_cast<std::int64_t>(fps) + 1);

        choose("postRetime", 3);
        auto* curve = field<widgets::CurveEditor>("postCurve");
        QVERIFY(curve->isVisible());
        QVERIFY(waitForResult());
        QCOMPARE(clipFrames(), once);
        const int steps0 = context().document.undoStack()->index();
        const double length = static_cast<double>(once - 1) / fps;
        const auto drag = [curve](const QPointF& from, const QPointF& to) {
            const QPoint start = curve->positionOf(from).toPoint();
            const QPoint end = curve->positionOf(to).toPoint();
            QTest::mousePress(curve, Qt::LeftButton, {}, start);
            QTest::mouseMove(curve, (start + end) / 2);
            QTest::mouseMove(curve, end);
            QTest::mouseRelease(curve, Qt::LeftButton, {}, end);
        };
        drag({length, length}, {1.15 * length, length});
        QCOMPARE(context().document.undoStack()->index(), steps0 + 1);
        const auto points = std::get<RetimeSettings::Curve>(steps().retime->time);
        QVERIFY(points.back().output.value > 1.05 * length);
        QCOMPARE(points.back().clip.value, length);
        QVERIFY(waitForResult());
        QVERIFY(clipFrames() > once);
        // Editing by hand goes on where undo leaves the curve.
        context().document.undo();
        QCOMPARE(curve->points().back().x(), length);
        QVERIFY(waitForResult());
        QCOMPARE(clipFrames(), once);
    }

    void drawsWhatIsShownAgainFromVariations()
    {
        // The first take is shown from 2 to 18, and once more from 10 on.
        AnimationEntry twice = entry();
        twice.constraints.clear();
        twice.walk.emplace();
        for (const int first : {2, 10})
            twice.walk->spans.push_back({"first", {FrameIndex(first), FrameIndex(18)}});
        GraphEntry graph = GraphEntry::paper(); // its windows have room before frame 10
        graph.character = "spire";
        setGraph(context().document, "Windows", "durations", graph);
        setAnimation(context().document, "dance", "Twice", "walk", twice);
        QVERIFY(waitForResult());
        const std::int64_t frames = clipFrames();
        const auto shown = [this] { return context().animations.result("dance"); };
        const auto last = [&] {
            const Frame frame = shown()->sequence.frame(FrameIndex(frames - 1));
            return std::vector<Vec3f>(frame.positions().begin(), frame.positions().end());
        };
        const std::vector<Vec3f> captured = last();

        auto* box = field<QComboBox>("postVariations");
        auto* problem = field<QLabel>("postVariationsProblem");
        QCOMPARE(box->count(), 2);
        QVERIFY(!problem->isVisible() && !field<QDoubleSpinBox>("postVariationEase")->isVisible());
        choose("postVariations", 1);
        QVERIFY(entry().post.variations && entry().post.variations->from.empty());
        QVERIFY(problem->isVisible() && problem->text().contains("no variations"));
        context().document.undo();
        QVERIFY(!problem->isVisible());
        QCOMPARE(box->currentIndex(), 0);

        addVariation(context().document, test::variedProject(m_folder.path()).variations.front());
        QCOMPARE(box->count(), 3);
        choose("postVariations", 2);
        QCOMPARE(entry().post.variations->from, std::string("sways"));
        QVERIFY(waitForResult());
        QVERIFY(!problem->isVisible());
        QCOMPARE(clipFrames(), frames);
        QVERIFY(!shown()->spans[0].variation && shown()->spans[1].variation == 0U);
        QCOMPARE(shown()->variationName(shown()->origins.back().destinationVariation),
                 std::string("sways/1"));
        QVERIFY(last() != captured);

        type("postVariationEase", "0.4");
        QCOMPARE(entry().post.variations->ease, 0.4);
        QVERIFY(renameEntry(context().document, {Section::Variations, "sways"}, "swings"));
        QCOMPARE(entry().post.variations->from, std::string("swings"));
        QVERIFY(box->currentText().contains("swings"));
        // Throwing the first one away draws from the second.
        VariationEntry fewer = context().document.project().variations.front();
        fewer.samples.front().discarded = {1};
        setVariation(context().document, "swings", "Discard", "discarded", fewer);
        QTRY_COMPARE(shown()->variationName(shown()->origins.back().destinationVariation),
                     std::string("swings/2"));

        choose("postVariations", 0);
        QVERIFY(!entry().post.variations);
        QVERIFY(waitForResult());
        QVERIFY(last() == captured);
        context().document.undo();
        QVERIFY(entry().post.variations.has_value());
    }

    void saysThatNothingIsShownAgain()
    {
        addVariation(context().document, test::variedProject(m_folder.path()).variations.front());
        choose("postVariations", 1);
        QVERIFY(waitForResult());
        auto* problem = field<QLabel>("postVariationsProblem");
        QVERIFY(problem->isVisible() && problem->text().contains("no frames again"));
    }

    void searchAndBlendingAreSettingsToo()
    {
        auto* beta = field<QDoubleSpinBox>("searchBeta");
        QCOMPARE(beta->text(), QString("10 α"));
        type("searchBeta", "0.5");
        QCOMPARE(entry().search.beta, std::optional(0.5));
        QTest::mouseClick(field<QToolButton>("searchBetaReset"), Qt::LeftButton);
        QVERIFY(!entry().search.beta.has_value());
        QCOMPARE(beta->text(), QString("10 α"));
        type("searchBudget", "5000");
        QCOMPARE(entry().search.budget, std::optional<std::int64_t>(5000));
        toggle("searchGlobal");
        QVERIFY(entry().search.globalKeys);
        choose("postBlend", 1);
        QVERIFY(entry().gentleBlend);
        choose("postInterpolation", 2);
        QVERIFY(entry().interpolation == InterpolationMethod::Linear);
    }

    void saysBesideMirrorWhatIsWrongWithTheSymmetry()
    {
        QVERIFY(!field<QPushButton>("postSymmetry")->isVisible());
        toggle("postMirror");
        QVERIFY(field<QPushButton>("postSymmetry")->isVisible());
        auto* problem = field<QLabel>("postMirrorProblem");
        QVERIFY(!problem->isVisible());
        const QString file = m_folder.filePath("symmetry.txt");
        std::ofstream(file.toStdString()) << "1\n0\n";
        AnimationEntry withFile = entry();
        withFile.post.symmetry = file.toStdString();
        setAnimation(context().document, "dance", "Symmetry", "symmetry", withFile);
        QCOMPARE(field<QPushButton>("postSymmetry")->text(), QString("symmetry.txt"));
        QTRY_VERIFY(problem->isVisible());
        QVERIFY(problem->text().contains("symmetry"));
        context().document.undo();
        QTRY_VERIFY(!problem->isVisible());
    }

    void followsItsAnimationThroughAnotherName()
    {
        QVERIFY(renameEntry(context().document, {Section::Animations, "dance"}, "waltz"));
        toggle("postLoop");
        QVERIFY(context().document.animation("waltz")->post.steps.loop.has_value());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::PostPanelTest);
#include "tst_postpanel.moc"
