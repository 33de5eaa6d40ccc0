// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/eventcounter.h"
#include "tests/qt/registry.h"
#include "widgets/controls/elidedlabel.h"
#include "widgets/timeline/playbackbar.h"

#include <QLabel>
#include <QSet>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

using namespace quadrille;
using namespace quadrille::widgets;

class TestPlaybackBar : public QObject
{
    Q_OBJECT
private slots:
    void noNumberIsCutInANarrowBar();
    void growingNumbersOfAsManyDigitsMoveNothing();
    void noFrameBehindTheLastCanBeEntered();
};

void TestPlaybackBar::noNumberIsCutInANarrowBar()
{
    PlaybackBar bar;
    bar.setFrameCount(40);
    bar.setFps(25);
    bar.show();
    const auto* time = bar.findChild<ElidedLabel*>(QStringLiteral("timeLabel"));
    const auto* rate = bar.findChild<QLabel*>(QStringLiteral("fpsLabel"));
    QSet<QString> times;
    const int least = bar.minimumSizeHint().width();
    for (int width = 700; width >= least; width -= 10) {
        bar.resize(width, bar.sizeHint().height());
        // Numbers change while it plays.
        for (const int frame : {0, 39}) {
            bar.setCurrentFrame(frame);
            QCoreApplication::sendPostedEvents();
            const auto needed = [](const auto& number) {
                return number.fontMetrics().horizontalAdvance(number.text());
            };
            QVERIFY2(needed(*time) <= time->width(), qPrintable(time->text()));
            QVERIFY2(!rate->isVisible() || needed(*rate) <= rate->width(), qPrintable(rate->text()));
        }
        times += time->text();
        QCOMPARE(bar.width(), width);
    }
    QCOMPARE(times, (QSet<QString>{"of 39 · 1.56 / 1.56 s", "1.56 / 1.56 s", "1.56 s"}));
    QVERIFY(!rate->isVisible());
}

void TestPlaybackBar::growingNumbersOfAsManyDigitsMoveNothing()
{
    PlaybackBar bar;
    bar.setFps(50);
    bar.setFrameCount(120);
    bar.resize(700, bar.sizeHint().height());
    bar.show();
    QCoreApplication::sendPostedEvents();
    test::EventCounter layouts(bar, QEvent::LayoutRequest);
    for (int frame = 120; frame < 140; ++frame) {
        bar.setFrameCount(frame + 1);
        bar.setCurrentFrame(frame);
        QCoreApplication::sendPostedEvents();
    }
    QCOMPARE(layouts.count(), 0);
    bar.setFrameCount(1200);
    QCoreApplication::sendPostedEvents();
    QVERIFY(layouts.count() > 0);
}

void TestPlaybackBar::noFrameBehindTheLastCanBeEntered()
{
    PlaybackBar bar;
    bar.setFrameCount(51);
    bar.show();
    auto* field = bar.findChild<QSpinBox*>(QStringLiteral("frameField"));
    QSignalSpy entered(&bar, &PlaybackBar::frameEntered);
    const auto enter = [&](const QString& text) {
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    };
    enter("20");
    QCOMPARE(entered.back().front().toInt(), 20);
    enter("88");
    QCOMPARE(entered.back().front().toInt(), 50);
    QCOMPARE(field->value(), 50);
    bar.setCurrentFrame(60); // the playhead may stand behind it
    QCOMPARE(field->value(), 60);
    bar.setFrameCount(31);
    QCOMPARE(field->value(), 30);
    QCOMPARE(entered.size(), 2);
}

QUADRILLE_QT_TEST(TestPlaybackBar);
#include "tst_playbackbar.moc"
