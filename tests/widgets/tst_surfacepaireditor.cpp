// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Triangles of two figures that are paired by clicks, dragged and walked over by keys.
#include "surfacecurvefixture.h"
#include "tests/qt/registry.h"
#include "widgets/tools/surfacepaireditor.h"

#include <algorithm>

using namespace quadrille::test;
using namespace quadrille::widgets;

namespace {

constexpr std::uint32_t front = 2 * (5 * around); ///< a triangle in the middle of the front of a tube
constexpr std::uint32_t back = front + around;    ///< one behind it

} // namespace

/// Two tubes side by side, and the editor of pairs on them.
class TestSurfacePairEditor : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        QVERIFY(VtkView::openGlAvailable());
        m_viewport = std::make_unique<Viewport>();
        m_viewport->resize(800, 600);
        m_viewport->setLayoutMode(Viewport::Layout::Overlay);
        m_viewport->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get()));
        for (const float x : {-1.0F, 1.0F}) {
            const int figure = m_viewport->addFigure(tube());
            m_viewport->setPositions(figure, tubePositions());
            m_viewport->setFigureOffset(figure, {x, 0, 0});
            m_figures.push_back(figure);
        }
        Turntable camera;
        camera.target = {0, 0, 0};
        camera.yaw = 0;
        camera.pitch = 0;
        camera.distance = 6;
        m_viewport->setCamera(camera);
        m_editor = std::make_unique<SurfacePairEditor>(*m_viewport);
        m_editor->setFigures(m_figures[0], m_figures[1]);
        m_editor->setActive(true);
        connect(m_editor.get(), &SurfacePairEditor::pairRequested, this,
                [this](std::uint32_t first, std::uint32_t second) { m_made.emplace_back(first, second); });
        m_viewport->setViewTool(m_editor.get());
        m_viewport->view()->setFocus();
    }
    void cleanup()
    {
        m_editor.reset();
        m_viewport.reset();
        m_figures.clear();
        m_made.clear();
    }

    void twoClicksMakeAPairWhicheverComesFirst()
    {
        click(pixel(0, front));
        QVERIFY(m_editor->begun());
        QCOMPARE(*m_editor->begun(), (PairPlace{0, front}));
        QVERIFY(m_made.empty());
        click(pixel(1, front + 2));
        QVERIFY(!m_editor->begun());
        click(pixel(1, front + 4));
        click(pixel(0, front + 6));
        QCOMPARE(m_made, (Pairs{{front, front + 2}, {front + 6, front + 4}}));
    }

    void anotherClickOnTheSameFigureBeginsAnew()
    {
        click(pixel(0, front));
        click(pixel(0, front + 4));
        QCOMPARE(*m_editor->begun(), (PairPlace{0, front + 4}));
        QVERIFY(m_made.empty());
    }

    void escapeGivesUpAndReturnAsksForTheOtherEnd()
    {
        QSignalSpy asked(m_editor.get(), &SurfacePairEditor::counterpartRequested);
        key(Qt::Key_Return);
        QCOMPARE(asked.size(), 0);
        click(pixel(0, front));
        key(Qt::Key_Return);
        QCOMPARE(asked.size(), 1);
        key(Qt::Key_Escape);
        QVERIFY(!m_editor->begun());
        click(pixel(1, front));
        QVERIFY(m_made.empty());
    }

    void dragsAndClicksWithCtrlAreTheCameras()
    {
        const double yaw = m_viewport->camera().yaw;
        const QPoint at = pixel(0, front);
        mouse(QEvent::MouseButtonPress, at);
        for (int step = 1; step <= 8; ++step)
            mouse(QEvent::MouseMove, at + QPoint(10 * step, 0));
        mouse(QEvent::MouseButtonRelease, at + QPoint(80, 0));
        QVERIFY(!m_editor->begun());
        QVERIFY(std::abs(m_viewport->camera().yaw - yaw) > 1);
        click(pixel(0, front), Qt::ControlModifier);
        QVERIFY(!m_editor->begun());
    }

    void endsAreSelectedDraggedAndCommittedOnce()
    {
        m_editor->setPairs({pair(front, front), pair(front + 8, front + 8)});
        QSignalSpy selected(m_editor.get(), &SurfacePairEditor::selectionChanged);
        QSignalSpy moved(m_editor.get(), &SurfacePairEditor::moveRequested);
        click(pixel(1, front + 8));
        QCOMPARE(m_editor->selected(), 1);
        QCOMPARE(selected.size(), 1);
        QCOMPARE(moved.size(), 0);
        const QPoint from = pixel(1, front);
        const QPoint to = pixel(1, front + 4);
        mouse(QEvent::MouseButtonPress, from);
        for (int step = 1; step <= 6; ++step)
            mouse(QEvent::MouseMove, from + (to - from) * step / 6);
        QVERIFY(moved.size() > 0);
        QCOMPARE(moved.back().at(3).toBool(), false);
        QCOMPARE(moved.back().at(2).toUInt(), front + 4);
        m_editor->setPairs({pair(front, front + 4), pair(front + 8, front + 8)});
        moved.clear();
        mouse(QEvent::MouseButtonRelease, to);
        QCOMPARE(moved.size(), 1);
        QCOMPARE(moved.back(), (QList<QVariant>{0, 1, front + 4, true}));
    }

    void escapeTakesADragBack()
    {
        m_editor->setPairs({pair(front, front)});
        QSignalSpy moved(m_editor.get(), &SurfacePairEditor::moveRequested);
        const QPoint from = pixel(1, front);
        mouse(QEvent::MouseButtonPress, from);
        mouse(QEvent::MouseMove, from + QPoint(20, 0));
        m_editor->setPairs({pair(front, front + 4)});
        key(Qt::Key_Escape);
        QVERIFY(!m_editor->isDragging());
        QCOMPARE(moved.back(), (QList<QVariant>{0, 1, front, true}));
        mouse(QEvent::MouseButtonRelease, from);
    }

    void anEndStaysOnItsFigure()
    {
        m_editor->setPairs({pair(front, front)});
        QSignalSpy moved(m_editor.get(), &SurfacePairEditor::moveRequested);
        mouse(QEvent::MouseButtonPress, pixel(0, front));
        mouse(QEvent::MouseMove, pixel(1, front));
        QCOMPARE(moved.size(), 0);
        mouse(QEvent::MouseButtonRelease, pixel(1, front));
    }

    void endsBehindAFigureCannotBeGrabbed()
    {
        m_editor->setPairs({pair(back, back)});
        QVERIFY(!m_editor->pixelOf({0, 0}));
        click(pixel(0, back));
        QCOMPARE(m_editor->selected(), -1);
        QVERIFY(m_editor->begun()); // it is the front that was clicked on
    }

    void keysWalkRemoveAndMove()
    {
        m_editor->setPairs({pair(front, front), pair(front + 8, front + 8)});
        QSignalSpy removed(m_editor.get(), &SurfacePairEditor::removalRequested);
        QSignalSpy moved(m_editor.get(), &SurfacePairEditor::moveRequested);
        key(Qt::Key_Tab);
        QCOMPARE(m_editor->selected(), 0);
        key(Qt::Key_Tab);
        QCOMPARE(m_editor->selected(), 1);
        key(Qt::Key_Delete);
        QCOMPARE(removed.size(), 1);
        QCOMPARE(removed.back().at(0).toInt(), 1);
        key(Qt::Key_Up);
        QCOMPARE(moved.size(), 1);
        QCOMPARE(moved.back().at(3).toBool(), true);
        QVERIFY(moved.back().at(2).toUInt() != front + 8);
        key(Qt::Key_Escape);
        QCOMPARE(m_editor->selected(), -1);
    }

    void aSelectedPairThatGoesIsSelectedNoLonger()
    {
        m_editor->setPairs({pair(front, front), pair(front + 8, front + 8)});
        m_editor->setSelected(1);
        m_editor->setPairs({pair(front, front)});
        QCOMPARE(m_editor->selected(), -1);
    }

    void rightClicksOnEndsAskForAMenu()
    {
        m_editor->setPairs({pair(front, front)});
        QSignalSpy asked(m_editor.get(), &SurfacePairEditor::contextMenuRequested);
        mouse(QEvent::MouseButtonPress, pixel(1, front), {}, Qt::RightButton);
        mouse(QEvent::MouseButtonRelease, pixel(1, front), {}, Qt::RightButton);
        QCOMPARE(asked.size(), 1);
        QCOMPARE(m_editor->selected(), 0);
    }

    void trianglesThatAFigureDoesNotHaveAreNotShown()
    {
        m_editor->setPairs({pair(front, 1000000)});
        QVERIFY(m_editor->pixelOf({0, 0}));
        QVERIFY(!m_editor->pixelOf({0, 1}));
        painted();
    }

    void nothingIsTakenWhileItIsNotActive()
    {
        m_editor->setActive(false);
        click(pixel(0, front));
        QVERIFY(!m_editor->begun());
        QVERIFY(painted() == blank());
        m_editor->setActive(true);
        m_editor->setHint(QStringLiteral("Now click"));
        QVERIFY(painted() != blank());
    }

private:
    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

    static SurfacePair pair(std::uint32_t first, std::uint32_t second)
    {
        return {.triangles = {first, second}, .color = Qt::red, .name = QStringLiteral("pair")};
    }
    QPoint pixel(std::size_t side, std::uint32_t triangle) const
    {
        const auto shape = m_viewport->figureShape(m_figures[side]);
        QVector3D middle;
        for (const std::uint32_t vertex : shape->mesh.triangles[triangle])
            middle += shape->place(vertex) / 3.0F;
        QPointF at;
        m_viewport->camera().project(middle, m_viewport->view()->size(), &at);
        return at.toPoint();
    }
    void mouse(QEvent::Type type, const QPoint& at, Qt::KeyboardModifiers modifiers = {},
               Qt::MouseButton button = Qt::LeftButton)
    {
        QWidget* view = m_viewport->view();
        const Qt::MouseButtons buttons =
            type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::MouseButtons(button);
        QMouseEvent event(type, at, view->mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : button,
                          buttons, modifiers);
        QApplication::sendEvent(view, &event);
    }
    void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseMove(m_viewport->view(), at);
        mouse(QEvent::MouseButtonPress, at, modifiers);
        mouse(QEvent::MouseButtonRelease, at, modifiers);
    }
    void key(int code) { QTest::keyClick(m_viewport->view(), static_cast<Qt::Key>(code)); }
    QImage blank() const
    {
        QImage picture(m_viewport->view()->size(), QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        return picture;
    }
    QImage painted() const
    {
        QImage picture = blank();
        QPainter painter(&picture);
        m_editor->paint(painter);
        return picture;
    }

    std::unique_ptr<Viewport> m_viewport;
    std::unique_ptr<SurfacePairEditor> m_editor;
    std::vector<int> m_figures;
    Pairs m_made;
};

QUADRILLE_QT_TEST(TestSurfacePairEditor);
#include "tst_surfacepaireditor.moc"
