// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Stories of the Sequences workspace, with a small project and real keys and clicks.
#include "editor/commands/projectedits.h"
#include "editor/documents/labelcolors.h"
#include "editor/playback/clipscene.h"
#include "editor/playback/player.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editortest.h"
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"

#include <QDir>
#include <QImage>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QSet>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

namespace quadrille {

namespace {

constexpr int framesOfTake = 30;

/// Two flat feet with a shin each, facing +z; the left one is lifted in frames 10 … 19.
void writeStepping(const QString& folder)
{
    QDir().mkpath(folder);
    for (int f = 0; f < framesOfTake; ++f) {
        std::ofstream file(QStringLiteral("%1/step_%2.obj").arg(folder).arg(f).toStdString());
        for (const double side : {-0.2, 0.2}) {
            const double height = f >= 10 && f < 20 && side > 0 ? 0.3 : 0.0;
            for (const double z : {0.0, 0.1, 0.2}) {
                file << "v " << side - 0.05 << ' ' << height << ' ' << z << '\n';
                file << "v " << side + 0.05 << ' ' << height << ' ' << z << '\n';
            }
            file << "v " << side << ' ' << 0.16 + height << " 0\nv " << side << " 1.7 0\n";
        }
        file << "vt 0 0\nvt 1 0\nvt 0 1\n";
        for (const int first : {1, 9}) {
            const auto triangle = [&](int a, int b, int c) {
                file << "f " << first + a << "/1 " << first + b << "/2 " << first + c << "/3\n";
            };
            triangle(0, 1, 2);
            triangle(2, 1, 3);
            triangle(2, 3, 4);
            triangle(4, 3, 5);
            triangle(0, 6, 1);
            triangle(0, 7, 6);
        }
    }
}

/// A pyramid that goes 12 m along x.
void writeFarGoing(const QString& folder)
{
    QDir().mkpath(folder);
    for (int f = 0; f < 25; ++f) {
        std::ofstream file(QStringLiteral("%1/far_%2.obj").arg(folder).arg(f).toStdString());
        const double x = 0.5 * f;
        file << "v " << x << " 0 0\nv " << x + 1 << " 0 0\nv " << x << " 0 1\nv " << x
             << " 1.7 0\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 3 2\n";
    }
}

/// A picture per frame, each redder than the one before.
void writeTextures(const QString& folder)
{
    QDir().mkpath(folder);
    for (int f = 0; f < framesOfTake; ++f) {
        QImage image(8, 8, QImage::Format_RGB888);
        image.fill(QColor(8 * f, 0, 0));
        QVERIFY(image.save(QStringLiteral("%1/t_%2.png").arg(folder).arg(f)));
    }
}

} // namespace

class SequencesTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    ClipScene& scene() { return m_window->sequences().scene(); }
    widgets::Viewport& viewport() { return m_window->sequences().viewport(); }
    const SequenceEntry& entry(const char* name) { return *context().document.sequence(name); }
    void show(const QString& name)
    {
        context().selection.selectSequences({name});
        QVERIFY(test::waitForSequence(*m_window, name));
        QTRY_VERIFY(scene().frameCount() > 0);
        QVERIFY(test::activate(*m_window));
        viewport().setFocus();
    }
    /// Whether a point of the world lies within the view.
    bool isSeen(const QVector3D& point)
    {
        QPointF pixel;
        return viewport().camera().project(point, viewport().size(), &pixel) &&
               QRectF(QPointF(), viewport().size()).contains(pixel);
    }
    void clickTreeRow(int row, Qt::KeyboardModifiers modifiers)
    {
        QVERIFY(test::raiseDock("projectDock"));
        auto* tree = test::find<QTreeView>("projectTree");
        const QModelIndex sequences = tree->model()->index(1, 0);
        const QRect place = tree->visualRect(tree->model()->index(row, 0, sequences));
        QVERIFY(place.isValid());
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, modifiers, place.center());
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        writeStepping(m_folder.filePath("step"));
        writeFarGoing(m_folder.filePath("far"));
        writeTextures(m_folder.filePath("textures"));
    }

    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        Project project;
        const auto path = [this](const char* name) { return m_folder.filePath(name).toStdString(); };
        project.characters = {{.name = "stepper", .mesh = path("step/step_0.obj")},
                              {.name = "pyramid", .mesh = path("far/far_0.obj")}};
        project.characters[0].texture = {TextureReference::Kind::PerFrame, {path("textures")}, {}};
        project.sequences = {{.name = "step", .character = "stepper", .source = path("step")},
                             {.name = "far", .character = "pyramid", .source = path("far")},
                             {.name = "late", .character = "pyramid", .source = path("late")}};
        context().document.reset(project);
        QVERIFY(test::waitForSequence(*m_window, "step"));
        QVERIFY(test::waitForSequence(*m_window, "far"));
    }

    void cleanup()
    {
        context().document.reset({});
        m_window.reset();
    }

    void framesTheWholeTake()
    {
        show("far");
        QTRY_VERIFY(isSeen({0, 0, 0}) && isSeen({12, 1.7F, 0}));
        QTest::keyClick(&viewport(), Qt::Key_1);
        QTest::keyClick(&viewport(), Qt::Key_F);
        QTRY_VERIFY(isSeen({0, 0, 0}) && isSeen({12, 1.7F, 0}));
        // While the character is followed, framing comes near it, and the view goes along.
        const float far = viewport().camera().distance;
        QTest::mouseClick(test::find<QToolButton>("tool.view.follow"), Qt::LeftButton);
        QTest::keyClick(&viewport(), Qt::Key_F);
        QTRY_VERIFY(viewport().camera().distance < far / 2);
        const float before = viewport().camera().target.x();
        m_window->sequences().player().goTo(20);
        QTRY_VERIFY(viewport().camera().target.x() > before + 9.9F);
    }

    void aNewNameLeavesViewSelectionAndPlayheadAsTheyAre()
    {
        show("far");
        const auto playhead = [this] { return m_window->sequences().view().timeline().currentFrame(); };
        m_window->sequences().player().goTo(19);
        QTRY_COMPARE(scene().frame(), FrameIndex(19));
        const std::vector<int> figures = viewport().figures();
        const widgets::Turntable camera = viewport().camera();
        const auto isAsBefore = [&](const QString& name) {
            QCOMPARE(context().selection.sequences(), QStringList{name});
            QCOMPARE(context().selection.shownSequence(), name);
            const auto* tree = test::find<QTreeView>("projectTree");
            QCOMPARE(tree->currentIndex().data().toString(), name);
            QVERIFY(tree->selectionModel()->isSelected(tree->currentIndex()));
            QCOMPARE(viewport().figures(), figures);
            QVERIFY(viewport().camera() == camera);
            QCOMPARE(viewport().notice(), QString());
            QCOMPARE(m_window->sequences().player().frame(), FrameIndex(19));
            QCOMPARE(playhead(), 19);
            QCOMPARE(test::find<QSpinBox>("frameField")->value(), 19);
            QCOMPARE(viewport().figureShape(figures.front())->positions[0], 9.5F);
        };
        QSignalSpy shown(&scene(), &ClipScene::frameShown);
        const auto settles = [&shown] { return shown.count() > 0 || shown.wait(); };
        QVERIFY(renameEntry(context().document, {Section::Sequences, "far"}, "away"));
        isAsBefore("away");
        QVERIFY(settles());
        isAsBefore("away");
        shown.clear();
        context().document.undo();
        isAsBefore("far");
        QVERIFY(settles());
        isAsBefore("far");
        context().document.redo();
        isAsBefore("away");
    }

    void aDozenLabelsHaveAsManyColours()
    {
        LabelColors& colors = LabelColors::of(context().document);
        QSet<QRgb> seen;
        for (int label = 0; label < 12; ++label)
            seen += colors.color(QStringLiteral("label %1").arg(label)).rgb();
        QCOMPARE(seen.size(), 12);
        for (const char* foot : {"left", "right"})
            QVERIFY(!seen.contains(LabelColors::contact(foot).rgb()));
    }

    void whilePlayingThePlayheadIsWhereThePictureIs()
    {
        show("far");
        Player& player = m_window->sequences().player();
        QTRY_COMPARE(scene().frame(), player.frame());
        int compared = 0;
        int apart = 0;
        QTimer look;
        connect(&look, &QTimer::timeout, this, [&] {
            const auto shape = viewport().figureShape(scene().figureOf("far"));
            const auto seen = static_cast<int>(std::lround(shape->positions[0] / 0.5F));
            ++compared;
            if (m_window->sequences().view().timeline().currentFrame() != seen ||
                test::find<QSpinBox>("frameField")->value() != seen || player.frame() != FrameIndex(seen))
                ++apart;
        });
        player.play();
        look.start(0);
        QTRY_VERIFY(compared > 20 && player.frame().value > 12);
        player.pause();
        QTRY_COMPARE(scene().frame(), player.frame());
        look.stop();
        QVERIFY2(apart <= 1, qPrintable(QString("%1 of %2").arg(apart).arg(compared))); // while it stops
    }

    void saysWhatCannotBeShownAndTriesAgain()
    {
        context().selection.selectSequences({"late"});
        auto* strip = m_window->sequences().findChild<widgets::MessageStrip*>();
        QTRY_VERIFY(strip->isVisible());
        QCOMPARE(strip->kind(), widgets::MessageStrip::Kind::Error);
        QVERIFY(viewport().notice().contains("late"));
        writeFarGoing(m_folder.filePath("late"));
        QTest::mouseClick(strip->findChild<QPushButton*>("messageStripAction"), Qt::LeftButton);
        QTRY_VERIFY(scene().frameCount() == 25);
        QVERIFY(!strip->isVisible());
        QCOMPARE(viewport().notice(), QString());
        QVERIFY(QDir(m_folder.filePath("late")).removeRecursively());
    }

    void proposesContactsInOneStep()
    {
        show("step");
        QTest::keyClick(m_window.get(), Qt::Key_C, Qt::ShiftModifier);
        QTRY_VERIFY(!entry("step").contacts.empty());
        const auto& contacts = entry("step").contacts;
        QCOMPARE(contacts.size(), 3U);
        QVERIFY(std::ranges::count(contacts, "left", &ContactSpan::foot) == 2);
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(entry("step").contacts.empty());
        QTest::keyClick(m_window.get(), Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(entry("step").contacts.size(), 3U);
        context().actions.action("edit.clearContacts")->trigger();
        QVERIFY(entry("step").contacts.empty());
        // What has no feet says so where it is seen.
        show("far");
        QTest::keyClick(m_window.get(), Qt::Key_C, Qt::ShiftModifier);
        auto* strip = m_window->sequences().findChild<widgets::MessageStrip*>();
        QTRY_VERIFY(strip->isVisible() || !entry("far").contacts.empty());
    }

    void comparesInBothLayouts()
    {
        auto* overlay = m_window->sequences().findChild<QToolButton*>("tool.view.overlay");
        clickTreeRow(0, Qt::NoModifier);
        QVERIFY(!overlay->isVisible());
        clickTreeRow(1, Qt::ControlModifier);
        QTRY_COMPARE(viewport().figures().size(), 2U);
        QTRY_COMPARE(scene().frameCount(), 30);
        QVERIFY(viewport().layoutMode() == widgets::Viewport::Layout::SideBySide);
        QTRY_VERIFY(overlay->isVisible());
        QTest::mouseClick(overlay, Qt::LeftButton);
        QVERIFY(viewport().layoutMode() == widgets::Viewport::Layout::Overlay);
        QVERIFY(viewport().shading() == widgets::Shading::Clay);
        clickTreeRow(1, Qt::NoModifier);
        QTRY_COMPARE(viewport().figures().size(), 1U);
        QTRY_VERIFY(!overlay->isVisible());
    }

    void ghostsComeAtTheIntervalThatIsSet()
    {
        show("far");
        auto* interval = m_window->sequences().findChild<QSpinBox*>("ghostInterval");
        QVERIFY(!interval->isVisible());
        QTest::keyClick(&viewport(), Qt::Key_H);
        QTRY_VERIFY(interval->isVisible());
        QCOMPARE(scene().ghosts().interval(), 10);
        interval->setFocus();
        interval->selectAll();
        QTest::keyClicks(interval, "5");
        QTest::keyClick(interval, Qt::Key_Return);
        QCOMPARE(scene().ghosts().interval(), 5);
        QTest::mouseClick(test::find<QToolButton>("tool.view.ghosts"), Qt::LeftButton);
        QCOMPARE(scene().ghosts().interval(), 0);
    }

    void pinnedGhostsStayWhileOneScrubs()
    {
        show("far");
        QAction* pin = context().actions.action("view.pinGhost");
        QAction* unpin = context().actions.action("view.unpinGhosts");
        Player& player = m_window->sequences().player();
        player.goTo(7);
        QTest::keyClick(&viewport(), Qt::Key_H, Qt::ControlModifier);
        QVERIFY(pin->isChecked() && unpin->isEnabled());
        player.goTo(12);
        QVERIFY(!pin->isChecked());
        pin->trigger();
        QVERIFY(scene().ghosts().isPinned("far", FrameIndex(7)));
        QVERIFY(scene().ghosts().isPinned("far", FrameIndex(12)));
        QTRY_VERIFY(viewport().findChild<QWidget*>("viewportOverlay")->isVisible()); // the numbers
        // A new name and another clip in between leave them where they are.
        QVERIFY(renameEntry(context().document, {Section::Sequences, "far"}, "away"));
        QVERIFY(scene().ghosts().isPinned("away", FrameIndex(7)));
        context().document.undo();
        show("step");
        show("far");
        player.goTo(7);
        QVERIFY(pin->isChecked());
        pin->trigger();
        QVERIFY(!scene().ghosts().isPinned("far", FrameIndex(7)));
        QVERIFY(unpin->isEnabled());
        unpin->trigger();
        QVERIFY(!unpin->isEnabled());
        QTRY_VERIFY(!viewport().findChild<QWidget*>("viewportOverlay")->isVisible());
    }

    void theRightButtonShowsTheMenuOfTheView()
    {
        show("far");
        QTest::mouseClick(viewport().focusProxy(), Qt::RightButton, {}, {20, 20});
        QPointer<QMenu> menu = test::find<QMenu>("viewportMenu");
        QTRY_VERIFY(menu->isVisible());
        const QList<QAction*> actions = menu->actions();
        for (const char* id : {"view.frame", "view.grid", "view.shadow", "view.pinGhost", "view.copy"})
            QVERIFY2(actions.contains(context().actions.action(id)), id);
        QVERIFY(!actions.contains(context().actions.action("view.overlay")));
        menu->close();
        QTRY_VERIFY(menu.isNull());
        QVERIFY(viewport().areShadowsVisible());
        context().actions.action("view.shadow")->trigger();
        QVERIFY(!viewport().areShadowsVisible());
        context().actions.action("view.shadow")->trigger();
    }

    void texturesChangeWhilePlaying()
    {
        show("step");
        QTRY_VERIFY(!scene().textureOf("step").isNull());
        const auto red = [this] { return scene().textureOf("step").pixelColor(4, 4).red(); };
        QCOMPARE(red(), 0);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(red() > 0);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTest::keyClick(m_window.get(), Qt::Key_End);
        QTRY_COMPARE(red(), 8 * (framesOfTake - 1));
        QVERIFY(!m_window->sequences().player().isPlaying());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::SequencesTest);
#include "tst_sequences.moc"
