// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/timeline/playbackbar.h"

#include <QLabel>
#include <QSet>
#include <QTest>

using namespace quadrille::widgets;

class TestPlaybackBar : public QObject
{
    Q_OBJECT
private slots:
    void noNumberIsCutInANarrowBar();
};

void TestPlaybackBar::noNumberIsCutInANarrowBar()
{
    PlaybackBar bar;
    bar.setFrameCount(40);
    bar.setFps(25);
    bar.show();
    const auto* time = bar.findChild<QLabel*>(QStringLiteral("timeLabel"));
    const auto* rate = bar.findChild<QLabel*>(QStringLiteral("fpsLabel"));
    QSet<QString> times;
    const int least = bar.minimumSizeHint().width();
    for (int width = 700; width >= least; width -= 10) {
        bar.resize(width, bar.sizeHint().height());
        // Numbers change while it plays.
        for (const int frame : {0, 39}) {
            bar.setCurrentFrame(frame);
            QCoreApplication::sendPostedEvents();
            for (const QLabel* number : {time, rate}) {
                if (!number->isVisible())
                    continue;
                const int needed = number->fontMetrics().horizontalAdvance(number->text());
                QVERIFY2(needed <= number->width(), qPrintable(number->text()));
            }
        }
        times += time->text();
        QCOMPARE(bar.width(), width);
    }
    QCOMPARE(times, (QSet<QString>{"of 39 · 1.56 / 1.56 s", "1.56 / 1.56 s", "1.56 s"}));
    QVERIFY(!rate->isVisible());
}

QUADRILLE_QT_TEST(TestPlaybackBar);
#include "tst_playbackbar.moc"
