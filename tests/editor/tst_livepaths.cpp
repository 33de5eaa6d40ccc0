// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Paths of animations that are followed live.
#include "livefixture.h"
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"

#include <QComboBox>

namespace quadrille {

class LivePathsTest : public LiveFixture
{
    Q_OBJECT

private:
    /// The project with an animation along a path of 1.5 m, and an obstacle on the ground; chooses the path.
    void followPathBeside(const Vec2d& obstacle)
    {
        open();
        Project project = document().project();
        AnimationEntry& tour = project.animations.emplace_back();
        tour.name = "tour";
        PathEntry path;
        path.points = {{1, 0, 1}, {1, 0, 2.5}};
        path.obstacles = {{.corners = {obstacle}, .radius = 0.2}};
        tour.constraints = {path};
        document().recover(project, document().file());
        QTRY_VERIFY(session().isReady());
        QTRY_COMPARE(paths().count(), 2);
        QVERIFY(paths().isEnabled());
        choosePath(1);
    }
    QComboBox& paths() { return *m_window->findChild<QComboBox*>(QStringLiteral("livePath")); }
    void choosePath(int index)
    {
        paths().setCurrentIndex(index);
        emit paths().activated(index);
    }

private slots:
    void pathsOfAnimationsAreFollowed()
    {
        followPathBeside({3, 2});
        QVERIFY(session().follower() != nullptr);
        QCOMPARE(paths().currentIndex(), 1);
        QVERIFY((session().state().track.root.shift - Vec2d(1, 1)).norm() < 1e-9);
        session().startRecording();
        session().pause();
        for (int t = 0; t < 3000 && !session().follower()->isDone(); ++t)
            session().step();
        // To the end, if beside it: the figure sways and cannot turn.
        QVERIFY(session().follower()->isDone());
        QVERIFY(session().follower()->walked() >= session().follower()->route().length());
        const std::optional<LiveEntry> entry = session().stopRecording();
        QVERIFY(entry.has_value());
        QVERIFY((*entry->position - Vec2d(1, 1)).norm() < 1e-9);
        // What was recorded leads there without the path.
        const Vec2d end = session().state().track.root.shift;
        QVERIFY(session().load(*entry, document().project().settings.axes));
        QVERIFY(session().follower() == nullptr);
        QCOMPARE(paths().currentIndex(), 0);
        session().goTo(session().tickCount());
        QVERIFY((session().state().track.root.shift - end).norm() < 1e-9);
        // Who steers leaves the path.
        choosePath(1);
        play(20);
        session().want(0);
        QVERIFY(session().follower() == nullptr);
        QCOMPARE(paths().currentIndex(), 0);
        choosePath(1);
        play(20);
        session().goTo(5);
        play(100);
        QVERIFY(session().follower()->walked() > 0.1);
        // Begun anew, it goes the same way.
        session().restart();
        session().pause();
        play(60);
        const LiveState there = session().state();
        QCOMPARE(there.tick, std::int64_t{60});
        const double walked = session().follower()->walked();
        session().restart();
        session().pause();
        play(60);
        QVERIFY(session().state() == there);
        QCOMPARE(session().follower()->walked(), walked);
        // What is recorded from an earlier tick on goes on from where it was then.
        while (session().follower()->walked() < 1.2)
            play(1);
        const std::int64_t far = session().state().tick;
        const double wayThere = session().follower()->walked();
        play(10);
        session().goTo(far);
        session().startRecording();
        session().pause();
        play(1);
        QVERIFY(session().follower()->walked() >= wayThere);
        QVERIFY(session().follower()->walked() < wayThere + 0.1);
        session().stopRecording();
        choosePath(0);
        QVERIFY(session().follower() == nullptr);
        // What is being recorded is kept.
        session().startRecording();
        session().pause();
        play(10);
        choosePath(1);
        QVERIFY(!session().isRecording());
        QCOMPARE(document().project().lives.size(), std::size_t{1});
        QVERIFY(session().follower() != nullptr);
    }

    void pathsThatCannotBeFollowedSayWhy()
    {
        followPathBeside({1, 1});
        QVERIFY(session().follower() == nullptr);
        QCOMPARE(paths().currentIndex(), 0);
        QVERIFY(workspace().view().message().text().contains(QStringLiteral("stands at the start")));
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::LivePathsTest);
#include "tst_livepaths.moc"
