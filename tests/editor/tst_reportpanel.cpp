// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What was wanted and obtained: on the screen, on the clipboard, in files.
#include "animatedproject.h"
#include "editor/commands/animationedits.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/animate/report.h"
#include "editor/workspaces/animate/reportpanel.h"
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/graph/linechart.h"

#include <QClipboard>
#include <QDockWidget>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QToolButton>
#include <QTreeWidget>

namespace quadrille {

class ReportPanelTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    const AnimationResult& result() { return *context().animations.result("dance"); }
    QTreeWidget& table() { return *test::find<QTreeWidget>("reportTable"); }
    bool waitForResult() { return test::waitForResult(context(), "dance"); }
    void set(const std::function<void(AnimationEntry&)>& edit)
    {
        AnimationEntry entry = *context().document.animation("dance");
        edit(entry);
        setAnimation(context().document, "dance", "Edit", "edit", entry);
        QVERIFY(waitForResult());
    }
    /// The texts of the first row that is called so.
    QStringList row(const QString& what)
    {
        for (int i = 0; i < table().topLevelItemCount(); ++i) {
            const QTreeWidgetItem* item = table().topLevelItem(i);
            if (item->text(0) == what)
                return {item->text(1), item->text(2)};
        }
        return {};
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        test::writeSwayingTakes(m_folder.path());
    }

    void init()
    {
        m_window = test::openAnimated(m_folder.path());
        QVERIFY(m_window != nullptr);
        m_window->resize(1000, 700);
        test::find<QDockWidget>("reportDock")->raise();
        QVERIFY(test::activate(*m_window));
    }

    void cleanup()
    {
        context().document.reset({});
        m_window.reset();
    }

    void tellsWhatIsWantedAndObtained()
    {
        QVERIFY(waitForResult());
        QTRY_VERIFY(table().isVisible());
        QVERIFY(!test::find<QLabel>("reportEmpty")->isVisible());
        const double fps = context().document.project().settings.fps;
        const QString duration =
            QLocale().toString(static_cast<double>(result().sequence.frameCount()) / fps, 'f', 2);
        QCOMPARE(row("Duration"), QStringList({"", duration + " s"}));
        QCOMPARE(row("Transitions").last(), QString::number(result().walk.solution.walk.transitionCount()));
        QVERIFY(!row("Proven best in the Essential graph").last().isEmpty());
        QVERIFY(!test::find<widgets::LineChart>("deviationChart")->isVisible());
        // Keys that cannot be met in time are marked.
        set([](AnimationEntry& entry) {
            entry.constraints = {KeyEntry{.sequence = "first", .frame = FrameIndex(5), .time = 0},
                                 KeyEntry{.sequence = "third", .frame = FrameIndex(50), .time = 0.2}};
        });
        QCOMPARE(result().walk.solution.keys.size(), 2U);
        QCOMPARE(row("Key: 2").first(), QLocale().toString(0.2, 'f', 2) + " s");
        const auto rows = reportOf(result(), fps);
        const auto key = std::ranges::find_if(
            rows, [](const ReportRow& each) { return each.what == "Key" && each.name == "2"; });
        QVERIFY(key != rows.end());
        QCOMPARE(*key->obtained, static_cast<double>(result().walk.solution.keys[1].obtained) / fps);
        QCOMPARE(key->isOff, std::abs(*key->obtained - 0.2) * fps > 0.5);
    }

    void showsTheDeviationFromThePathOverTime()
    {
        QVERIFY(waitForResult());
        set([](AnimationEntry& entry) {
            PathEntry path;
            path.points = {{0, 0, 0}, {0, 0, 0.3}, {0.2, 0, 0.7}};
            entry.constraints = {path};
        });
        auto* chart = test::find<widgets::LineChart>("deviationChart");
        QTRY_VERIFY(chart->isVisible());
        const auto& points = chart->series().front().points;
        QCOMPARE(static_cast<std::int64_t>(points.size()), result().plan.frameCount());
        double greatest = 0;
        double sum = 0;
        for (const QPointF& point : points) {
            greatest = std::max(greatest, point.y() / 100);
            sum += point.y() / 100;
        }
        const WalkSolution& solution = result().walk.solution;
        QVERIFY(std::abs(greatest - solution.greatestDeviation) < 1e-3);
        QVERIFY(std::abs(sum / static_cast<double>(points.size()) - solution.meanDeviation) < 1e-3);
        // The marker is the playhead, both ways.
        auto& player = m_window->animate().player();
        player.goTo(3);
        QTRY_VERIFY(chart->marker().has_value());
        QCOMPARE(*chart->marker(), 3 / context().document.project().settings.fps);
        const QPoint from = chart->positionOf({*chart->marker(), greatest * 50}).toPoint();
        const QPoint to = chart->positionOf({points.back().x(), greatest * 50}).toPoint();
        QTest::mousePress(chart, Qt::LeftButton, {}, from);
        QTest::mouseMove(chart, (from + to) / 2);
        QTest::mouseMove(chart, to);
        QTest::mouseRelease(chart, Qt::LeftButton, {}, to);
        QTRY_VERIFY(player.frame().value >= result().plan.frameCount() - 2);
    }

    void walksOnTheWayTellWhatWasAskedToo()
    {
        QVERIFY(waitForResult());
        int onTheWay = 0;
        bool areComplete = true;
        const QObject listener;
        connect(&context().animations, &AnimationResults::changed, &listener, [&] {
            const auto now = context().animations.result("dance");
            onTheWay += now->isFinal ? 0 : 1;
            areComplete &= now->walk.constraints.actions.size() == now->walk.solution.actions.size();
        });
        set([](AnimationEntry& entry) {
            PathEntry path;
            path.points = {{0, 0, 0}, {0, 0, 1}, {0.4, 0, 2}};
            entry.constraints.emplace_back(path);
            entry.search.budget = 200'000;
        });
        QVERIFY(onTheWay > 0);
        QVERIFY(areComplete);
    }

    void isCopiedAndSaved()
    {
        QVERIFY(waitForResult());
        QTRY_VERIFY(table().isVisible());
        QTest::mouseClick(test::find<QToolButton>("tool.report.copy"), Qt::LeftButton);
        const QString copied = QGuiApplication::clipboard()->text();
        QVERIFY(copied.startsWith("what,name,wanted,obtained,unit\nDuration,,,"));
        QCOMPARE(copied.count('\n'), table().topLevelItemCount() + 1);
        auto* panel = test::find<ReportPanel>("reportPanel");
        const QString file = m_folder.filePath("report.csv");
        panel->save(file, false);
        QFile saved(file);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QCOMPARE(QString::fromUtf8(saved.readAll()), copied);
        const QString frames = m_folder.filePath("frames.csv");
        panel->save(frames, true);
        QFile savedFrames(frames);
        QVERIFY(savedFrames.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = savedFrames.readAll().split('\n');
        QCOMPARE(lines.size(), result().sequence.frameCount() + 2);
        QVERIFY(lines[1].startsWith("0,0,first,"));
        // What cannot be written says so here.
        panel->save(m_folder.filePath("report.csv/report.csv"), false);
        auto* strip = test::find<widgets::MessageStrip>("reportMessage");
        QVERIFY(strip->isVisible() && !strip->text().isEmpty());
    }

    void saysWhatComesHere()
    {
        set([](AnimationEntry& entry) { entry.post.steps.mirror = false; });
        context().selection.selectAnimations({});
        AnimationEntry nothing{.name = "nothing", .character = "spire"};
        context().selection.selectAnimations({addAnimation(context().document, nothing)});
        QTRY_VERIFY(test::find<QLabel>("reportEmpty")->isVisible());
        QVERIFY(!table().isVisible());
        QVERIFY(!context().actions.action("report.save")->isEnabled());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::ReportPanelTest);
#include "tst_reportpanel.moc"
