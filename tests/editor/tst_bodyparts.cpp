// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Curves drawn on a body, and the parts that they bound.
#include "bodypartsfixture.h"
#include "model/project/file/projectfile.h"
#include "tests/qt/viewapplication.h"

namespace quadrille {

class BodyPartsTest : public BodyPartsFixture
{
    Q_OBJECT

private slots:
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

    /// Lengths of curves, radii and overlaps are metres, whatever the project's unit.
    void theSurfaceIsInMetres()
    {
        const auto before = tool().surface().graph();
        ProjectSettings settings = document().project().settings;
        settings.axes.metresPerUnit = 0.01;
        setSettings(document(), settings);
        // The takes, whose files are in metres, are in centimetres now.
        const auto isThere = [&] {
            const auto now = tool().surface().graph();
            return now != nullptr && now != before && (now->pose()[3] - before->pose()[3]).norm() < 1e-5F;
        };
        QTRY_VERIFY(isThere());
        QVERIFY(before->pose()[3].norm() > 0.1F);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST_IN(quadrille::test::ViewApplication, quadrille::BodyPartsTest);

#include "tst_bodyparts.moc"
