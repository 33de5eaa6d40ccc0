// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Curves drawn on a body, and the parts that they bound.
#include "bodyfixture.h"
#include "editor/application/editorcontext.h"
#include "editor/workspaces/variations/bodysurface.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/variations/partedits.h"
#include "editor/workspaces/variations/variationsworkspace.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/viewport/vtkview.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <memory>

namespace quadrille {

using widgets::MessageStrip;
using Mode = widgets::SurfaceCurveEditor::Mode;
using PartKind = widgets::SurfaceCurvePart::Kind;

class BodyPartsTest : public QObject
{
    Q_OBJECT

private:
    ProjectDocument& document() { return m_window->context().document; }
    widgets::Viewport& viewport() { return m_window->variations().viewport(); }
    PartCurveTool& tool() { return m_window->variations().parts(); }
    const BodyPartsEntry& body() { return tool().body(); }
    QUndoStack& history() { return *document().undoStack(); }

    /// Where a place of the figure is in the view.
    QPoint pixel(float x, float y, float z)
    {
        QPointF at;
        viewport().camera().project({x, y, z}, viewport().view()->size(), &at);
        return at.toPoint();
    }
    void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(viewport().view(), Qt::LeftButton, modifiers, at);
        QTest::qWait(0);
    }
    void key(int code, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(viewport().view(), static_cast<Qt::Key>(code), modifiers);
    }
    void look(float yaw)
    {
        widgets::Turntable camera;
        camera.target = {0, 0.95F, 0};
        camera.yaw = yaw;
        camera.pitch = 0;
        camera.distance = 4.5F;
        viewport().setCamera(camera);
    }
    void run(const char* action)
    {
        QAction* found = m_window->context().actions.action(QLatin1String(action));
        QVERIFY2(found->isEnabled(), action);
        found->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!tool().isBusy(), 30000);
    }
    /// A curve around the left arm, by a click on its front.
    void drawOnArm(float x)
    {
        run("variations.curve.draw");
        QCOMPARE(tool().editor().mode(), Mode::Draw);
        click(pixel(x, 1.4F, 0.1F));
        key(Qt::Key_Return);
        QCOMPARE(tool().editor().mode(), Mode::Edit);
    }
    /// What redo and undo make of the last edit.
    void checkHistory(const Project& before)
    {
        const Project after = document().project();
        QVERIFY(!(after == before));
        history().undo();
        QVERIFY(document().project() == before);
        history().redo();
        QVERIFY(document().project() == after);
        history().undo();
        QVERIFY(document().project() == before);
        history().redo();
    }
    QTreeWidgetItem* item(const QString& name)
    {
        const auto found =
            test::find<QTreeWidget>("bodyPartsTree")->findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.front();
    }
    static QString said(const char* strip) { return test::find<MessageStrip>(QLatin1String(strip))->text(); }

private slots:
    void initTestCase()
    {
        test::isolate();
        QVERIFY(widgets::VtkView::openGlAvailable());
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = test::figureProject(m_folder->path());
    }

    void init()
    {
        m_window = std::make_unique<MainWindow>();
        document().reset(m_project);
        m_window->resize(1280, 900);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->context().actions.action("workspace.variations")->trigger();
        auto* dock = test::find<QDockWidget>("bodyPartsDock");
        dock->show();
        dock->raise();
        QTRY_VERIFY(viewport().isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(tool().surface().graph() != nullptr, 20000);
        QTRY_VERIFY(tool().editor().figure() >= 0);
        QTRY_VERIFY(tool().editor().isActive());
        m_window->variations().stage().keepCamera();
        look(0);
        QTRY_VERIFY(viewport().pick(pixel(0.45F, 1.4F, 0.1F)).has_value());
    }

    void cleanup()
    {
        history().setClean();
        m_window.reset();
    }

    void namesGetTheOtherSide_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("other");
        QTest::newRow("word") << "left arm 2"
                              << "right arm 2";
        QTest::newRow("back") << "right leg"
                              << "left leg";
        QTest::newRow("capital") << "Left"
                                 << "Right";
        QTest::newRow("letter") << "arm_l"
                                << "arm_r";
        QTest::newRow("part of a word") << "leftover"
                                        << "";
        QTest::newRow("none") << "torso"
                              << "";
    }
    void namesGetTheOtherSide()
    {
        QFETCH(QString, name);
        QTEST(QString::fromStdString(otherSideName(name.toStdString())), "other");
    }

    void whatHangsOnAPartThatGoesHangsOnItsParent()
    {
        BodyPartsEntry entry;
        addPart(entry, "arm", "body", {}, {"a", "b"});
        addPart(entry, "hand", "body", "arm", {"c", "d"});
        QCOMPARE(entry.parts.size(), 3U);
        removePart(entry, "arm");
        QCOMPARE(findPart(entry, "hand")->part.parent, std::string("body"));
        removePart(entry, "body");
        QVERIFY(entry.parts.empty());
    }

    void aCurveDrawnByClicksBecomesAPart()
    {
        QTest::mouseClick(test::find<QPushButton>("drawCurve"), Qt::LeftButton);
        QCOMPARE(tool().editor().mode(), Mode::Draw);
        click(pixel(0.45F, 1.4F, 0.1F));
        QCOMPARE(body().curves.size(), 1U);
        QVERIFY(tool().cut().problems.empty());
        const std::size_t first = body().curves[0].curve.vertices.size();
        QVERIFY(first >= 10);
        click(pixel(0.5F, 1.32F, 0.1F));
        QCOMPARE(body().curves[0].points.size(), 2U);
        QCOMPARE(history().count(), 2);
        key(Qt::Key_Return);
        QCOMPARE(tool().selected(), (PartSelection{PartSelection::Kind::Curve, "curve"}));
        QVERIFY(said("bodyPartsOffer").contains("curve"));

        // The view is coloured as soon as there are two parts.
        const auto colored = [this] {
            const QImage picture = viewport().snapshot({.size = {}, .annotations = false});
            const QRgb arm = picture.pixel(pixel(0.75F, 1.4F, 0.1F));
            const QRgb chest = picture.pixel(pixel(0.0F, 1.1F, 0.1F));
            return std::abs(qRed(arm) - qRed(chest)) + std::abs(qBlue(arm) - qBlue(chest)) > 60;
        };
        QVERIFY(!colored());
        run("variations.parts.add");
        QCOMPARE(body().parts.size(), 2U);
        QCOMPARE(body().curves.size(), 2U);
        QVERIFY(tool().cut().problems.empty());
        QCOMPARE(tool().cut().parts.parts.size(), 2U);
        QTRY_VERIFY(colored());
        QVERIFY(said("bodyPartsOffer").isEmpty());
        QVERIFY(item("part") != nullptr);
        QCOMPARE(item("part")->parent(), item("body"));
        QCOMPARE(item("curve")->parent(), item("part"));

        // The saved project has it all.
        const auto file = std::filesystem::path(m_folder->filePath("saved.quadrille").toStdString());
        document().saveAs(file);
        const Project saved = loadProject(file);
        QCOMPARE(saved.bodyParts.size(), 1U);
        QVERIFY(saved.bodyParts[0].curves == body().curves);
        QVERIFY(saved.bodyParts[0].parts == body().parts);
    }

    void everyPointIsOneStepOfTheHistory()
    {
        const Project before = document().project();
        run("variations.curve.draw");
        click(pixel(0.45F, 1.4F, 0.1F));
        checkHistory(before);
        const Project one = document().project();
        click(pixel(0.5F, 1.32F, 0.1F));
        checkHistory(one);
        key(Qt::Key_Backspace);
        QCOMPARE(body().curves[0].points.size(), 1U);
        key(Qt::Key_Backspace);
        QVERIFY(body().curves.empty());
        QCOMPARE(tool().editor().mode(), Mode::Draw);
        history().undo();
        QCOMPARE(body().curves.size(), 1U);
    }

    void aDragMovesTheCurveLiveAsOneStep()
    {
        drawOnArm(0.45F);
        const Project before = document().project();
        const int steps = history().count();
        const VertexIndex point = body().curves[0].points[0];
        const auto at = tool().editor().pixelOf({PartKind::Point, 0, 0});
        QVERIFY(at.has_value());
        QWidget* view = viewport().view();
        const QPoint to = at->toPoint() + QPoint(60, 0);
        QTest::mousePress(view, Qt::LeftButton, {}, at->toPoint());
        for (int i = 1; i <= 6; ++i) {
            QMouseEvent move(QEvent::MouseMove, at->toPoint() + QPoint(10 * i, 0),
                             view->mapToGlobal(at->toPoint() + QPoint(10 * i, 0)), Qt::NoButton,
                             Qt::LeftButton, {});
            QApplication::sendEvent(view, &move);
        }
        QVERIFY(body().curves[0].points[0] != point); // while it is dragged
        QTest::mouseRelease(view, Qt::LeftButton, {}, to);
        QCOMPARE(history().count(), steps + 1);
        QVERIFY(tool().cut().problems.empty());
        checkHistory(before);
    }

    void escapeGivesADragUp()
    {
        drawOnArm(0.45F);
        const Project before = document().project();
        const int steps = history().count();
        const QPoint at = tool().editor().pixelOf({PartKind::Point, 0, 0})->toPoint();
        QWidget* view = viewport().view();
        QTest::mousePress(view, Qt::LeftButton, {}, at);
        QMouseEvent move(QEvent::MouseMove, at + QPoint(40, 0), view->mapToGlobal(at + QPoint(40, 0)),
                         Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(view, &move);
        QVERIFY(!(document().project() == before));
        key(Qt::Key_Escape);
        QTest::mouseRelease(view, Qt::LeftButton, {}, at);
        QVERIFY(document().project() == before);
        QCOMPARE(history().count(), steps);
    }

    void whatIsBrokenSaysSoInPlace()
    {
        drawOnArm(0.45F);
        run("variations.parts.add");
        QVERIFY(said("bodyPartsProblem").isEmpty());
        tool().select({PartSelection::Kind::Curve, "curve 2"});
        run("variations.parts.remove");
        QVERIFY(said("bodyPartsNotice").contains("curve 2"));
        QVERIFY(said("bodyPartsNotice").contains("part"));
        QVERIFY(said("bodyPartsProblem").contains("curve 2"));
        QVERIFY(item("part")->toolTip(0).contains("curve 2"));
        QVERIFY(!item("part")->icon(2).isNull());
        history().undo();
        QVERIFY(said("bodyPartsProblem").isEmpty());
        QVERIFY(item("part")->icon(2).isNull());

        // A curve that is open is shown as it is, with its fault; a drag of it is none.
        tool().edit("break", "test", [](BodyPartsEntry& entry) {
            entry.curves[0].curve.vertices.erase(entry.curves[0].curve.vertices.begin() + 2,
                                                 entry.curves[0].curve.vertices.begin() + 5);
        });
        QVERIFY(!tool().editor().curves()[0].problem.isEmpty());
        QVERIFY(!item("curve")->icon(2).isNull());
        QVERIFY(said("bodyPartsProblem").contains("open"));
    }

    void aCurveNeverGoesThroughAnother()
    {
        drawOnArm(0.45F);
        const Project before = document().project();
        run("variations.curve.draw");
        const QPoint at = tool().editor().pixelOf({PartKind::Point, 0, 0})->toPoint();
        click(at, Qt::AltModifier);
        QVERIFY(document().project() == before);
        QVERIFY(!tool().editor().refusal().isEmpty());
        click(pixel(0.65F, 1.4F, 0.1F));
        QVERIFY(tool().editor().refusal().isEmpty());
        QCOMPARE(body().curves.size(), 2U);
    }

    void pointsAreInsertedAndDeleted()
    {
        drawOnArm(0.45F);
        const Project before = document().project();
        click(pixel(0.45F, 1.35F, 0.1F), Qt::ControlModifier);
        QCOMPARE(body().curves[0].points.size(), 2U);
        checkHistory(before);
        const Project two = document().project();
        tool().editor().setSelected({PartKind::Point, 0, 1});
        key(Qt::Key_Delete);
        QCOMPARE(body().curves[0].points.size(), 1U);
        checkHistory(two);
    }

    void aPartIsMirroredAndRenamed()
    {
        drawOnArm(0.45F);
        run("variations.parts.add");
        QVERIFY(tool().rename({PartSelection::Kind::Part, "part"}, "left arm"));
        QVERIFY(tool().rename({PartSelection::Kind::Curve, "curve"}, "left 1"));
        QVERIFY(tool().rename({PartSelection::Kind::Curve, "curve 2"}, "left 2"));
        tool().select({PartSelection::Kind::Part, "left arm"});
        const Project one = document().project();
        run("variations.curve.mirror");
        QCOMPARE(said("bodyPartsNotice"), QString());
        QCOMPARE(tool().selected().name, std::string("right arm"));
        QCOMPARE(body().parts.size(), 3U);
        QCOMPARE(findPart(body(), "right arm")->part.parent, std::string("body"));
        QVERIFY(tool().cut().problems.empty());
        const BodyPart& left = *tool().cut().part("left arm");
        const BodyPart& right = *tool().cut().part("right arm");
        QCOMPARE(left.vertices.size(), right.vertices.size());
        const auto pose = tool().surface().graph()->pose();
        QVERIFY(pose[left.vertices.front().value].x() > 0);
        QVERIFY(pose[right.vertices.front().value].x() < 0);
        checkHistory(one);

        const Project two = document().project();
        QVERIFY(tool().rename({PartSelection::Kind::Part, "body"}, "trunk"));
        QCOMPARE(findPart(body(), "left arm")->part.parent, std::string("trunk"));
        checkHistory(two);
        QVERIFY(!tool().rename({PartSelection::Kind::Part, "trunk"}, "left arm"));
        QVERIFY(said("bodyPartsNotice").contains("left arm"));
    }

    void partsOfARealBodyAreProposed()
    {
        const QDir data(QString::fromLocal8Bit(QUADRILLE_DATA_DIR "/characters/rb_m04"));
        if (!data.exists("mesh.obj"))
            QSKIP("no captures here");
        Project project;
        project.characters = {{.name = "rb", .mesh = data.filePath("mesh.obj").toStdString()}};
        project.sequences.push_back(
            {.name = "walk", .character = "rb", .source = data.filePath("walk_1.pc2").toStdString()});
        document().reset(project);
        QTRY_VERIFY_WITH_TIMEOUT(tool().surface().graph() != nullptr, 30000);
        const Project before = document().project();
        QTest::mouseClick(test::find<QPushButton>("proposeParts"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!tool().isBusy(), 30000);
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
        QTRY_VERIFY_WITH_TIMEOUT(!tool().isBusy(), 30000);
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

    void theShownPoseIsTaken()
    {
        m_window->variations().player().goTo(2);
        QTRY_COMPARE(m_window->variations().stage().frame(), FrameIndex(2));
        drawOnArm(0.45F);
        const Project before = document().project();
        QTest::mouseClick(test::find<QPushButton>("takePose"), Qt::LeftButton);
        QVERIFY(body().pose == (NamedFrame{.sequence = "stand", .frame = FrameIndex(2)}));
        checkHistory(before);
        QTRY_VERIFY_WITH_TIMEOUT(tool().surface().graph() != nullptr, 20000);
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

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    Project m_project;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace quadrille

int main(int argc, char** argv)
{
    quadrille::widgets::VtkView::setDefaultFormat();
    QApplication application(argc, argv);
    quadrille::BodyPartsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_bodyparts.moc"
