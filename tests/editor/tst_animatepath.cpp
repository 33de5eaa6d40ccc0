// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Paths of animations: drawn and edited in the view, followed by a clip.
#include "editor/commands/projectedits.h"
#include "editor/workspaces/animate/pathentries.h"
#include "model/project/document/pathcurve.h"
#include "model/synthesis/walks/pathfollowing.h"
#include "pathfixture.h"
#include "tests/qt/viewapplication.h"
#include "widgets/theme/theme.h"
#include "widgets/tools/pathgeometry.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTableWidget>

namespace quadrille {

class AnimatePathTest : public QObject, private test::PathFixture
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        test::isolate();
        QVERIFY(widgets::VtkView::openGlAvailable());
    }

    void init() { open(); }
    void cleanup() { close(); }

    void aDrawnPathWithADemandedLabelBecomesAClip()
    {
        const Project before = document().project();
        QTest::mouseClick(test::find<QPushButton>("drawPath"), Qt::LeftButton);
        QCOMPARE(tool().editor().mode(), widgets::PathEditor::Mode::Draw);
        click(pixel(0, 0));
        click(pixel(0.1, 0.6));
        click(pixel(0, 1.2));
        QTest::keyClick(viewport().view(), Qt::Key_Return);
        QCOMPARE(document().project().animations.size(), 1U);
        QCOMPARE(path().points.size(), 3U);
        QVERIFY((path().points[1] - Vec3d(0.1, 0, 0.6)).norm() < 0.02);

        press("panel.animate.path.span");
        auto* frames = test::find<QComboBox>("spanFrames");
        QTRY_VERIFY(frames->isVisible());
        frames->setFocus();
        QTest::keyClicks(frames, "lean");
        QCOMPARE(path().spans.size(), 1U);
        QVERIFY(path().spans[0].frames.has_value());
        QCOMPARE(path().spans[0].frames->label, std::string("lean"));

        QVERIFY(test::waitForResult(m_window->context(), m_window->animate().animation().name()));
        const auto result = m_window->animate().animation().result();
        QCOMPARE(result->walk.solution.spans.size(), 1U);
        QVERIFY(!result->walk.constraints.path->spans[0].demanded->spans.empty());
        auto* deviation = test::find<QLabel>("pathResult");
        QTRY_VERIFY2(deviation->text().contains("cm"), qPrintable(deviation->text()));
        QTRY_VERIFY(test::find<QLabel>("spanObtained")->text().contains("m/s"));

        while (document().canUndo())
            document().undo();
        QCOMPARE(document().project(), before);
        QVERIFY(tool().editor().shape().points.empty());
        while (document().undoStack()->canRedo())
            document().redo();
        QCOMPARE(path().points.size(), 3U);
        QCOMPARE(path().spans[0].frames->label, std::string("lean"));
    }

    void aProjectInCentimetresHasItsStepsAndNumbers()
    {
        Project project = document().project();
        project.settings.axes.metresPerUnit = 0.01;
        document().reset(project);
        m_window->context().actions.action("workspace.animate")->trigger();
        QCOMPARE(viewport().ruler().metresPerUnit(), 0.01);
        m_window->context().actions.action("animate.new")->trigger();
        PathEntry path;
        path.points = {{0, 0, 0}, {0, 0, 50}, {0, 0, 100}};
        path.spans = {{.from = 25, .to = 75}};
        path.obstacles = {{.corners = {{60, 60}}, .radius = 20}};
        addPath(path);
        auto* length = test::find<QLabel>("pathLength");
        QTRY_COMPARE(length->text(), QLocale().toString(100) + " cm");
        auto* clearance = test::find<QDoubleSpinBox>("pathClearance");
        QCOMPARE(clearance->suffix(), QStringLiteral(" cm"));
        QCOMPARE(clearance->singleStep(), 5.0);
        QCOMPARE(clearance->decimals(), 0);
        auto* points = test::find<QTableWidget>("pathPoints");
        QCOMPARE(points->item(1, 1)->data(Qt::EditRole).toDouble(), 50.0);
        tool().editor().setSelected({Kind::Point, 1, 0});
        viewport().setFocus();
        QTest::keyClick(viewport().view(), Qt::Key_Down);
        QVERIFY2((tool().path()->points[1] - Vec3d(0, 0, 60)).norm() < 1e-6, "ten centimetres");
        QTest::keyClick(viewport().view(), Qt::Key_Down, Qt::ControlModifier);
        QVERIFY2((tool().path()->points[1] - Vec3d(0, 0, 61)).norm() < 1e-6, "one centimetre");
        tool().editor().setSelected({Kind::StretchEnd, 0, 0});
        auto* to = test::find<QDoubleSpinBox>("spanTo");
        QTRY_VERIFY(to->isVisible());
        QCOMPARE(to->singleStep(), 10.0);
        // What the hand does not mean is not in the file: tenths of a millimetre.
        const PathSpace space{.ground = 0, .metresPerUnit = 0.01};
        QCOMPARE(space.fromView({12.345678F, 0, 0.001F}, false), Vec3d(12.35, 0, 0));
    }

    void theViewKeepsItsSizeUnderThePen()
    {
        auto* draw = test::find<QPushButton>("drawPath");
        QWidget& view = *viewport().view();
        QTest::qWait(50);
        const QSize before = view.size();
        QTest::mouseClick(draw, Qt::LeftButton);
        QTest::qWait(50);
        QCOMPARE(view.size(), before);
        for (const double x : {0.3, 0.5, 0.6}) {
            QTest::mouseClick(&view, Qt::LeftButton, {},
                              QPoint(static_cast<int>(x * view.width()), view.height() * 2 / 3));
            QTest::qWait(50);
            QCOMPARE(view.size(), before);
        }
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(test::waitForResult(m_window->context(), m_window->animate().animation().name()));
        QTest::qWait(50);
        QCOMPARE(view.size(), before);
    }

    void theDeviationIsThatOfTheSearch()
    {
        PathEntry curved = straight();
        curved.spans.clear();
        curved.points[1] = {0.15, 0, 0.5};
        addPath(curved);
        const QString name = m_window->animate().animation().name();
        QVERIFY(test::waitForResult(m_window->context(), name));
        const auto result = m_window->animate().animation().result();
        const auto frames = followPath(*result->walk.constraints.path, result->plan);
        double sum = 0;
        double greatest = 0;
        for (const FollowedFrame& frame : frames) {
            sum += frame.deviation;
            greatest = std::max(greatest, frame.deviation);
        }
        // The search adds lengths in single precision.
        QVERIFY(std::abs(sum / static_cast<double>(frames.size()) - result->walk.solution.meanDeviation) <
                1e-3);
        QVERIFY(std::abs(greatest - result->walk.solution.greatestDeviation) < 1e-3);
    }

    void theFigureWalksOnItsPathWhereverThatBegins()
    {
        PathEntry far = straight();
        far.spans.clear();
        for (Vec3d& point : far.points)
            point += Vec3d(-1.43, 0, 1.88);
        addPath(far);
        const QString name = m_window->animate().animation().name();
        QVERIFY(test::waitForResult(m_window->context(), name));
        const MeshSequence& clip = m_window->animate().animation().result()->sequence;
        ClipScene& scene = m_window->animate().scene();
        m_window->animate().player().goTo(3);
        QTRY_COMPARE(scene.frame(), FrameIndex(3));
        const Frame wanted = clip.frame(FrameIndex(3));
        const auto isThere = [&] {
            const auto shape = viewport().figureShape(scene.figureOf(name));
            const Vec3f& first = wanted.positions()[0];
            return (shape->place(0) - QVector3D(first.x(), first.y(), first.z())).length() < 1e-4F;
        };
        QTRY_VERIFY(isThere());
        // Its body is near the beginning of the path, not beside it.
        Vec3f centre = Vec3f::Zero();
        const auto shape = viewport().figureShape(scene.figureOf(name));
        for (std::uint32_t v = 0; v < shape->mesh.vertexCount; ++v)
            centre += Vec3f(shape->place(v).x(), 0, shape->place(v).z());
        centre /= static_cast<float>(shape->mesh.vertexCount);
        QVERIFY2((centre - Vec3f(-1.43F, 0, 1.88F)).norm() < 0.5F,
                 qPrintable(QString("%1 %2").arg(centre.x()).arg(centre.z())));
    }

    void aDragIsOneUndoStepAndEscapeIsNone()
    {
        addPath(straight());
        const int steps = document().undoStack()->count();
        const PathEntry before = path();
        const QPoint from = pixel({Kind::Point, 1, 0});
        QWidget* view = viewport().view();
        QTest::mousePress(view, Qt::LeftButton, {}, from);
        for (int step = 1; step <= 5; ++step)
            QTest::mouseMove(view, from + QPoint(12 * step, 0));
        QVERIFY(path().points[1].x() > 0.2);
        QTest::keyClick(view, Qt::Key_Escape);
        QTest::mouseRelease(view, Qt::LeftButton, {}, from + QPoint(60, 0));
        QCOMPARE(document().undoStack()->count(), steps);
        QCOMPARE(path(), before);

        QTest::mousePress(view, Qt::LeftButton, {}, from);
        for (int step = 1; step <= 5; ++step)
            QTest::mouseMove(view, from + QPoint(12 * step, 0));
        QTest::mouseRelease(view, Qt::LeftButton, {}, from + QPoint(60, 0));
        QCOMPARE(document().undoStack()->count(), steps + 1);
        QCOMPARE(path().points[0], before.points[0]);
        QCOMPARE(path().points[1].y(), 0.0);
        QVERIFY(path().points[1].x() > 0.2);
        // The span keeps to the points that it was between: halfway before and halfway behind the middle one.
        QVERIFY(std::abs((path().spans[0].from + path().spans[0].to) / 2 - tool().length() / 2) < 0.02);
        document().undo();
        QCOMPARE(path(), before);
    }

    void undoingWhileDraggingIsSafe()
    {
        addPath(straight());
        PathEntry more = straight();
        more.spans.push_back({.from = 0.8, .to = 1});
        tool().edit("more", "more", [&](PathEntry& path) { path = more; });
        const QPoint from = pixel({Kind::StretchEnd, 1, 0});
        QWidget* view = viewport().view();
        QTest::mousePress(view, Qt::LeftButton, {}, from);
        QTest::mouseMove(view, from + QPoint(0, -10));
        while (document().canUndo())
            document().undo();
        QTest::mouseMove(view, from + QPoint(0, -20));
        QTest::mouseRelease(view, Qt::LeftButton, {}, from + QPoint(0, -20));
        QVERIFY(tool().path() == nullptr);
    }

    void theMenuOfTheCurveInsertsAPoint()
    {
        addPath(straight());
        QTest::mouseClick(viewport().view(), Qt::RightButton, {}, pixel(0, 0.35));
        auto* menu = test::find<QMenu>("pathMenu");
        QTRY_VERIFY(menu->isVisible());
        QTest::keyClick(menu, Qt::Key_Down);
        QTest::keyClick(menu, Qt::Key_Return);
        QCOMPARE(path().points.size(), 4U);
        QVERIFY((path().points[1] - Vec3d(0, 0, 0.35)).norm() < 0.02);
        QTest::mouseClick(viewport().view(), Qt::RightButton, {}, pixel({Kind::Point, 1, 0}));
        menu = nullptr;
        for (QWidget* top : QApplication::topLevelWidgets())
            if (auto* shown = qobject_cast<QMenu*>(top); shown != nullptr && shown->isVisible())
                menu = shown;
        QVERIFY(menu != nullptr);
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(menu->actions().front()).center());
        QCOMPARE(path(), straight());
    }

    void pathsLieOnTheGroundOfTheProject()
    {
        ProjectSettings settings = document().project().settings;
        settings.axes.up = UpAxis::Z;
        setSettings(document(), settings);
        QTRY_COMPARE(viewport().camera().upAxis, widgets::UpAxis::Z);
        QTest::mouseClick(test::find<QPushButton>("drawPath"), Qt::LeftButton);
        widgets::Turntable camera = viewport().camera();
        camera.target = {0, 0, viewport().groundHeight()};
        camera.distance = 6;
        viewport().setCamera(camera);
        const auto at = [&](float x, float y) {
            QPointF place;
            camera.project({x, y, viewport().groundHeight()}, viewport().view()->size(), &place);
            return place.toPoint();
        };
        click(at(0, 0));
        click(at(1, 0.5F));
        QCOMPARE(path().points.size(), 2U);
        QVERIFY((path().points[1] - Vec3d(1, 0.5, 0)).norm() < 0.03);
        QCOMPARE(path().points[1].z(), 0.0);
        QCOMPARE(test::find<QTableWidget>("pathPoints")->horizontalHeaderItem(1)->text(), QString("y (m)"));
    }

    void aHiddenPathIsLeftAlone()
    {
        addPath(straight());
        QAction* shown = m_window->context().actions.action("animate.path.show");
        shown->trigger();
        const PathEntry before = path();
        const QPoint from = pixel({Kind::Point, 1, 0});
        QTest::mousePress(viewport().view(), Qt::LeftButton, {}, from);
        QTest::mouseMove(viewport().view(), from + QPoint(40, 0));
        QTest::mouseRelease(viewport().view(), Qt::LeftButton, {}, from + QPoint(40, 0));
        QCOMPARE(path(), before);
        press("panel.animate.path.draw");
        QVERIFY(shown->isChecked());
    }

    void anotherAnimationEndsDrawing()
    {
        addPath(straight());
        const QString first = m_window->animate().animation().name();
        press("panel.animate.path.draw");
        QCOMPARE(tool().editor().mode(), widgets::PathEditor::Mode::Draw);
        m_window->animate().animation().add();
        QCOMPARE(tool().editor().mode(), widgets::PathEditor::Mode::Edit);
        QVERIFY(tool().editor().shape().points.empty());
        m_window->context().selection.selectAnimations({first});
        QCOMPARE(tool().editor().shape().points.size(), 3U);
    }

    void obstaclesAreDrawnInTheView()
    {
        addPath(straight());
        press("panel.animate.path.disc");
        const QPoint middle = pixel(0.6, 0.5);
        QTest::mousePress(viewport().view(), Qt::LeftButton, {}, middle);
        QTest::mouseMove(viewport().view(), pixel(0.7, 0.5));
        QTest::mouseMove(viewport().view(), pixel(0.8, 0.5));
        QTest::mouseRelease(viewport().view(), Qt::LeftButton, {}, pixel(0.8, 0.5));
        QCOMPARE(path().obstacles.size(), 1U);
        QVERIFY((path().obstacles[0].corners[0] - Vec2d(0.6, 0.5)).norm() < 0.02);
        QVERIFY(std::abs(path().obstacles[0].radius - 0.2) < 0.02);
        auto* radius = test::find<QDoubleSpinBox>("obstacleRadius");
        QVERIFY(radius->isVisible());
        QVERIFY(test::find<QDoubleSpinBox>("pathClearance")->isVisible());
        // Where an end of the path is too close, it says so.
        QVERIFY(tool().editor().shape().obstacles[0].problem.isEmpty());
        radius->setValue(0.9);
        QVERIFY(!tool().editor().shape().obstacles[0].problem.isEmpty());
        QTest::keyClick(viewport().view(), Qt::Key_Delete);
        QVERIFY(path().obstacles.empty());
    }

    void kindsOfCurvesChangeIntoEachOther()
    {
        addPath(straight());
        tool().setCurve(PathCurve::Bezier);
        QCOMPARE(path().points.size(), 7U);
        QCOMPARE(tool().editor().shape().kind, widgets::PathKind::Bezier);
        tool().setCurve(PathCurve::Polyline);
        QCOMPARE(path().points, straight().points);
        press("panel.animate.path.close");
        QVERIFY(isClosed(path()));
        QVERIFY(!m_window->context().actions.action("animate.path.close")->isEnabled());
        document().undo();
        press("panel.animate.path.reverse");
        QCOMPARE(path().points.front(), Vec3d(0, 0, 1));
        press("panel.animate.path.remove");
        QVERIFY(tool().path() == nullptr);
        QVERIFY(test::find<QPushButton>("drawPath")->isVisible());
    }

    void theDrawnCurveIsTheOneThatIsFollowed()
    {
        PathEntry curved = straight();
        curved.points = {{0, 0, 0}, {1, 0, 1}, {-0.5, 0, 2}, {0, 0, 3}};
        for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
            const PathSpace space{.up = up, .ground = -0.9F};
            for (const PathCurve curve : {PathCurve::CatmullRom, PathCurve::Polyline, PathCurve::Bezier}) {
                const PathEntry path = withCurve(curved, curve, 1);
                const auto drawn = space.sampler()(kindOf(curve), space.toView(path.points, false));
                const auto followed = space.toView(curveOf(path, 1), false);
                QCOMPARE(drawn.size(), followed.size());
                for (std::size_t i = 0; i < drawn.size(); ++i)
                    QVERIFY((drawn[i] - followed[i]).length() < 1e-5F);
            }
        }
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST_IN(quadrille::test::ViewApplication, quadrille::AnimatePathTest);

#include "tst_animatepath.moc"
