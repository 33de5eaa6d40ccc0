// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/timeline/paintedrate.h"
#include "widgets/timeline/playbackclock.h"

#include <QTest>
#include <set>

using quadrille::widgets::PaintedRate;
using quadrille::widgets::PlaybackClock;

class TestPlaybackClock : public QObject
{
    Q_OBJECT
private slots:
    void frameFollowsTime();
    void slowDrawingLeavesFramesOutAndKeepsTime();
    void loopsWithinTheRange();
    void turnsRoundAtTheEndsWhenItGoesBackAndForth();
    void playsBackwards();
    void stopsAtTheEndWhenNotLooping();
    void reportsTheRateReached();
    void reportsNoRateFromPicturesThatFollowEachOtherAtOnce();
    void aHaltLowersTheRate();
    void saysWhenTheNextFrameIsDue();
};

namespace {

PlaybackClock clockOf(std::int64_t first, std::int64_t last, double fps = 25)
{
    PlaybackClock clock;
    clock.setFps(fps);
    clock.setRange(first, last);
    return clock;
}

} // namespace

void TestPlaybackClock::frameFollowsTime()
{
    auto clock = clockOf(0, 99);
    clock.start(10, 5.0);
    QCOMPARE(clock.frameAt(5.0), 10);
    QCOMPARE(clock.frameAt(5.039), 10);
    QCOMPARE(clock.frameAt(5.04), 11);
    QCOMPARE(clock.frameAt(6.0), 35);
}

void TestPlaybackClock::slowDrawingLeavesFramesOutAndKeepsTime()
{
    auto clock = clockOf(0, 999, 30);
    clock.start(0, 0);
    std::set<std::int64_t> seen;
    for (int picture = 0; picture <= 10; ++picture) // 10 pictures a second
        seen.insert(clock.frameAt(picture * 0.1));
    QCOMPARE(seen.size(), 11U);
    QCOMPARE(*seen.rbegin(), 30);
}

void TestPlaybackClock::loopsWithinTheRange()
{
    auto clock = clockOf(10, 14, 10);
    clock.start(13, 0);
    QCOMPARE(clock.frameAt(0.1), 14);
    QCOMPARE(clock.frameAt(0.2), 10);
    QCOMPARE(clock.frameAt(1.2), 10);
    QVERIFY(clock.isPlaying());
}

void TestPlaybackClock::turnsRoundAtTheEndsWhenItGoesBackAndForth()
{
    auto clock = clockOf(10, 13, 10);
    clock.setBackAndForth(true);
    clock.start(11, 0);
    for (const auto& [step, frame] : {std::pair{1, 12}, {2, 13}, {3, 12}, {4, 11}, {5, 10}, {6, 11}, {8, 13}})
        QCOMPARE(clock.frameAt(step * 0.1), frame);
    clock.start(11, 0, -1);
    for (const auto& [step, frame] : {std::pair{1, 10}, {2, 11}, {4, 13}, {5, 12}})
        QCOMPARE(clock.frameAt(step * 0.1), frame);
    clock.setRange(4, 4);
    clock.start(4, 0);
    QCOMPARE(clock.frameAt(0.7), 4);
}

void TestPlaybackClock::playsBackwards()
{
    auto clock = clockOf(0, 9, 10);
    clock.start(1, 0, -2);
    QCOMPARE(clock.frameAt(0.05), 0);
    QCOMPARE(clock.frameAt(0.1), 9);
}

void TestPlaybackClock::stopsAtTheEndWhenNotLooping()
{
    auto clock = clockOf(0, 9, 10);
    clock.setLooping(false);
    clock.start(8, 0);
    QCOMPARE(clock.frameAt(0.1), 9);
    QVERIFY(clock.isPlaying());
    QCOMPARE(clock.frameAt(0.2), 9);
    QVERIFY(!clock.isPlaying());
}

void TestPlaybackClock::reportsTheRateReached()
{
    PaintedRate rate;
    QVERIFY(!rate.reached());
    for (int picture = 0; picture < 40; ++picture)
        rate.painted(picture / 2, picture * 0.05); // every frame drawn twice
    QVERIFY(std::abs(rate.reached().value() - 10.0) < 1e-6);
    QCOMPARE(rate.report(2.0), rate.reached());
    QVERIFY(!rate.report(2.4)); // cannot be read
    QVERIFY(rate.report(2.5));
    rate.restart();
    QCOMPARE(rate.report(2.6), 0.0); // not known yet
}

void TestPlaybackClock::reportsNoRateFromPicturesThatFollowEachOtherAtOnce()
{
    PaintedRate rate;
    for (int frame = 0; frame < 20; ++frame)
        rate.painted(frame, frame * 0.001);
    QVERIFY(!rate.reached());
    // The same burst within a second of play does not make it quicker than it is.
    for (int frame = 20; frame < 45; ++frame)
        rate.painted(frame, 0.02 + (frame - 19) * 0.04);
    QVERIFY(rate.reached().value() < 46.0);
    for (int frame = 45; frame < 70; ++frame)
        rate.painted(frame, 0.02 + (frame - 19) * 0.04);
    QVERIFY(std::abs(rate.reached().value() - 25.0) < 1e-6);
}

void TestPlaybackClock::aHaltLowersTheRate()
{
    PaintedRate rate;
    for (int frame = 0; frame < 50; ++frame)
        rate.painted(frame, frame * 0.04);
    rate.painted(100, 4.0);
    QVERIFY(rate.reached().value() < 1.0);
}

void TestPlaybackClock::saysWhenTheNextFrameIsDue()
{
    auto clock = clockOf(0, 99);
    clock.start(0, 0);
    QVERIFY(std::abs(clock.untilNext(0.05) - 0.03) < 1e-9);
    QVERIFY(std::abs(clock.untilNext(0.04) - 0.04) < 1e-9);
}

QUADRILLE_QT_TEST_IN(QCoreApplication, TestPlaybackClock);
#include "tst_playbackclock.moc"
