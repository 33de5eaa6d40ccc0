// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/animationedits.h"
#include "editor/commands/appearanceedits.h"
#include "editor/commands/liveedits.h"
#include "editor/commands/motionspaceedits.h"
#include "editor/commands/projectedits.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "tests/qt/registry.h"
#include "widgets/controls/fieldnote.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

namespace quadrille {

class PropertiesTest : public QObject
{
    Q_OBJECT

private:
    ProjectDocument& document() { return m_window->context().document; }
    Selection& selection() { return m_window->context().selection; }
    const SequenceEntry& walk() { return *document().sequence("walk"); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        test::writeSeries(m_folder->path(), {1, 2, 3, 4, 5});
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->open({m_folder->filePath("walk_1.obj")});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        selection().selectSequences({"walk"});
    }
    void cleanup()
    {
        document().saveAs(m_folder->filePath("project.quadrille").toStdString());
        m_window.reset();
        m_folder.reset();
    }

    void showsAndEditsASequence()
    {
        QCOMPARE(test::find<QLabel>("propertiesTitle")->text(), QString("walk"));
        QVERIFY(test::find<QLabel>("sequenceLength")->text().startsWith("5 frames"));
        auto* last = test::find<QSpinBox>("sequenceLast");
        last->setFocus();
        QTest::keyClick(last, Qt::Key_Down);
        QVERIFY(walk().range == (FrameRange{FrameIndex(0), FrameIndex(3)}));
        QTRY_VERIFY(test::find<QLabel>("sequenceLength")->text().startsWith("4 frames"));
        document().undo();
        QVERIFY(!walk().range);
        QCOMPARE(last->value(), 4);

        QTest::keyClick(test::find<QComboBox>("sequenceHasAxes"), Qt::Key_Down);
        QVERIFY(walk().sourceAxes.has_value());
        document().undo();
        QCOMPARE(test::find<QComboBox>("sequenceHasAxes")->currentIndex(), 0);
    }

    void showsAndEditsAModelOfAppearance()
    {
        AppearanceEntry look;
        look.name = "look";
        look.sequences = {"walk"};
        QCOMPARE(addAppearance(document(), look), QString("look"));
        selection().select({Section::Appearances, "look"});
        QCOMPARE(test::find<QLabel>("propertiesTitle")->text(), QString("look"));
        QCOMPARE(test::find<QLabel>("appearanceSequences")->text(), QString("walk"));
        const auto entry = [this] { return document().project().appearances.front(); };
        auto* components = test::find<QDoubleSpinBox>("appearanceComponents");
        QCOMPARE(components->value(), 50.0);
        components->setValue(20);
        QCOMPARE(entry().components, 20);
        QTest::keyClick(test::find<QComboBox>("appearanceFlow"), Qt::Key_Down);
        QVERIFY(entry().flow == FlowMethod::Dis);
        test::find<QDoubleSpinBox>("appearanceWarps")->setValue(25);
        QCOMPARE(entry().warpShare, 0.25);
        QTest::keyClick(test::find<QComboBox>("appearanceVaried"), Qt::Key_Down);
        QVERIFY(entry().varied == VariedTextures::Nearest);
        document().undo();
        document().undo();
        document().undo();
        document().undo();
        QVERIFY(entry() == look);
        QCOMPARE(components->value(), 50.0);

        removeEntries(document(), Section::Sequences, {"walk"});
        QVERIFY(document().project().appearances.empty());
        document().undo();
        QVERIFY(entry() == look);
        QCOMPARE(duplicateAppearance(document(), "look"), QString("look 2"));
    }

    void showsAndEditsALivePerformance()
    {
        QCOMPARE(addMotionSpace(document(), "walking", {"walk"}), QString("walking"));
        LiveEntry tour;
        tour.name = "tour";
        tour.spaces = {"walking"};
        tour.inputs = {{0, {}}, {60, {}}};
        tour.ticks = 120;
        QCOMPARE(addLive(document(), tour), QString("tour"));
        selection().select({Section::Lives, "tour"});
        QCOMPARE(test::find<QLabel>("propertiesTitle")->text(), QString("tour"));
        QCOMPARE(test::find<QLabel>("liveSpaces")->text(), QString("walking"));
        const double seconds = 60 / document().project().settings.fps;
        QCOMPARE(test::find<QLabel>("liveLength")->text(),
                 QLocale().toString(seconds, 'f', 1) + QString(" s, steered 1 time"));
        const auto entry = [this] { return document().project().lives.front(); };
        const auto set = [](const char* name, double value) {
            test::find<QDoubleSpinBox>(name)->setValue(value);
        };
        set("livePlaceSecond", 1.5);
        QVERIFY(entry().position == Vec2d(0, 1.5));
        set("livePlaceSecond", 0);
        QVERIFY(!entry().position);
        set("liveHeading", 90);
        QCOMPARE(entry().heading, 90.0);
        set("liveDepth", 20);
        QCOMPARE(entry().depth, 20);
        set("liveFade", 0.5);
        QCOMPARE(entry().fadeSeconds, 0.5);
        set("liveAcross", 2);
        QCOMPARE(entry().secondsAcross, 2.0);
        set("liveLatencyWeight", 7);
        QCOMPARE(entry().latencyWeight, 7.0);
        set("liveResponsiveWeight", 50);
        QCOMPARE(entry().responsiveWeight, 50.0);
        test::find<QCheckBox>("liveContacts")->click();
        QVERIFY(!entry().correctsContacts);
        for (int edit = 0; edit < 9; ++edit)
            document().undo();
        QVERIFY(entry() == tour);
        QCOMPARE(test::find<QDoubleSpinBox>("liveDepth")->value(), 12.0);
    }

    void renamesInPlaceAndRefusesATakenName()
    {
        duplicateInto("run");
        auto* name = test::find<QLineEdit>("sequenceName");
        selection().selectSequences({"walk"});
        QVERIFY(test::activate(*m_window));
        name->setFocus();
        name->selectAll();
        QTest::keyClicks(name, "run");
        QTest::keyClick(name, Qt::Key_Return);
        QVERIFY(document().sequence("walk") != nullptr);
        // What was typed stays, to be mended, with the reason beside it.
        QCOMPARE(name->text(), QString("run"));
        auto* note = m_window->findChild<widgets::FieldNote*>();
        QVERIFY(note != nullptr && note->isVisible());
        name->selectAll();
        QTest::keyClicks(name, "stroll");
        QTest::keyClick(name, Qt::Key_Return);
        QVERIFY(document().sequence("stroll") != nullptr);
        QCOMPARE(test::find<QLabel>("propertiesTitle")->text(), QString("stroll"));
    }

    void showsTheProjectAndItsCharacters()
    {
        selection().select({Section::Characters, "pyramid-is-not-there"});
        selection().select({});
        auto* fps = test::find<QDoubleSpinBox>("projectFps");
        fps->setFocus();
        fps->selectAll();
        QTest::keyClicks(fps, "50");
        QTest::keyClick(fps, Qt::Key_Return);
        QCOMPARE(document().project().settings.fps, 50.0);
        document().undo();
        QCOMPARE(fps->value(), 25.0);
        const QString character = QString::fromStdString(document().project().characters.front().name);
        selection().select({Section::Characters, character});
        QTRY_VERIFY(test::find<QLabel>("characterSurface")->text().startsWith("5 vertices\n6 triangles"));
        QVERIFY(test::find<QLabel>("characterSurface")->text().contains("closed"));
    }

    void anEditOfOneSettingLeavesTheOthersAsTheyAre()
    {
        selection().select({});
        ProjectSettings settings = document().project().settings;
        settings.fps = 29.970029970;
        settings.cacheMegabytes = 1;
        setSettings(document(), settings);
        auto* axes = test::find<QWidget>("projectAxes");
        auto* up = axes->findChild<QComboBox*>();
        QVERIFY(up != nullptr);
        QTest::keyClick(up, Qt::Key_Down);
        QVERIFY(document().project().settings.axes != settings.axes);
        QCOMPARE(document().project().settings.fps, settings.fps);
        QCOMPARE(document().project().settings.cacheMegabytes, settings.cacheMegabytes);
        document().undo();
        document().undo();
    }

    void sumsUpSeveralSequences()
    {
        duplicateInto("run");
        QVERIFY(test::waitForSequence(*m_window, "run"));
        selection().selectSequences({"walk", "run"});
        QCOMPARE(test::find<QLabel>("propertiesTitle")->text(), QString("2 sequences"));
        QTRY_VERIFY(test::find<QLabel>("propertiesSeveral")->text().startsWith("10 frames"));
    }

    void sequencesShowTheTakeThatIsSeen()
    {
        const QString added = addAnimation(document(), {.name = "stroll"});
        m_window->workspaces().select("animate");
        selection().selectAnimations({added});
        QCOMPARE(test::find<QLabel>("propertiesTitle")->text(), added);
        m_window->workspaces().select("sequences");
        QCOMPARE(test::find<QLabel>("propertiesTitle")->text(), QString("walk"));
        m_window->workspaces().select("animate");
        QCOMPARE(selection().shownAnimation(), added);
    }

private:
    void duplicateInto(const QString& name)
    {
        const QString copy = duplicateSequence(document(), "walk");
        QVERIFY(renameEntry(document(), {Section::Sequences, copy}, name));
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::PropertiesTest);
#include "tst_properties.moc"
