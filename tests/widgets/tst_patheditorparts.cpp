// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Handles, insertions, stretches, obstacles and the geometry behind them.
#include "tst_patheditor.h"
#include "widgets/viewport/labelplaces.h"
#include "widgets/viewport/viewportoverlay.h"

void TestPathEditor::handlesMirrorUnlessAltIsHeld()
{
    showLine(PathKind::Bezier);
    QCOMPARE(m_editor->shape().points.size(), 7U);
    const QVector3D middle = m_editor->shape().points[3];
    const float reach = (m_editor->shape().points[2] - middle).length();
    drag(pixel({Part::Point, 4, 0}), pixel(QVector3D(1, 0, -1)));
    VERIFY_NEAR(m_editor->shape().points[4], {1, 0, -1});
    VERIFY_NEAR(m_editor->shape().points[2], {-reach, 0, -1});
    const QVector3D kept = m_editor->shape().points[2];
    drag(pixel({Part::Point, 4, 0}), pixel(QVector3D(0.6F, 0, 0.2F)), Qt::AltModifier);
    VERIFY_NEAR(m_editor->shape().points[4], {0.6F, 0, 0.2F});
    QCOMPARE(m_editor->shape().points[2], kept);
    // Once broken they stay so, until a double click on their point.
    drag(pixel({Part::Point, 4, 0}), pixel(QVector3D(0.8F, 0, 0.2F)));
    QCOMPARE(m_editor->shape().points[2], kept);
    QTest::mouseDClick(m_viewport->view(), Qt::LeftButton, {}, pixel({Part::Point, 3, 0}));
    QVERIFY(isSmooth(m_editor->shape().points, 1));
}

void TestPathEditor::pullingDrawsBezierHandles()
{
    PathShape shape;
    shape.kind = PathKind::Bezier;
    show(shape);
    m_editor->setMode(PathEditor::Mode::Draw);
    click({-2, 0, 0});
    drag(pixel(QVector3D(1, 0, 0)), pixel(QVector3D(1, 0, 1)));
    const auto& points = m_editor->shape().points;
    QCOMPARE(points.size(), 4U);
    VERIFY_NEAR(points[3], {1, 0, 0});
    VERIFY_NEAR(points[2], {1, 0, -1});
    click({3, 0, 0});
    QCOMPARE(m_editor->shape().points.size(), 7U);
    QVERIFY(isSmooth(m_editor->shape().points, 1));
}

void TestPathEditor::aDoubleClickOnTheCurveInsertsAPoint()
{
    showLine();
    const QPoint at = pixel(QVector3D(-0.7F, 0, -1));
    QCOMPARE(m_editor->partAt(at).kind, Part::Curve);
    QTest::mouseDClick(m_viewport->view(), Qt::LeftButton, {}, at);
    QCOMPARE(m_editor->shape().points.size(), 4U);
    VERIFY_NEAR(m_editor->shape().points[1], {-0.7F, 0, -1});
    QCOMPARE(m_editor->selected(), (PathPart{Part::Point, 1, 0}));
    showLine(PathKind::Bezier);
    const auto before = m_editor->curve();
    QTest::mouseDClick(m_viewport->view(), Qt::LeftButton, {}, pixel(before.at(3.0)));
    QCOMPARE(m_editor->shape().points.size(), 10U);
    VERIFY_NEAR(m_editor->shape().points[6], before.at(3.0));
    QVERIFY(std::abs(m_editor->curve().length() - before.length()) < 0.01);
}

void TestPathEditor::deleteRemovesAPointAndAtLastThePath()
{
    showLine();
    QTest::mouseClick(m_viewport->view(), Qt::LeftButton, {}, pixel({Part::Point, 1, 0}));
    key(Qt::Key_Delete);
    QCOMPARE(m_editor->shape().points, (std::vector<QVector3D>{{-2, 0, -1}, {0, 0, 1}}));
    key(Qt::Key_Delete);
    QVERIFY(m_editor->shape().points.empty());
}

void TestPathEditor::everythingCanBeDoneByKeyboard()
{
    m_editor->setMode(PathEditor::Mode::Draw);
    key(Qt::Key_Insert);
    key(Qt::Key_Insert);
    key(Qt::Key_Insert);
    QCOMPARE(m_editor->shape().points.size(), 3U);
    VERIFY_NEAR(m_editor->shape().points[0], {0, 0, 0});
    key(Qt::Key_Return);
    key(Qt::Key_Escape);
    key(Qt::Key_Tab);
    QCOMPARE(m_editor->selected(), (PathPart{Part::Point, 0, 0}));
    key(Qt::Key_Tab);
    QCOMPARE(m_editor->selected(), (PathPart{Part::Point, 1, 0}));
    const QVector3D before = m_editor->shape().points[1];
    key(Qt::Key_Right);
    key(Qt::Key_Right, Qt::ShiftModifier);
    VERIFY_NEAR(m_editor->shape().points[1], before + QVector3D(1.1F, 0, 0));
    key(Qt::Key_Up);
    VERIFY_NEAR(m_editor->shape().points[1], before + QVector3D(1.1F, 0, -0.1F));
    key(Qt::Key_Insert);
    QCOMPARE(m_editor->shape().points.size(), 4U);
    key(Qt::Key_Delete);
    QCOMPARE(m_editor->shape().points.size(), 3U);
    key(Qt::Key_Escape);
    QCOMPARE(m_editor->selected(), PathPart{});
    m_editor->setMode(PathEditor::Mode::Disc);
    key(Qt::Key_Insert);
    QCOMPARE(m_editor->shape().obstacles.size(), 1U);
    key(Qt::Key_Backtab);
    QCOMPARE(m_editor->selected(), (PathPart{Part::Obstacle, 0, 0}));
    const float radius = m_editor->shape().obstacles[0].radius;
    key(Qt::Key_Plus);
    QVERIFY(m_editor->shape().obstacles[0].radius > radius);
    key(Qt::Key_Delete);
    QVERIFY(m_editor->shape().obstacles.empty());
}

void TestPathEditor::pointsInSpaceAreLiftedByTheirArrow()
{
    showLine(PathKind::Polyline, true);
    QTest::mouseClick(m_viewport->view(), Qt::LeftButton, {}, pixel({Part::Point, 1, 0}));
    const PathPart arrow{Part::Lift, 1, 0};
    QVERIFY(m_editor->pixelOf(arrow));
    const QPoint from = pixel(arrow);
    QCOMPARE(m_editor->partAt(from), arrow);
    drag(from, from - QPoint(0, 40));
    const QVector3D lifted = m_editor->shape().points[1];
    QVERIFY2(lifted.y() > 1.3F, qPrintable(QString::number(lifted.y())));
    QCOMPARE(lifted.x(), 0.0F);
    QCOMPARE(lifted.z(), -1.0F);
    drag(pixel({Part::Point, 1, 0}), pixel({Part::Point, 1, 0}) + QPoint(50, 0));
    QCOMPARE(m_editor->shape().points[1].y(), lifted.y());
    QVERIFY(m_editor->shape().points[1].x() > 0.3F);
    key(Qt::Key_PageDown);
    QVERIFY(std::abs(m_editor->shape().points[1].y() - lifted.y() + 0.1F) < 1e-4F);
}

void TestPathEditor::endsOfStretchesAreDraggedAlongTheCurve()
{
    showLine();
    PathShape shape = m_editor->shape();
    shape.stretches = {{0.5, 1.5, "jog"}};
    show(shape);
    drag(pixel({Part::StretchEnd, 0, 0}), pixel(QVector3D(0, 0, 0.2F)));
    const PathStretch& stretch = m_editor->shape().stretches[0];
    QVERIFY2(std::abs(stretch.to - 3.2) < 0.03, qPrintable(QString::number(stretch.to)));
    QCOMPARE(stretch.from, 0.5);
    QCOMPARE(m_edits, 1);
    // The ends never pass each other.
    drag(pixel({Part::StretchStart, 0, 0}), pixel(QVector3D(0, 0, 1)));
    QVERIFY(m_editor->shape().stretches[0].from < m_editor->shape().stretches[0].to);
    key(Qt::Key_Left);
    QVERIFY(std::abs(m_editor->shape().stretches[0].from - 3.05) < 0.05);
    QSignalSpy deletion(m_editor.get(), &PathEditor::stretchDeletionAsked);
    key(Qt::Key_Delete);
    QCOMPARE(deletion.size(), 1);
}

void TestPathEditor::discsAreDrawnMovedResizedAndDeleted()
{
    showLine();
    m_editor->setMode(PathEditor::Mode::Disc);
    drag(pixel(QVector3D(2, 0, 0)), pixel(QVector3D(2.5F, 0, 0)));
    QCOMPARE(m_editor->mode(), PathEditor::Mode::Edit);
    QCOMPARE(m_editor->shape().obstacles.size(), 1U);
    VERIFY_NEAR(m_editor->shape().obstacles[0].corners[0], {2, 0, 0});
    QVERIFY(std::abs(m_editor->shape().obstacles[0].radius - 0.5F) < nearby);
    drag(pixel({Part::Obstacle, 0, 0}), pixel(QVector3D(1.5F, 0, 1)));
    VERIFY_NEAR(m_editor->shape().obstacles[0].corners[0], {1.5F, 0, 1});
    QVERIFY(std::abs(m_editor->shape().obstacles[0].radius - 0.5F) < nearby);
    drag(pixel(QVector3D(2, 0, 1)), pixel(QVector3D(2.3F, 0, 1)));
    QVERIFY(std::abs(m_editor->shape().obstacles[0].radius - 0.8F) < 2 * nearby);
    QCOMPARE(m_edits, 3);
    key(Qt::Key_Delete);
    QVERIFY(m_editor->shape().obstacles.empty());
}

void TestPathEditor::polygonsAreDrawnCornerByCorner()
{
    showLine();
    m_editor->setMode(PathEditor::Mode::Polygon);
    click({1, 0, 0});
    click({2, 0, 0});
    click({2, 0, 1});
    click({1, 0, 0});
    QCOMPARE(m_editor->mode(), PathEditor::Mode::Edit);
    QCOMPARE(m_editor->shape().obstacles.size(), 1U);
    QCOMPARE(m_editor->shape().obstacles[0].corners.size(), 3U);
    drag(pixel({Part::ObstacleCorner, 0, 2}), pixel(QVector3D(2.5F, 0, 1.5F)));
    VERIFY_NEAR(m_editor->shape().obstacles[0].corners[2], {2.5F, 0, 1.5F});
    VERIFY_NEAR(m_editor->shape().obstacles[0].corners[0], {1, 0, 0});
}

void TestPathEditor::measuringHasPrecedence()
{
    showLine();
    m_viewport->setTool(Viewport::Tool::Measure);
    const QPoint at = pixel({Part::Point, 1, 0});
    drag(at, at + QPoint(40, 0));
    QCOMPARE(m_edits + m_previews, 0);
}

void TestPathEditor::wordsKeepClearOfHandles()
{
    const QRectF view(0, 0, 400, 300);
    const PlateRequest words{QPointF(200, 150), QSizeF(60, 20)};
    const QRectF above = placePlates({words}, {}, view).front();
    QVERIFY(above.bottom() < 150.0 && above.bottom() > 130.0);
    QCOMPARE(above.center().x(), 200.0);
    // Something above: below; above and below: at a side; at the upper edge of the view: below.
    const QRectF below = placePlates({words}, {QRectF(195, 125, 10, 10)}, view).front();
    QVERIFY(below.top() > 150.0);
    const QRectF aside =
        placePlates({words}, {QRectF(195, 125, 10, 10), QRectF(195, 170, 10, 10)}, view).front();
    QVERIFY(aside.left() > 200.0 || aside.right() < 200.0);
    QVERIFY(placePlates({{QPointF(200, 4), words.size}}, {}, view).front().top() > 4.0);
    // What one keeps clear of, others may cover.
    const PlateRequest beside{words.place, words.size, {QRectF(180, 20, 40, 135)}};
    QVERIFY(placePlates({beside}, {}, view).front().top() > 150.0);
    QCOMPARE(placePlates({beside, words}, {}, view)[1], above);
    // Two at one place do not cover each other.
    const auto two = placePlates({words, words}, {}, view);
    QVERIFY(!two[0].intersects(two[1]));

    showLine();
    PathShape shape = m_editor->shape();
    shape.stretches = {{0.5, 1.5, QStringLiteral("run")}};
    show(shape);
    const Annotations& written = m_viewport->findChild<ViewportOverlay*>()->annotations();
    QCOMPARE(written.labels.size(), 1U);
    QCOMPARE(written.handles.size(), shape.points.size() + 2);
    VERIFY_NEAR(written.handles.back(), m_editor->curve().at(1.5));
}

void TestPathEditor::dividingABezierKeepsItsForm()
{
    const std::vector<QVector3D> points{{0, 0, 0}, {1, 0, 2}, {3, 0, 2}, {4, 0, 0}};
    const SampledCurve whole(sample(PathKind::Bezier, points));
    const QVector3D place = whole.at(1.3);
    const float t = nearestParameter(points, 0, place);
    const auto divided = insertedPoint(PathKind::Bezier, points, 0, t, place);
    QCOMPARE(divided.size(), 7U);
    VERIFY_NEAR(divided[3], place);
    const SampledCurve again(sample(PathKind::Bezier, divided));
    QVERIFY(std::abs(again.length() - whole.length()) < 0.01);
    QCOMPARE(removedAnchor(PathKind::Bezier, divided, 1).size(), 4U);
    QVERIFY(removedAnchor(PathKind::Bezier, points, 1).empty());
}

void TestPathEditor::polygonsAreTriangulatedAndHatchedInside()
{
    // An L of three square metres, clockwise and the other way.
    std::vector<QVector3D> outline{{0, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 1}, {1, 0, 2}, {0, 0, 2}};
    for (int turn = 0; turn < 2; ++turn) {
        const auto triangles = triangulate(outline, {0, 1, 0});
        QCOMPARE(triangles.size(), 12U);
        float area = 0;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const auto corner = [&](std::size_t k) {
                return outline[static_cast<std::size_t>(triangles[i + k])];
            };
            area += QVector3D::crossProduct(corner(1) - corner(0), corner(2) - corner(0)).length() / 2;
        }
        QVERIFY(std::abs(area - 3.0F) < 1e-5F);
        const auto hatch = hatchLines(outline, {0, 1, 0}, 0.25F);
        QVERIFY(hatch.size() > 10);
        for (std::size_t i = 0; i + 1 < hatch.size(); i += 2) {
            const QVector3D middle = (hatch[i] + hatch[i + 1]) / 2;
            QVERIFY(middle.x() < 1.001F || middle.z() < 1.001F);
        }
        std::reverse(outline.begin(), outline.end());
    }
}
