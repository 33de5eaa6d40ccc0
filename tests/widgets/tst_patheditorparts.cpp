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

void TestPathEditor::stepsAreThoseOfTheRuler_data()
{
    QTest::addColumn<double>("metresPerUnit");
    QTest::addColumn<float>("middle");
    QTest::addColumn<float>("coarse");
    QTest::addColumn<float>("fine");
    // In the unit of coordinates: ten centimetres, a metre, a centimetre; or an inch, a foot, a tenth of an
    // inch.
    QTest::newRow("m") << 1.0 << 0.1F << 1.0F << 0.01F;
    QTest::newRow("cm") << 0.01 << 10.0F << 100.0F << 1.0F;
    QTest::newRow("mm") << 0.001 << 100.0F << 1000.0F << 10.0F;
    QTest::newRow("ft") << 0.3048 << 1.0F / 12 << 1.0F << 1.0F / 120;
    QTest::newRow("in") << 0.0254 << 1.0F << 12.0F << 0.1F;
}

void TestPathEditor::stepsAreThoseOfTheRuler()
{
    QFETCH(double, metresPerUnit);
    QFETCH(float, middle);
    QFETCH(float, coarse);
    QFETCH(float, fine);
    const Turntable before = m_viewport->camera();
    m_viewport->setRuler(Ruler(metresPerUnit));
    const float metre = m_viewport->ruler().of(1.0F);
    QVERIFY(std::abs(m_viewport->camera().distance / metre - before.distance) < 1e-3F); // sees the same
    PathShape shape{.kind = PathKind::Polyline, .points = {{-metre, 0, 0}, {metre, 0, 0}, {metre, 0, metre}}};
    shape.stretches = {
        {.from = 0.5 * static_cast<double>(metre), .to = static_cast<double>(metre), .text = {}}};
    show(shape);
    const auto moved = [&](Qt::KeyboardModifiers modifiers) {
        m_editor->setSelected({Part::Point, 1, 0});
        const QVector3D from = m_editor->shape().points[1];
        key(Qt::Key_Right, modifiers);
        return (m_editor->shape().points[1] - from).x();
    };
    const auto isAbout = [&](float is, float wanted) { return std::abs(is - wanted) < 1e-4F * metre; };
    QVERIFY(isAbout(moved({}), middle));
    QVERIFY(isAbout(moved(Qt::ShiftModifier), coarse));
    QVERIFY(isAbout(moved(Qt::ControlModifier), fine));
    // Ends of stretches go by the same steps, and keep five centimetres between them.
    m_editor->setSelected({Part::StretchEnd, 0, 0});
    key(Qt::Key_Left);
    QVERIFY(isAbout(static_cast<float>(m_editor->shape().stretches[0].to), metre - middle));
    for (int i = 0; i < 20; ++i)
        key(Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(isAbout(static_cast<float>(m_editor->shape().stretches[0].to), 0.05F * metre));
    // A point that is dragged with Ctrl lies on the grid.
    drag(pixel({Part::Point, 2, 0}), pixel(metre * QVector3D(0.52F, 0, 1.31F)), Qt::ControlModifier);
    for (const int axis : {0, 2}) {
        const float lines = m_editor->shape().points[2][axis] / middle;
        QVERIFY2(std::abs(lines - std::round(lines)) < 1e-2F, qPrintable(QString::number(lines)));
    }
    QVERIFY((m_editor->shape().points[2] / metre - QVector3D(0.52F, 0, 1.31F)).length() < 0.75F);
    // Discs by key: 40 centimetres, and five more.
    m_editor->setMode(PathEditor::Mode::Disc);
    key(Qt::Key_Insert);
    QVERIFY(isAbout(m_editor->shape().obstacles[0].radius, 0.4F * metre));
    m_editor->setSelected({Part::Obstacle, 0, 0});
    key(Qt::Key_Plus);
    QVERIFY(isAbout(m_editor->shape().obstacles[0].radius, 0.45F * metre));
}

void TestPathEditor::lengthsAreReadInTheirUnits()
{
    const QLocale c = QLocale::c();
    QCOMPARE(Ruler(1).text(1.25, c), QStringLiteral("1.250 m"));
    QCOMPARE(Ruler(0.01).text(125, c), QStringLiteral("1.250 m"));
    QCOMPARE(Ruler(0.01).text(3.4, c), QStringLiteral("3.4 cm"));
    QCOMPARE(Ruler(0.001).text(7.2, c), QStringLiteral("7.20 mm"));
    QCOMPARE(Ruler(0.3048).text(4.1, c), QStringLiteral("4.10 ft"));
    QCOMPARE(Ruler(0.3048).text(0.5, c), QStringLiteral("6.00 in"));
    QCOMPARE(Ruler(0.0254).text(30, c), QStringLiteral("2.50 ft"));
    QCOMPARE(Ruler(0.01).decimals(3), 1);
    QCOMPARE(Ruler(0.3048).decimals(3), 3);
    QCOMPARE(Ruler(0.01).rounded(12.345678, 4), 12.35);
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
    QSignalSpy deletion(m_editor.get(), &PathEditor::stretchDeletionRequested);
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
