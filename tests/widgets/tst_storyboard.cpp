// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/storyboard/rangestrip.h"
#include "widgets/storyboard/storyboard.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

using namespace quadrille::widgets;

class TestStoryboard : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void clickingSelectsAndDoubleClickEdits();
    void draggingACardAsksToMoveIt();
    void draggingWithControlAsksForACopy();
    void draggingToItsOwnPlaceAsksForNothing();
    void escapeLeavesACardWhereItWas();
    void everythingIsDoneByKeyboard();
    void takesAndLabelsAreDroppedBetweenCards();
    void otherDataIsNotTaken();
    void aCardThatIsSelectedIsScrolledTo();
    void emptyStoryboardsOfferAButton();
    void endsOfARangeAreDraggedAndMovedByKeys();
    void escapePutsARangeBack();

private:
    std::unique_ptr<Storyboard> m_board;

    static std::vector<StoryCard> cards(int count)
    {
        std::vector<StoryCard> result;
        for (int i = 0; i < count; ++i)
            result.push_back(
                {.title = QStringLiteral("take %1").arg(i), .subtitle = QStringLiteral("0 – 9")});
        return result;
    }
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {});
    QPoint before(int card) const { return m_board->cardRect(card).center() - QPoint(60, 0); }
};

void TestStoryboard::init()
{
    m_board = std::make_unique<Storyboard>();
    m_board->setCards(cards(4));
    m_board->resize(700, 180);
    m_board->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_board.get()));
    m_board->setFocus();
}

void TestStoryboard::cleanup()
{
    m_board.reset();
}

void TestStoryboard::drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers)
{
    QWidget* target = m_board->viewport();
    QTest::mousePress(target, Qt::LeftButton, modifiers, from);
    for (int step = 1; step <= 4; ++step) {
        const QPointF place = from + (to - from) * step / 4;
        QMouseEvent move(QEvent::MouseMove, place, target->mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                         modifiers);
        QCoreApplication::sendEvent(target, &move);
    }
}

void TestStoryboard::clickingSelectsAndDoubleClickEdits()
{
    QSignalSpy current(m_board.get(), &Storyboard::currentChanged);
    QSignalSpy activated(m_board.get(), &Storyboard::activated);
    QTest::mouseClick(m_board->viewport(), Qt::LeftButton, {}, m_board->cardRect(2).center());
    QCOMPARE(current.last().at(0).toInt(), 2);
    QTest::mouseDClick(m_board->viewport(), Qt::LeftButton, {}, m_board->cardRect(2).center());
    QCOMPARE(activated.last().at(0).toInt(), 2);
}

void TestStoryboard::draggingACardAsksToMoveIt()
{
    QSignalSpy moved(m_board.get(), &Storyboard::moveRequested);
    const QImage still = m_board->grab().toImage();
    drag(m_board->cardRect(0).center(), before(3));
    QVERIFY(m_board->grab().toImage() != still);
    QTest::mouseRelease(m_board->viewport(), Qt::LeftButton, {}, before(3));
    QCOMPARE(moved.size(), 1);
    QCOMPARE(moved.at(0).at(0).toInt(), 0);
    QCOMPARE(moved.at(0).at(1).toInt(), 3);
    QCOMPARE(m_board->cards().front().title, QStringLiteral("take 0"));
}

void TestStoryboard::draggingWithControlAsksForACopy()
{
    QSignalSpy copied(m_board.get(), &Storyboard::copyRequested);
    drag(m_board->cardRect(1).center(), before(4), Qt::ControlModifier);
    QTest::mouseRelease(m_board->viewport(), Qt::LeftButton, Qt::ControlModifier, before(4));
    QCOMPARE(copied.size(), 1);
    QCOMPARE(copied.at(0).at(0).toInt(), 1);
    QCOMPARE(copied.at(0).at(1).toInt(), 4);
}

void TestStoryboard::draggingToItsOwnPlaceAsksForNothing()
{
    QSignalSpy moved(m_board.get(), &Storyboard::moveRequested);
    drag(m_board->cardRect(1).center(), before(2));
    QTest::mouseRelease(m_board->viewport(), Qt::LeftButton, {}, before(2));
    QVERIFY(moved.isEmpty());
}

void TestStoryboard::escapeLeavesACardWhereItWas()
{
    QSignalSpy moved(m_board.get(), &Storyboard::moveRequested);
    drag(m_board->cardRect(0).center(), before(3));
    QTest::keyClick(m_board.get(), Qt::Key_Escape);
    QTest::mouseRelease(m_board->viewport(), Qt::LeftButton, {}, before(3));
    QVERIFY(moved.isEmpty());
}

void TestStoryboard::everythingIsDoneByKeyboard()
{
    QSignalSpy moved(m_board.get(), &Storyboard::moveRequested);
    QSignalSpy copied(m_board.get(), &Storyboard::copyRequested);
    QSignalSpy deleted(m_board.get(), &Storyboard::deletionRequested);
    QSignalSpy activated(m_board.get(), &Storyboard::activated);
    QTest::keyClick(m_board.get(), Qt::Key_End);
    QCOMPARE(m_board->current(), 3);
    QTest::keyClick(m_board.get(), Qt::Key_Right, Qt::ControlModifier);
    QVERIFY(moved.isEmpty());
    QTest::keyClick(m_board.get(), Qt::Key_Left, Qt::ControlModifier);
    QCOMPARE(moved.takeLast(), (QVariantList{3, 2}));
    QTest::keyClick(m_board.get(), Qt::Key_Home);
    QTest::keyClick(m_board.get(), Qt::Key_Right);
    QCOMPARE(m_board->current(), 1);
    QTest::keyClick(m_board.get(), Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(moved.takeLast(), (QVariantList{1, 3}));
    QTest::keyClick(m_board.get(), Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(copied.takeLast(), (QVariantList{1, 2}));
    QTest::keyClick(m_board.get(), Qt::Key_Return);
    QCOMPARE(activated.takeLast(), QVariantList{1});
    QTest::keyClick(m_board.get(), Qt::Key_Delete);
    QCOMPARE(deleted.takeLast(), QVariantList{1});
}

void TestStoryboard::takesAndLabelsAreDroppedBetweenCards()
{
    QSignalSpy dropped(m_board.get(), &Storyboard::framesDropped);
    const std::vector<DraggedFrames> frames{{QStringLiteral("dance"), 3, {}},
                                            {{}, 0, QStringLiteral("kick")}};
    const auto data = toMimeData(frames);
    const QImage still = m_board->grab().toImage();
    QDragEnterEvent enter(before(2), Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_board->viewport(), &enter);
    QVERIFY(enter.isAccepted());
    QDragMoveEvent move(before(2), Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_board->viewport(), &move);
    QVERIFY(m_board->grab().toImage() != still);
    QDropEvent drop(before(2), Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_board->viewport(), &drop);
    QCOMPARE(dropped.size(), 1);
    QCOMPARE(dropped.at(0).at(0).toInt(), 2);
    QCOMPARE(dropped.at(0).at(1).value<std::vector<DraggedFrames>>(), frames);
    QCOMPARE(m_board->grab().toImage(), still);
}

void TestStoryboard::otherDataIsNotTaken()
{
    QMimeData text;
    text.setText(QStringLiteral("dance"));
    QDragEnterEvent enter(before(2), Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_board->viewport(), &enter);
    QVERIFY(!enter.isAccepted());
}

void TestStoryboard::aCardThatIsSelectedIsScrolledTo()
{
    m_board->setCards(cards(20));
    QVERIFY(!m_board->viewport()->rect().contains(m_board->cardRect(19)));
    QTest::keyClick(m_board.get(), Qt::Key_End);
    QVERIFY(m_board->viewport()->rect().contains(m_board->cardRect(19)));
    QTest::keyClick(m_board.get(), Qt::Key_Home);
    QVERIFY(m_board->viewport()->rect().contains(m_board->cardRect(0)));
}

void TestStoryboard::emptyStoryboardsOfferAButton()
{
    auto* button = new QPushButton(QStringLiteral("Add"));
    m_board->setEmptyText(QStringLiteral("Drop takes here"));
    m_board->addEmptyAction(button);
    QVERIFY(!button->isVisible());
    m_board->setCards({});
    QTRY_VERIFY(button->isVisible());
    QSignalSpy clicked(button, &QPushButton::clicked);
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(clicked.size(), 1);
    QCOMPARE(m_board->insertionAt({5, 5}), 0);
}

void TestStoryboard::endsOfARangeAreDraggedAndMovedByKeys()
{
    RangeStrip strip;
    strip.setFrameCount(100);
    strip.setRange(20, 59);
    strip.resize(412, 28);
    strip.show();
    QVERIFY(QTest::qWaitForWindowExposed(&strip));
    QSignalSpy edited(&strip, &RangeStrip::rangeEdited);
    QTest::mousePress(&strip, Qt::LeftButton, {}, strip.startHandle());
    QTest::mouseMove(&strip, strip.startHandle() + QPoint(40, 0));
    QTest::mouseRelease(&strip, Qt::LeftButton, {}, strip.startHandle());
    QCOMPARE(strip.range(), (std::pair{30, 59}));
    QVERIFY(!edited.first().at(2).toBool());
    QCOMPARE(edited.last(), (QVariantList{30, 59, true}));
    strip.setFocus();
    QTest::keyClick(&strip, Qt::Key_Left);
    QCOMPARE(strip.range(), (std::pair{29, 59}));
    QTest::keyClick(&strip, Qt::Key_Down);
    QTest::keyClick(&strip, Qt::Key_PageUp);
    QCOMPARE(strip.range(), (std::pair{29, 69}));
    QTest::keyClick(&strip, Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(edited.last(), (QVariantList{30, 70, true}));
}

void TestStoryboard::escapePutsARangeBack()
{
    RangeStrip strip;
    strip.setFrameCount(100);
    strip.setRange(20, 59);
    strip.resize(412, 28);
    strip.show();
    QVERIFY(QTest::qWaitForWindowExposed(&strip));
    strip.setFocus();
    QSignalSpy edited(&strip, &RangeStrip::rangeEdited);
    QTest::mousePress(&strip, Qt::LeftButton, {}, strip.endHandle());
    QTest::mouseMove(&strip, strip.endHandle() + QPoint(40, 0));
    QCOMPARE(strip.range(), (std::pair{20, 69}));
    QTest::keyClick(&strip, Qt::Key_Escape);
    QCOMPARE(edited.last(), (QVariantList{20, 59, true}));
}

QUADRILLE_QT_TEST(TestStoryboard);
#include "tst_storyboard.moc"
