// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/viewapplication.h"
#include "widgets/latent/latentview.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/vtkview.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

namespace quadrille::widgets {

class TestLatentView : public QObject
{
    Q_OBJECT

private:
    using Place = LatentView::Place;

    static LatentPath circle(const QString& name, float radius, const QColor& color, bool isSample = false)
    {
        LatentPath path{.name = name, .color = color, .isSample = isSample, .points = {}, .values = {}};
        for (int frame = 0; frame < 24; ++frame) {
            const float angle = 0.2618F * static_cast<float>(frame);
            path.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.3F * radius);
            path.values.push_back(frame);
        }
        return path;
    }

    void showTwo()
    {
        m_view->setPaths({circle("walk", 1, Qt::red), circle("run", 2, Qt::blue)});
        m_view->lookFrom(StandardView::Front);
        QTRY_COMPARE(m_view->camera().yaw, 0.0F);
    }
    QWidget* surface() { return m_view->focusProxy(); }
    void hover(const Place& place)
    {
        const auto position = m_view->positionOf(place);
        QVERIFY(position);
        QTest::mouseMove(surface(), position->toPoint());
    }
    /// Colours near a place of the view.
    bool shows(const QPointF& position, const QColor& color)
    {
        const QImage image = m_view->grab().toImage();
        const QPoint middle = (position * image.devicePixelRatio()).toPoint();
        for (int y = -4; y <= 4; ++y) {
            for (int x = -4; x <= 4; ++x) {
                const QColor found = image.pixelColor(middle + QPoint(x, y));
                if (std::abs(found.red() - color.red()) + std::abs(found.green() - color.green()) +
                        std::abs(found.blue() - color.blue()) <
                    60)
                    return true;
            }
        }
        return false;
    }

    std::unique_ptr<LatentView> m_view;

private slots:
    void init()
    {
        m_view = std::make_unique<LatentView>();
        m_view->resize(500, 500);
        m_view->setEmptyText("Learn first.");
        m_view->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
    }

    void cleanup() { m_view.reset(); }

    void saysWhatIsMissingAsLongAsItIsEmpty()
    {
        QVERIFY(m_view->isEmpty());
        m_view->setPaths({});
        QCOMPARE(m_view->accessibleDescription(), "Learn first.");
    }

    void drawsAPathInItsColour()
    {
        showTwo();
        const auto place = m_view->positionOf({1, 8});
        QVERIFY(place);
        QTRY_VERIFY(shows(*place, Qt::blue));
        const auto other = m_view->positionOf({0, 8});
        QTRY_VERIFY(shows(*other, Qt::red));
        QVERIFY(!shows(*other, Qt::blue));
    }

    void thePointerReadsTheFrameThatItIsOver()
    {
        showTwo();
        hover({1, 6});
        QTRY_COMPARE(m_view->chosen(), std::optional(Place{1, 6}));
        QCOMPARE(m_view->readOut(), "run, frame 6; : 6.00");
        QTest::mouseMove(surface(), {3, 3});
        QTRY_VERIFY(!m_view->chosen());
    }

    void aClickGoesToTheFrame()
    {
        showTwo();
        QSignalSpy activated(m_view.get(), &LatentView::activated);
        QTest::mouseClick(surface(), Qt::LeftButton, {}, m_view->positionOf({0, 3})->toPoint());
        QCOMPARE(activated.size(), 1);
        QCOMPARE(activated[0], (QVariantList{0, 3}));
        QTest::mouseClick(surface(), Qt::LeftButton, {}, {2, 2});
        QCOMPARE(activated.size(), 1);
    }

    void keysGoFromFrameToFrameAndFromPathToPath()
    {
        showTwo();
        QTest::mouseMove(surface(), {3, 3});
        QTRY_VERIFY(!m_view->chosen());
        QSignalSpy activated(m_view.get(), &LatentView::activated);
        QTest::keyClick(surface(), Qt::Key_Right);
        QCOMPARE(m_view->chosen(), std::optional(Place{0, 0}));
        QTest::keyClick(surface(), Qt::Key_Right);
        QTest::keyClick(surface(), Qt::Key_Down);
        QCOMPARE(m_view->chosen(), std::optional(Place{1, 1}));
        QTest::keyClick(surface(), Qt::Key_End);
        QTest::keyClick(surface(), Qt::Key_Return);
        QCOMPARE(activated.value(0), (QVariantList{1, 23}));
        QTest::keyClick(surface(), Qt::Key_Home);
        QCOMPARE(m_view->chosen(), std::optional(Place{1, 0}));
    }

    void theFrameThatIsShownIsAPointOnItsPath()
    {
        m_view->setPaths({circle("walk", 1, Qt::red, true)});
        m_view->lookFrom(StandardView::Front);
        QTRY_COMPARE(m_view->camera().yaw, 0.0F);
        const auto between = [this] {
            const QPointF a = *m_view->positionOf({0, 4});
            const QPointF b = *m_view->positionOf({0, 5});
            return (a + b) / 2 + QPointF(1.5, 1.5);
        };
        const auto reds = [this, between] {
            const QImage image = m_view->grab().toImage();
            int count = 0;
            for (int y = -6; y <= 6; ++y)
                for (int x = -6; x <= 6; ++x)
                    count += image.pixelColor((between() * image.devicePixelRatio()).toPoint() +
                                              QPoint(x, y)) == QColor(Qt::red);
            return count;
        };
        const auto shownRed = [this, between] { return shows(between(), Qt::red); };
        QTRY_VERIFY(shownRed());
        const int before = reds();
        m_view->setCurrent({4.5});
        QTRY_VERIFY(reds() > before + 4);
    }

    void confidenceTakesThePlaceOfTheColours()
    {
        showTwo();
        const ScalarRange range{.minimum = 0, .maximum = 23, .title = "log variance"};
        m_view->setConfidence({{{0, 0, 0}}, {1.0}}, range);
        m_view->setConfidenceShown(true);
        const auto place = m_view->positionOf({1, 12});
        QTRY_VERIFY(shows(*place, range.color(12)));
        QVERIFY(!shows(*place, Qt::blue));
        m_view->setConfidenceShown(false);
        QTRY_VERIFY(shows(*place, Qt::blue));
    }

    void newPathsLeaveTheCameraWhereItIs()
    {
        showTwo();
        Turntable camera = m_view->camera();
        camera.yaw = 40;
        m_view->setCamera(camera);
        m_view->setPaths({circle("walk", 5, Qt::red)});
        QCOMPARE(m_view->camera(), camera);
        QTest::keyClick(surface(), Qt::Key_F);
        QTRY_VERIFY(m_view->camera().distance > camera.distance * 1.5F);
    }

    void aPlaceThatIsGoneIsNotChosenAnyMore()
    {
        showTwo();
        hover({1, 6});
        QTRY_VERIFY(m_view->chosen());
        m_view->setPaths({circle("walk", 1, Qt::red)});
        QVERIFY(!m_view->chosen());
        QCOMPARE(m_view->readOut(), QString());
    }
};

/// Views of VTK in the colours of the program.
class ThemedApplication : public test::ViewApplication
{
public:
    ThemedApplication(int& argc, char** argv) : ViewApplication(argc, argv) { Theme::instance().install(); }
};

} // namespace quadrille::widgets

QUADRILLE_QT_TEST_IN(quadrille::widgets::ThemedApplication, quadrille::widgets::TestLatentView);

#include "tst_latentview.moc"
