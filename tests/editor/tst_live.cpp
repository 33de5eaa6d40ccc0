// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Motion spaces that are played live: rewound, recorded, played again.
#include "editor/application/projectfiles.h"
#include "editor/commands/changeproject.h"
#include "editor/commands/projectedits.h"
#include "exporting.h"
#include "livefixture.h"
#include "model/core/file.h"
#include "model/project/results/rebuild.h"
#include "tests/qt/registry.h"
#include "widgets/controls/elidedlabel.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/timeline/playbackbar.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>

namespace quadrille {

class LiveTest : public LiveFixture
{
    Q_OBJECT

private slots:
    void spacePlaysAndPauses()
    {
        open();
        const auto* button = workspace().view().playback().findChild<QToolButton*>("play");
        QVERIFY(button != nullptr);
        const QString toPlay = button->toolTip();
        const auto* time = workspace().view().playback().findChild<widgets::ElidedLabel*>("timeLabel");
        const auto* frame = workspace().view().playback().findChild<QSpinBox*>("frameField");
        QStringList behind; // numbers of ticks that are not those that there are
        play(700);          // longer than the ruler is at first
        const QObject listener;
        connect(&session(), &LiveSession::ticked, &listener, [&] {
            if (!time->text().contains(QString::number(session().tickCount())) ||
                frame->value() != session().state().tick)
                behind += time->text();
        });
        action("play.toggle")->trigger();
        QVERIFY(session().isRunning());
        QVERIFY(button->toolTip() != toPlay);
        QTRY_VERIFY(session().tickCount() > 720);
        const auto* rate = workspace().view().playback().findChild<QLabel*>("fpsLabel");
        QTRY_VERIFY(rate->text().contains(" of ")); // pictures a second that are reached
        action("play.toggle")->trigger();
        QVERIFY(!session().isRunning());
        QVERIFY(!rate->text().contains(" of "));
        QVERIFY2(behind.isEmpty(), qPrintable(behind.join('\n')));
        QCOMPARE(workspace().view().timeline().currentFrame(), static_cast<int>(session().state().tick));
        m_window->workspaces().select("sequences");
        m_window->workspaces().select("live");
        action("live.run")->trigger();
        QVERIFY(session().isRunning());
        m_window->workspaces().select("sequences");
        QVERIFY(!session().isRunning());
    }

    void everyTickCanBeGoneBackTo()
    {
        open();
        play(40);
        session().want(1);
        play(80);
        const auto pose = [this] {
            const auto values = session().pose();
            return std::vector<float>(values.begin(), values.end());
        };
        const std::vector<float> last = pose();
        auto* tree = test::find<QTreeWidget>("rewindTree");
        QTRY_COMPARE(tree->topLevelItemCount(), 1);
        QVERIFY(tree->topLevelItem(0)->childCount() >= 2);
        tree->setCurrentItem(tree->topLevelItem(0));
        QCOMPARE(session().state().tick, std::int64_t{41});
        QVERIFY(session().isReplaying());
        // It plays again as it was.
        play(79);
        QCOMPARE(session().tickCount(), std::int64_t{120});
        QCOMPARE(pose(), last);
        auto& bar = workspace().view().playback();
        emit bar.stepRequested(-5);
        QCOMPARE(session().state().tick, std::int64_t{115});
        QVERIFY(session().lastDecision() != nullptr);
        action("play.next")->trigger();
        QCOMPARE(session().state().tick, std::int64_t{116});
        action("play.last")->trigger();
        QCOMPARE(session().state().tick, std::int64_t{120});
        action("play.first")->trigger();
        QCOMPARE(session().state().tick, std::int64_t{0});
        QVERIFY(session().lastDecision() == nullptr);
        // Who steers takes over.
        session().goTo(60);
        session().want(0);
        QCOMPARE(session().tickCount(), std::int64_t{60});
        play(100);
        QCOMPARE(session().state().track.space, std::size_t{0});
    }

    void recordingsArePerformancesOfTheProject()
    {
        open();
        play(10);
        action("live.record")->trigger();
        QVERIFY(session().isRecording());
        session().pause();
        play(60);
        session().want(1);
        play(60);
        const auto shown = session().pose();
        const std::vector<float> last(shown.begin(), shown.end());
        QCOMPARE(session().recordedTicks(), session().tickCount() - 10);
        action("live.record")->trigger();
        QVERIFY(!session().isRecording());
        QCOMPARE(document().project().lives.size(), std::size_t{1});
        const LiveEntry entry = document().project().lives.front();
        QCOMPARE(entry.from, std::int64_t{10});
        QVERIFY(entry.ticks >= 130);
        // It is selected, and plays again from its first frame.
        QCOMPARE(context().selection.current().name, QString::fromStdString(entry.name));
        QCOMPARE(session().state().tick, std::int64_t{10});
        session().goTo(130);
        const auto again = session().pose();
        QVERIFY(std::ranges::equal(again, last));
        QVERIFY(action("live.export")->isEnabled());
        action("live.addSequence")->trigger();
        QCOMPARE(document().project().sequences.back().source, "clip:live/" + entry.name);
        // It is computed for whoever opens it.
        QVERIFY(test::waitForSequence(*m_window, QString::fromStdString(entry.name)));
        action("file.export")->trigger();
        QTRY_VERIFY(test::exportDialog() != nullptr);
        QCOMPARE(test::find<QComboBox>("exportClip")->currentData().toString(),
                 QString::fromStdString("live/" + entry.name));
        // Its frames are known before it is computed.
        QCOMPARE(test::find<QSpinBox>("exportLast")->value(),
                 static_cast<int>((entry.ticks - entry.from) / entry.ticksPerFrame));
        QTest::keyClick(test::exportDialog(), Qt::Key_Escape);
        QTRY_VERIFY(test::exportDialog() == nullptr);
        document().undo();
        document().undo();
        QVERIFY(document().project().lives.empty());
        document().undoStack()->redo();
        QCOMPARE(document().project().lives.front(), entry);
        document().undo();
    }

    void recordingsHaveTheSettingsOfWhatTheyGoOnFrom()
    {
        open();
        LiveEntry entry;
        entry.name = "first";
        entry.spaces = {"steady", "walk"};
        entry.inputs = {{0, {.space = 1, .parameters = {0.8}}}};
        entry.ticks = 40;
        entry.position = Vec2d(3, 2);
        entry.heading = 30;
        entry.fadeSeconds = 0.2;
        entry.latencyWeight = 9;
        entry.correctsContacts = false;
        QVERIFY(session().load(entry, document().project().settings.axes));
        session().goTo(40);
        session().startRecording();
        session().pause();
        session().want(1);
        play(60);
        const auto shown = session().pose();
        const std::vector<float> last(shown.begin(), shown.end());
        const std::optional<LiveEntry> recorded = session().stopRecording();
        QVERIFY(recorded.has_value());
        QCOMPARE(recorded->position, entry.position);
        QCOMPARE(recorded->heading, 30.0);
        QCOMPARE(recorded->fadeSeconds, 0.2);
        QCOMPARE(recorded->latencyWeight, 9.0);
        QVERIFY(!recorded->correctsContacts);
        QVERIFY(session().load(*recorded, document().project().settings.axes));
        session().goTo(recorded->ticks);
        QVERIFY(std::ranges::equal(session().pose(), last));
    }

    void recordingsAreKeptWhateverHappens()
    {
        open();
        session().startRecording();
        session().pause();
        play(30);
        // Edits of other things go on beside it.
        Project project = document().project();
        project.settings.cacheMegabytes += 1;
        const std::int64_t ticks = session().tickCount();
        document().push(std::make_unique<ChangeProject>(document(), "edit", project));
        QTRY_COMPARE(context().liveGraphs.resultState("")->phase, ResultPhase::Ready);
        QVERIFY(session().isRecording());
        QCOMPARE(session().tickCount(), ticks);
        // Motion spaces that were edited are another graph; what was steered in the old one is kept.
        project = document().project();
        project.motionSpaces.back().tolerance = 0.03;
        const OpenedLiveGraphPointer before = session().graph();
        document().push(std::make_unique<ChangeProject>(document(), "edit", project));
        QTRY_COMPARE(document().project().lives.size(), std::size_t{1});
        QCOMPARE(document().project().lives.front().ticks, ticks);
        QTRY_VERIFY(session().graph() != before);
        session().startRecording();
        play(10);
        QVERIFY(m_window->isWindowModified());
        document().undoStack()->setClean();
        session().restart();
        QVERIFY(!session().isRecording());
        // Where another project is to be opened, it is an edit that one may save before.
        session().startRecording();
        session().pause();
        play(10);
        document().undoStack()->setClean();
        QVERIFY(!m_window->isWindowModified());
        bool isAsked = false;
        QTimer::singleShot(0, this, [&] {
            auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            isAsked = question != nullptr;
            if (isAsked)
                question->button(QMessageBox::Cancel)->click();
        });
        QVERIFY(!m_window->files().mayClose());
        QVERIFY(isAsked);
        QVERIFY(!session().isRecording());
        QCOMPARE(document().project().lives.size(), std::size_t{2});
        QCOMPARE(document().project().lives.back().ticks, std::int64_t{10});
        // Another project has nothing of it.
        session().startRecording();
        play(10);
        document().reset(Project());
        QVERIFY(!session().isReady());
        QVERIFY(document().project().lives.empty());
    }

    void takesBecomeAPerformanceThatIsBuiltToTheSameBytes()
    {
        open();
        // A space of three takes.
        writeTake("usual", {.period = 18, .step = 0.045, .size = 1.3});
        SequenceEntry usual;
        usual.name = "usual";
        usual.source = m_folder->filePath("usual").toStdString();
        addSequences(document(), {usual});
        QVERIFY(test::waitForSequence(*m_window, "usual"));
        context().selection.selectSequences({"slow", "usual", "fast"});
        action("motionSpaces.new")->trigger();
        QCOMPARE(document().project().motionSpaces.size(), std::size_t{3});
        QCOMPARE(document().project().motionSpaces.back().takes.size(), std::size_t{3});
        QTRY_VERIFY(session().isReady() && session().graph()->graph->spaces.size() == 3);
        // Five seconds are steered and recorded.
        session().want(2);
        session().startRecording();
        session().pause();
        const auto fps = document().project().settings.fps;
        const int ticks = static_cast<int>(5 * fps) * 2;
        play(ticks / 3);
        session().setParameter(0, session().steering().values()[0] * 1.3);
        play(ticks / 3);
        session().want(0);
        play(ticks - 2 * (ticks / 3));
        // Rewound, another way is gone from there.
        session().goTo(ticks / 2);
        session().want(1);
        play(ticks / 2);
        const std::vector<float> seen(session().pose().begin(), session().pose().end());
        action("live.record")->trigger();
        Project project = document().project();
        LiveEntry& tour = project.lives.back();
        QCOMPARE(tour.ticks, std::int64_t{ticks});
        tour.correctsContacts = false;
        const std::string clip = "live/" + tour.name;
        ExportEntry& file = project.exports.emplace_back();
        file.name = "tour";
        file.what = clip;
        file.format = "npy";
        file.path = m_folder->filePath("out/tour.npy").toStdString();
        document().push(std::make_unique<ChangeProject>(document(), "edit", project));
        document().save();
        // What was seen is what is written, however often.
        const auto bytes = [&](bool force) {
            QFile::remove(QString::fromStdString(file.path));
            rebuild(document().project(), document().file(), {.targets = {"exports"}, .force = force}, {});
            return std::string(readFile(file.path).text());
        };
        const std::string first = bytes(false);
        QVERIFY(first == bytes(true));
        QVERIFY(first.ends_with(
            std::string_view(reinterpret_cast<const char*>(seen.data()), seen.size() * sizeof(float))));
    }

    void renamedSpacesPlayOn()
    {
        open();
        play(40);
        const std::int64_t ticks = session().tickCount();
        const OpenedLiveGraphPointer before = session().graph();
        QVERIFY(renameEntry(document(), {Section::MotionSpaces, "walk"}, "stride"));
        QTRY_VERIFY(session().graph() != before);
        QCOMPARE(session().graph()->spaces.front(), std::string("stride"));
        QCOMPARE(session().tickCount(), ticks);
        play(1);
        QCOMPARE(session().tickCount(), ticks + 1);
        // A recording names the space as it is called now.
        session().startRecording();
        session().pause();
        play(2);
        QCOMPARE(session().stopRecording()->spaces.front(), std::string("stride"));
    }

    void whatFailsIsMendedInTheProperties()
    {
        open();
        Project project = document().project();
        project.motionSpaces.front().takes[1].range = FrameRange{FrameIndex(0), FrameIndex(1)};
        document().push(std::make_unique<ChangeProject>(document(), "edit", project));
        auto& message = workspace().view().message();
        QTRY_VERIFY(message.isVisible() && message.kind() == widgets::MessageStrip::Kind::Error);
        auto* properties = test::find<QDockWidget>("propertiesDock");
        QVERIFY(!properties->isVisible());
        emit message.actionTriggered();
        QVERIFY(properties->isVisible());
        QCOMPARE(context().selection.current(), (EntryRef{Section::MotionSpaces, "walk"}));
        document().undo();
        QTRY_VERIFY(session().isReady());
    }

    void projectsWithoutSpacesAreExplained()
    {
        Project project;
        SequenceEntry& sequence = project.sequences.emplace_back();
        sequence.name = "slow";
        sequence.source = m_folder->filePath("slow").toStdString();
        document().reset(project);
        QVERIFY(test::waitForSequence(*m_window, "slow"));
        m_window->workspaces().select("live");
        QVERIFY(workspace().view().message().isVisible());
        QVERIFY(!action("live.run")->isEnabled());
        QVERIFY(!action("live.export")->isEnabled());
        QVERIFY(!action("live.addSequence")->isEnabled());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::LiveTest);
#include "tst_live.moc"
