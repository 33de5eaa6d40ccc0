// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Paths of animations, edited in numbers.
#include "pathfixture.h"
#include "tests/qt/viewapplication.h"

#include <QDoubleSpinBox>
#include <QListWidget>
#include <QTableWidget>

namespace quadrille {

class PathPanelTest : public QObject, private test::PathFixture
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

    void aSpanMayReachTheLengthThatIsShown()
    {
        PathEntry bent = straight();
        bent.points = {{0, 0, 0}, {0.123, 0, 0.5}, {0, 0, 1}};
        addPath(bent);
        const double length = tool().length();
        const double shown = std::round(length * 100) / 100;
        tool().editor().setSelected({Kind::StretchStart, 0, 0});
        auto* to = test::find<QDoubleSpinBox>("spanTo");
        QTRY_VERIFY(to->isVisible());
        for (const double typed : {shown, std::ceil(length * 100) / 100, length + 3}) {
            to->setValue(0.5);
            to->setFocus();
            to->selectAll();
            QTest::keyClicks(to, QLocale().toString(typed, 'f', 2));
            QTest::keyClick(to, Qt::Key_Return);
            QVERIFY(path().spans[0].to <= length);
            QVERIFY(length - path().spans[0].to < 0.01);
        }
        // The other end, edited by itself, leaves what is not shown of this one.
        const double exact = path().spans[0].to;
        test::find<QDoubleSpinBox>("spanFrom")->setValue(0.3);
        QCOMPARE(path().spans[0].from, 0.3);
        QCOMPARE(path().spans[0].to, exact);
        QVERIFY(test::waitForResult(m_window->context(), m_window->animate().animation().name()));
    }

    void aPointThatIsLookedAtStaysExactlyWhereItIs()
    {
        PathEntry path = straight();
        path.points[1] = {0.12345678, 0, 0.5};
        addPath(path);
        auto* table = test::find<QTableWidget>("pathPoints");
        QTRY_VERIFY(table->isVisible());
        table->setCurrentCell(1, 0);
        table->editItem(table->currentItem());
        auto* field = table->findChild<QDoubleSpinBox*>();
        QVERIFY(field != nullptr);
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY(table->findChild<QDoubleSpinBox*>() == nullptr);
        QCOMPARE(this->path().points[1].x(), 0.12345678);
    }

    void spansAreDraggedInTheViewAndTypedInThePanel()
    {
        addPath(straight());
        auto* spans = test::find<QListWidget>("pathSpans");
        QCOMPARE(spans->count(), 1);
        const QPoint from = pixel({Kind::StretchEnd, 0, 0});
        QTest::mousePress(viewport().view(), Qt::LeftButton, {}, from);
        QTest::mouseMove(viewport().view(), pixel(0, 0.85));
        QTest::mouseMove(viewport().view(), pixel(0, 0.9));
        QTest::mouseRelease(viewport().view(), Qt::LeftButton, {}, pixel(0, 0.9));
        QVERIFY2(std::abs(path().spans[0].to - 0.9) < 0.02, qPrintable(QString::number(path().spans[0].to)));
        QCOMPARE(spans->currentRow(), 0);

        auto* fromField = test::find<QDoubleSpinBox>("spanFrom");
        fromField->setFocus();
        fromField->selectAll();
        QTest::keyClicks(fromField, "0.4");
        QTest::keyClick(fromField, Qt::Key_Return);
        QCOMPARE(path().spans[0].from, 0.4);
        QVERIFY(std::abs(path().spans[0].to - 0.9) < 0.02);
        auto* speed = test::find<QDoubleSpinBox>("spanSpeed");
        speed->setFocus();
        speed->selectAll();
        QTest::keyClicks(speed, "0.5");
        QTest::keyClick(speed, Qt::Key_Return);
        QVERIFY(path().spans[0].duration.has_value());
        QVERIFY(std::abs(*path().spans[0].duration - 1.0) < 0.05);
        QVERIFY2(spans->item(0)->text().contains("0.5"), qPrintable(spans->item(0)->text()));
        document().undo();
        QVERIFY(!path().spans[0].duration);
        QTest::keyClick(spans, Qt::Key_Delete);
        QVERIFY(path().spans.empty());
        QVERIFY(!speed->isVisible());
    }

    void pointsAreTypedInThePanel()
    {
        addPath(straight());
        auto* points = test::find<QTableWidget>("pathPoints");
        QCOMPARE(points->rowCount(), 3);
        QCOMPARE(points->columnCount(), 2);
        points->setCurrentCell(1, 0);
        QCOMPARE(tool().editor().selected(), (PathPart{Kind::Point, 1, 0}));
        QCOMPARE(viewport().view()->accessibleDescription(), QString("Point 2 of the path"));
        points->item(1, 0)->setData(Qt::EditRole, 0.25);
        QCOMPARE(path().points[1], Vec3d(0.25, 0, 0.5));
        QCOMPARE(path().points[2], Vec3d(0, 0, 1));
        tool().setInSpace(true);
        QCOMPARE(points->columnCount(), 3);
        QVERIFY(path().points[1].y() > 0.3);
        document().undo();
        QCOMPARE(points->columnCount(), 2);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST_IN(quadrille::test::ViewApplication, quadrille::PathPanelTest);

#include "tst_pathpanel.moc"
