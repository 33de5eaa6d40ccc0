// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The panel of body parts: what it proposes, shortens, renames and hangs elsewhere.
#include "bodypartsfixture.h"
#include "editor/docks/projecttreemodel.h"
#include "editor/documents/projectpaths.h"
#include "editor/workspaces/workspacetabs.h"
#include "model/sample/sample.h"
#include "tests/qt/viewapplication.h"

#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QTreeView>

namespace quadrille {

class BodyPartsPanelTest : public BodyPartsFixture
{
    Q_OBJECT

    /// Of a person who was captured; nothing where there are no captures.
    static std::optional<Project> capturedWalk()
    {
        const QDir data(QString::fromLocal8Bit(QUADRILLE_DATA_DIR "/characters/rb_m04"));
        if (!data.exists("mesh.obj"))
            return std::nullopt;
        Project project;
        project.characters = {{.name = "rb", .mesh = data.filePath("mesh.obj").toStdString()}};
        project.sequences.push_back(
            {.name = "walk", .character = "rb", .source = data.filePath("walk_1.pc2").toStdString()});
        return project;
    }

private slots:
    void partsOfARealBodyAreProposed()
    {
        const std::optional<Project> project = capturedWalk();
        if (!project)
            QSKIP("no captures here");
        document().reset(*project);
        QTRY_VERIFY(tool().surface().graph() != nullptr);
        const Project before = document().project();
        QTest::mouseClick(test::find<QPushButton>("proposeParts"), Qt::LeftButton);
        QTRY_VERIFY(!tool().isBusy());
        QCOMPARE(said("bodyPartsEmptyNotice"), QString());
        QCOMPARE(body().parts.size(), 5U);
        QCOMPARE(body().curves.size(), 8U);
        QVERIFY(tool().cut().problems.empty());
        QCOMPARE(tool().cut().parts.parts.size(), 5U);
        checkHistory(before);
    }

    void whatCannotBeProposedSaysWhy()
    {
        QTest::mouseClick(test::find<QPushButton>("proposeParts"), Qt::LeftButton);
        QTRY_VERIFY(!tool().isBusy());
        if (body().parts.empty())
            QVERIFY(!said("bodyPartsEmptyNotice").isEmpty());
    }

    void aCurveIsShortenedAndStaysAround()
    {
        run("variations.curve.draw");
        click(pixel(0.45F, 1.42F, 0.1F));
        click(pixel(0.55F, 1.38F, 0.1F));
        click(pixel(0.45F, 1.34F, 0.1F));
        key(Qt::Key_Return);
        const double before = tool().lengthOfCurve("curve");
        const Project drawn = document().project();
        run("variations.curve.shorten");
        const double after = tool().lengthOfCurve("curve");
        QVERIFY2(after < before, qPrintable(QStringLiteral("%1 %2").arg(before).arg(after)));
        QVERIFY(after > 0.5); // around the arm
        QVERIFY(tool().cut().problems.empty());
        checkHistory(drawn);
    }

    void theTreeRenamesAndRemovesByKeyboard()
    {
        drawOnArm(0.45F);
        run("variations.parts.add");
        auto* tree = test::find<QTreeWidget>("bodyPartsTree");
        tree->setFocus();
        tree->setCurrentItem(item("part"));
        QCOMPARE(tool().selected(), (PartSelection{PartSelection::Kind::Part, "part"}));
        const Project before = document().project();
        QTest::keyClick(tree, Qt::Key_F2);
        auto* editor = tree->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->setText("left arm");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(findPart(body(), "left arm") != nullptr);
        checkHistory(before);
        QTRY_VERIFY(item("left arm") != nullptr);
        tree->setCurrentItem(item("left arm"));
        const Project renamed = document().project();
        QTest::keyClick(tree, Qt::Key_Delete);
        QCOMPARE(body().parts.size(), 1U);
        QCOMPARE(body().curves.size(), 2U);
        checkHistory(renamed);
        QVERIFY(said("bodyPartsOffer").contains("curve 2"));
    }

    void aPartIsHungOnAnotherByItsForm()
    {
        drawOnArm(0.35F);
        run("variations.parts.add");
        drawOnArm(0.6F);
        run("variations.parts.add");
        QCOMPARE(body().parts.size(), 3U);
        QCOMPARE(findPart(body(), "part 2")->part.parent, std::string("part"));
        QVERIFY(tool().cut().problems.empty());
        tool().select({PartSelection::Kind::Part, "part"});
        auto* parent = test::find<QComboBox>("partParent");
        QTRY_VERIFY(parent->isVisible());
        const Project before = document().project();
        parent->setFocus();
        QTest::keyClicks(parent, "part 2");
        QCOMPARE(findPart(body(), "part")->part.parent, std::string("part 2"));
        checkHistory(before);
        QVERIFY(said("bodyPartsProblem").contains("part"));
    }

    void aPartTakesAnotherCurveByItsForm()
    {
        drawOnArm(0.35F);
        run("variations.parts.add");
        drawOnArm(0.6F);
        run("variations.parts.add");
        tool().select({PartSelection::Kind::Part, "part"});
        auto* second = test::find<QComboBox>("partSecondCurve");
        QTRY_VERIFY(second->isVisible());
        const std::vector<std::string> curves = findPart(body(), "part")->part.curves;
        const std::string other = findPart(body(), "part 2")->part.curves.front();
        QCOMPARE(second->currentText(), QString::fromStdString(curves[1]));
        QCOMPARE(second->count(), static_cast<int>(body().curves.size()));
        const Project before = document().project();
        second->setFocus();
        QTest::keyClicks(second, QString::fromStdString(other));
        QCOMPARE(findPart(body(), "part")->part.curves, (std::vector{curves[0], other}));
        checkHistory(before);
        tool().select({PartSelection::Kind::Curve, curves[0]});
        QVERIFY(!second->isVisible());
        QVERIFY(test::find<QLabel>("curvePoints")->isVisible());
        QVERIFY(test::find<QLabel>("curveLength")->text().contains("cm"));
    }

    void theShownPoseIsTaken()
    {
        m_window->variations().player().goTo(2);
        QTRY_COMPARE(m_window->variations().scene().frame(), FrameIndex(2));
        drawOnArm(0.45F);
        const Project before = document().project();
        QTest::mouseClick(test::find<QPushButton>("takePose"), Qt::LeftButton);
        QVERIFY(body().pose == (NamedFrame{.sequence = "stand", .frame = FrameIndex(2)}));
        checkHistory(before);
        QTRY_VERIFY(tool().surface().graph() != nullptr);
        QVERIFY(tool().cut().problems.empty());
    }

    void theWindowCanGoWhileACurveIsDrawn()
    {
        run("variations.curve.draw");
        click(pixel(0.45F, 1.4F, 0.1F));
        QTest::mouseMove(viewport().view(), pixel(0.5F, 1.32F, 0.1F));
        QCOMPARE(tool().editor().mode(), Mode::Draw);
        QCOMPARE(body().curves.size(), 1U);
    }

    void theViewShowsPartsOnlyWithThePanel()
    {
        drawOnArm(0.45F);
        run("variations.parts.add");
        QTRY_COMPARE(viewport().shading(), widgets::Shading::Scalar);
        m_window->context().actions.action("variations.parts.show")->setChecked(false);
        QVERIFY(!tool().editor().isActive());
        QVERIFY(viewport().shading() != widgets::Shading::Scalar);
        m_window->context().actions.action("variations.parts.show")->setChecked(true);
        QTRY_VERIFY(tool().editor().isActive());
        m_window->context().actions.action("workspace.sequences")->trigger();
        QTRY_VERIFY(!tool().editor().isActive());
        m_window->context().actions.action("workspace.variations")->trigger();
        QTRY_VERIFY(tool().editor().isActive());
        QTRY_COMPARE(viewport().shading(), widgets::Shading::Scalar);
    }

    void theMenuShowsThatPartsColourTheView()
    {
        drawOnArm(0.45F);
        run("variations.parts.add");
        QTRY_COMPARE(viewport().shading(), widgets::Shading::Scalar);
        ActionRegistry& actions = m_window->context().actions;
        QVERIFY(!actions.action("view.textured")->isChecked());
        actions.action("view.clay")->trigger();
        QCOMPARE(viewport().shading(), widgets::Shading::Clay);
        actions.action("view.textured")->trigger();
        actions.action("variations.parts.show")->setChecked(false);
        actions.action("variations.parts.show")->setChecked(true);
        QTRY_COMPARE(viewport().shading(), widgets::Shading::Scalar);
        QVERIFY(!actions.action("view.textured")->isChecked());
        actions.action("workspace.sequences")->trigger();
        QTRY_VERIFY(actions.action("view.textured")->isChecked());
    }

    void ofTwoPanelsSideBySideTheOneUsedLastCounts()
    {
        auto* parts = test::find<QDockWidget>("bodyPartsDock");
        auto* samples = test::find<QDockWidget>("samplesDock");
        samples->raise();
        QTRY_VERIFY(!tool().editor().isActive());
        parts->raise();
        QTRY_VERIFY(tool().editor().isActive());
        samples->setFloating(true);
        samples->show();
        QTRY_VERIFY(!tool().editor().isActive());
        QVERIFY(parts->isVisible() && samples->isVisible());
        m_window->context().actions.action("variations.curve.draw")->trigger();
        QTRY_VERIFY(tool().editor().isActive());
        key(Qt::Key_Escape);
        samples->setFloating(false);
    }

    void howCurvesAreDrawnIsRemembered()
    {
        const bool snapped = tool().snaps();
        test::find<QDoubleSpinBox>("snapRadius")->setValue(3.5);
        test::find<QDoubleSpinBox>("partOverlap")->setValue(5);
        tool().setSnaps(!snapped);
        const Settings::CurveDrawing kept = Settings().curveDrawing();
        QCOMPARE(kept.snaps, !snapped);
        QCOMPARE(kept.snapRadius, 0.035);
        QCOMPARE(kept.overlap, 0.05);
        m_window->context().settings.setCurveDrawing({});
    }

    void theProjectTreeTellsOfFaults()
    {
        auto* tree = test::find<QTreeView>("projectTree");
        auto* model = qobject_cast<ProjectTreeModel*>(tree->model());
        const auto state = [model] {
            const QModelIndex section = model->indexOf({Section::BodyParts, {}});
            return model->rowCount(section) == 1
                       ? std::optional(static_cast<EntryState>(
                             model->index(0, 0, section).data(ProjectTreeModel::StateRole).toInt()))
                       : std::nullopt;
        };
        QVERIFY(!state());
        drawOnArm(0.45F);
        run("variations.parts.add");
        QCOMPARE(state(), std::optional(EntryState::Fresh));
        drawOnArm(0.55F);
        tool().edit("break", "parts", [](BodyPartsEntry& entry) { entry.parts[1].part.curves = {"curve"}; });
        QCOMPARE(state(), std::optional(EntryState::Failed));
        history().undo();
        QCOMPARE(state(), std::optional(EntryState::Fresh));
    }

    void whatPointersDoIsTimed_data()
    {
        QTest::addColumn<QString>("body");
        for (const char* name : {"sample", "rb_m04"})
            QTest::newRow(name) << name;
    }

    /// Prints what each event costs the interface; slower machines fail nothing.
    void whatPointersDoIsTimed()
    {
        QFETCH(QString, body);
        if (body == "sample") {
            const auto folder = toPath(m_folder->filePath("sample"));
            document().load(writeSample(folder, {.textureSize = 64, .takesPerKind = 1}));
        } else {
            const std::optional<Project> project = capturedWalk();
            if (!project)
                QSKIP("no captures here");
            document().reset(*project);
            test::find<QDockWidget>("bodyPartsDock")->raise();
            QTRY_VERIFY(tool().surface().graph() != nullptr);
            run("variations.parts.propose");
        }
        m_window->workspaces().select("variations");
        test::find<QDockWidget>("bodyPartsDock")->raise();
        QTRY_VERIFY(tool().surface().graph() != nullptr);
        QTRY_VERIFY(tool().cut().parts.parts.size() == 5);
        QTRY_VERIFY(tool().editor().isActive() && tool().editor().figure() >= 0);
        widgets::SurfaceCurveEditor& editor = tool().editor();
        widgets::SurfaceCurvePart point{PartKind::Point, 0, 0};
        const auto isNotSeen = [&] {
            editor.reveal(point);
            return !editor.isSeen(point);
        };
        while (point.curve + 1 < static_cast<int>(editor.curves().size()) && isNotSeen())
            ++point.curve;
        QVERIFY(editor.isSeen(point));
        QPointF from = *editor.pixelOf(point);
        const auto timed = [&](const char* what, Qt::MouseButtons buttons) {
            std::vector<double> costs;
            for (int step = 1; step <= 24; ++step) {
                const QPointF to = from + QPointF(0.5 * step, 0.7 * (step % 12));
                QMouseEvent event(QEvent::MouseMove, to, viewport().view()->mapToGlobal(to), Qt::NoButton,
                                  buttons, {});
                QElapsedTimer timer;
                timer.start();
                QCoreApplication::sendEvent(viewport().view(), &event);
                costs.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
                QCoreApplication::processEvents();
            }
            std::ranges::sort(costs);
            qInfo("%s, %s: median %.1f ms, most %.1f ms", qPrintable(body), what, costs[costs.size() / 2],
                  costs.back());
        };
        timed("pointing", Qt::NoButton);
        from = *editor.pixelOf(point); // the view may have moved as the figure came
        QTest::mousePress(viewport().view(), Qt::LeftButton, {}, from.toPoint());
        QVERIFY(editor.isDragging());
        timed("dragging a point", Qt::LeftButton);
        QTest::mouseRelease(viewport().view(), Qt::LeftButton, {}, from.toPoint());
        run("variations.curve.draw");
        timed("drawing", Qt::NoButton);
    }

    void aCurveIsDrawnByKeyboard()
    {
        look(60);
        QVERIFY(test::activate(*m_window));
        QTest::keyClick(m_window.get(), Qt::Key_C);
        QCOMPARE(tool().editor().mode(), Mode::Draw);
        key(Qt::Key_Right);
        for (int i = 0; i < 3; ++i)
            key(Qt::Key_Right, Qt::ShiftModifier);
        key(Qt::Key_Insert);
        QCOMPARE(body().curves.size(), 1U);
        key(Qt::Key_Return);
        key(Qt::Key_Tab);
        QCOMPARE(tool().editor().selected().kind, PartKind::Point);
        const Project before = document().project();
        key(Qt::Key_Up);
        checkHistory(before);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST_IN(quadrille::test::ViewApplication, quadrille::BodyPartsPanelTest);

#include "tst_bodypartspanel.moc"
