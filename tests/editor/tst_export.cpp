// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/exporting/exportdialog.h"
#include "editortest.h"
#include "model/core/file.h"
#include "model/project/rebuild.h"
#include "model/sequence/io/registry.h"
#include "widgets/controls/messagestrip.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <numeric>

namespace quadrille {

class ExportTest : public QObject
{
    Q_OBJECT

private:
    ProjectDocument& document() { return m_window->context().document; }
    QString place(const QString& name) const { return m_folder->filePath(name); }

    void openDialog()
    {
        QVERIFY(test::activate(*m_window));
        QTest::keyClick(m_window.get(), Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(dialog() != nullptr);
    }
    static ExportDialog* dialog()
    {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (auto* found = qobject_cast<ExportDialog*>(widget); found != nullptr && found->isVisible())
                return found;
        }
        return nullptr;
    }
    /// Chooses a format with the keyboard.
    static void choose(const QString& format)
    {
        auto* box = test::find<QComboBox>("exportFormat");
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        while (box->currentData().toString() != format && box->currentIndex() + 1 < box->count())
            QTest::keyClick(box, Qt::Key_Down);
        QCOMPARE(box->currentData().toString(), format);
    }
    static void type(const QString& path)
    {
        auto* field = test::find<QLineEdit>("exportPlace");
        field->selectAll();
        QTest::keyClicks(field, path);
    }
    static void accept() { QTest::mouseClick(test::find<QPushButton>("exportAccept"), Qt::LeftButton); }

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
        m_window->open({place("walk_1.obj")});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        document().saveAs(place("project.quadrille").toStdString());
    }
    void cleanup()
    {
        m_window.reset();
        m_folder.reset();
    }

    void writesWhatTheDialogSaysAndKeepsIt()
    {
        openDialog();
        choose("pc2");
        QVERIFY(test::find<QLineEdit>("exportPlace")->text().endsWith("exports/walk.pc2"));
        QVERIFY(test::find<QLabel>("exportFiles")->text().contains("5 frames"));
        auto* first = test::find<QSpinBox>("exportFirst");
        first->setFocus();
        QTest::keyClick(first, Qt::Key_Up);
        QVERIFY(test::find<QLabel>("exportFiles")->text().contains("4 frames"));
        type(place("out/walk.pc2"));
        accept();
        QTRY_VERIFY(dialog() == nullptr);

        const auto back =
            openSequences(place("out/walk.pc2").toStdString(), {.mesh = place("walk_1.obj").toStdString()});
        QCOMPARE(back.sequences.at(0).frameCount(), 4);
        QCOMPARE(document().project().exports.size(), 1U);
        const ExportEntry& entry = document().project().exports.front();
        QCOMPARE(QString::fromStdString(entry.name), QString("walk PC2"));
        QVERIFY(entry.range == (FrameRange{FrameIndex(1), FrameIndex(4)}));

        // A rebuild of the saved project writes the same bytes.
        document().save();
        const FileContent before = readFile(place("out/walk.pc2").toStdString());
        QFile::remove(place("out/walk.pc2"));
        rebuild(document().project(), document().file(), {}, {});
        const FileContent after = readFile(place("out/walk.pc2").toStdString());
        QVERIFY(before.text() == after.text());

        document().undo();
        QVERIFY(document().project().exports.empty());
        document().save();
    }

    void exportsAnAnimationThatTheProgramRepeatsByteForByte()
    {
        QList<int> numbers(16);
        std::iota(numbers.begin(), numbers.end(), 1);
        test::writeSeries(m_folder->path(), numbers);
        SequenceEntry walk = document().project().sequences.front();
        walk.source = place("walk_*.obj").toStdString();
        Project project = document().project();
        project.sequences.front() = walk;
        AnimationEntry stroll; // called as the sequence
        stroll.name = walk.name;
        stroll.walk = WalkEntry{.spans = {{walk.name, {FrameIndex(4), FrameIndex(11)}}}};
        stroll.character = walk.character;
        project.animations = {stroll};
        project.settings.fps = 12;
        document().recover(project, document().file());
        QVERIFY(test::waitForSequence(*m_window, "walk"));

        openDialog();
        auto* clip = test::find<QComboBox>("exportClip");
        QCOMPARE(clip->count(), 2);
        QCOMPARE(clip->currentData().toString(), QString("sequences/walk"));
        clip->setFocus();
        QTest::keyClick(clip, Qt::Key_End);
        QCOMPARE(clip->currentData().toString(), QString("animations/walk"));
        choose("pc2");
        type(place("out/stroll.pc2"));
        accept();
        QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, 20000);
        QCOMPARE(document().project().exports.size(), 1U);
        QCOMPARE(document().project().exports.front().what, std::string("animations/walk"));
        const std::string written(readFile(place("out/stroll.pc2").toStdString()).text());
        const auto back =
            openSequences(place("out/stroll.pc2").toStdString(), {.mesh = place("walk_1.obj").toStdString()});
        QCOMPARE(back.sequences.at(0).frameCount(), 8);

        // The program makes the same of the saved project, in another place.
        document().save();
        QVERIFY(QDir().mkpath(place("elsewhere")));
        for (const int number : numbers) {
            const QString name = QStringLiteral("walk_%1.obj").arg(number);
            QVERIFY(QFile::copy(place(name), place("elsewhere/" + name)));
        }
        QVERIFY(QFile::copy(place("project.quadrille"), place("elsewhere/p.quadrille")));
        QProcess program;
        program.start(QStringLiteral(QUADRILLE_PROGRAM), {"rebuild", place("elsewhere/p.quadrille")});
        QVERIFY(program.waitForFinished());
        QVERIFY2(program.exitCode() == 0, program.readAllStandardError().constData());
        QVERIFY(readFile(place("elsewhere/out/stroll.pc2").toStdString()).text() == written);

        // Changing the export opens the animation, not the sequence of its name.
        m_window->context().selection.select({Section::Exports, "walk PC2"});
        openDialog();
        QCOMPARE(test::find<QComboBox>("exportClip")->currentData().toString(), QString("animations/walk"));
        QTest::keyClick(dialog(), Qt::Key_Escape);
        QTRY_VERIFY(dialog() == nullptr);
        document().save();
    }

    void exportsAnAnimationOfAnUntitledProject()
    {
        Project project = document().project();
        AnimationEntry still;
        still.name = "still";
        still.character = project.sequences.front().character;
        still.walk = WalkEntry{.spans = {{"walk", {FrameIndex(1), FrameIndex(3)}}}};
        project.animations = {still};
        project.settings.fps = 6;
        document().reset(project);
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        m_window->context().selection.select({Section::Animations, "still"});
        openDialog();
        QCOMPARE(test::find<QComboBox>("exportClip")->currentData().toString(), QString("animations/still"));
        choose("pc2");
        type(place("still.pc2"));
        accept();
        QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, 20000);
        QVERIFY(QFile::exists(place("still.pc2")));
        document().undo();
        QVERIFY(document().project().exports.empty());
    }

    void namesTheFilesOfASeriesAndAsksBeforeWritingOver()
    {
        openDialog();
        choose("ply");
        QTest::mouseClick(test::find<QCheckBox>("exportKeep"), Qt::LeftButton, {}, {8, 8});
        type(place("walk.ply"));
        QVERIFY(test::find<QLabel>("exportFiles")->text().startsWith("walk_0000.ply … walk_0004.ply"));
        accept();
        QTRY_VERIFY(dialog() == nullptr);
        QVERIFY(document().project().exports.empty());
        QVERIFY(QFile::exists(place("walk_0004.ply")));

        openDialog();
        choose("ply");
        type(place("walk.ply"));
        bool asked = false;
        QTimer::singleShot(0, this, [&asked] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            asked = box != nullptr && box->text().contains("walk_0000.ply");
            QTest::keyClick(box, Qt::Key_Escape);
        });
        accept();
        QVERIFY(asked);
        QVERIFY(dialog() != nullptr); // nothing was written, and nothing is lost
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    void saysWhatWentWrongAndStaysOpen()
    {
        openDialog();
        choose("pc2");
        type(place("walk_1.obj/walk.pc2")); // a file is no folder
        accept();
        auto* strip = dialog()->findChild<widgets::MessageStrip*>();
        QTRY_VERIFY(strip->isVisible());
        QVERIFY(strip->kind() == widgets::MessageStrip::Kind::Error);
        QVERIFY(document().project().exports.empty());
        QVERIFY(test::find<QPushButton>("exportAccept")->isEnabled());
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    void drawsPictures()
    {
        openDialog();
        choose("png");
        auto* width = test::find<QSpinBox>("pictureWidth");
        QVERIFY(width->isVisible());
        width->setValue(64);
        test::find<QSpinBox>("pictureHeight")->setValue(48);
        type(place("pictures/walk.png"));
        accept();
        QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, 30000);
        QCOMPARE(QImage(place("pictures/walk_0002.png")).size(), QSize(64, 48));
        document().undo();
        document().save();
    }
};

} // namespace quadrille

QTEST_MAIN(quadrille::ExportTest)
#include "tst_export.moc"
