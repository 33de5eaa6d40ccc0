// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "exportfixture.h"
#include "model/core/file.h"
#include "model/project/fields/pictureoptions.h"
#include "model/project/results/rebuild.h"
#include "model/render/clipcamera.h"
#include "model/sequence/io/registry.h"
#include "tests/qt/registry.h"

#include <QCheckBox>
#include <QDir>
#include <QLabel>
#include <QProcess>
#include <QProgressBar>
#include <QSpinBox>
#include <fstream>
#include <numeric>

namespace quadrille {

class ExportTest : public ExportFixture
{
    Q_OBJECT

private slots:
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
        acceptAndClose();

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

    void aFileIsOfTheFormatThatItIsNamedAfter()
    {
        openDialog();
        choose("pc2");
        auto* field = test::find<QLineEdit>("exportPlace");
        const auto typeAndLeave = [&](const QString& name) {
            QApplication::setActiveWindow(dialog());
            field->setFocus();
            type(place(name));
            QTest::keyClick(field, Qt::Key_Tab);
            return test::find<QComboBox>("exportFormat")->currentData().toString();
        };
        QCOMPARE(typeAndLeave("out/walk.obj"), QString("obj"));
        QCOMPARE(field->text(), place("out/walk.obj"));
        QCOMPARE(typeAndLeave("out/walk.v2"), QString("obj")); // no format has this ending
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    void aNewExportIsProposedBesideWhatIsThere()
    {
        QVERIFY(QDir().mkpath(place("exports")));
        std::ofstream(place("exports/walk.pc2").toStdString()) << "of somebody";
        openDialog();
        choose("pc2");
        QVERIFY(test::find<QLineEdit>("exportPlace")->text().endsWith("exports/walk_2.pc2"));
        choose("obj");
        QVERIFY(test::find<QLineEdit>("exportPlace")->text().endsWith("exports/walk.obj"));
        std::ofstream(place("exports/walk_0000.ply").toStdString()) << "the first of a series";
        choose("ply");
        QVERIFY(test::find<QLineEdit>("exportPlace")->text().endsWith("exports/walk_2.ply"));
        QTest::keyClick(dialog(), Qt::Key_Escape);
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
        QCOMPARE(clip->count(), 4); // each kind under its heading
        QCOMPARE(clip->currentData().toString(), QString("sequences/walk"));
        clip->setFocus();
        QTest::keyClick(clip, Qt::Key_End);
        QCOMPARE(clip->currentData().toString(), QString("animations/walk"));
        choose("pc2");
        type(place("out/stroll.pc2"));
        acceptAndClose();
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
        QVERIFY(program.waitForFinished(-1)); // the test's own limit holds
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
        acceptAndClose();
        QVERIFY(QFile::exists(place("still.pc2")));
        document().undo();
        QVERIFY(document().project().exports.empty());
    }

    void saysWhatWentWrongAndStaysOpen()
    {
        openDialog();
        choose("pc2");
        type(place("walk_1.obj/walk.pc2")); // a file is no folder
        accept();
        QTRY_VERIFY(strip()->isVisible());
        QVERIFY(strip()->kind() == widgets::MessageStrip::Kind::Error);
        QVERIFY(document().project().exports.empty());
        QVERIFY(test::find<QPushButton>("exportAccept")->isEnabled());
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    void saysWhereTheFilesAreAndKeepsNobodyFromWorking()
    {
        openDialog();
        QCOMPARE(dialog()->windowModality(), Qt::WindowModal);
        choose("pc2");
        type(place("out/walk.pc2"));
        accept();
        QTRY_VERIFY(isDone());
        QCOMPARE(dialog()->windowModality(), Qt::NonModal);
        QVERIFY(strip()->text().contains("walk.pc2"));
        auto* show = strip()->findChild<QPushButton*>();
        QVERIFY(show != nullptr && show->isVisible());
        QCOMPARE(show->text(), QString("Show in folder"));
        QVERIFY(!test::find<QProgressBar>("exportProgress")->isVisible());
        accept();
        QTRY_VERIFY(dialog() == nullptr);
    }

    void aCancelledExportLeavesNothingAndTheDialogAsItWas()
    {
        openDialog();
        choose("png");
        test::find<QDoubleSpinBox>("pictureWidth")->setValue(4000);
        test::find<QDoubleSpinBox>("pictureHeight")->setValue(4000);
        type(place("large/walk.png"));
        accept();
        QTRY_VERIFY(test::find<QProgressBar>("exportProgress")->isVisible());
        QTest::mouseClick(test::find<QPushButton>("exportCancel"), Qt::LeftButton);
        QTRY_VERIFY(test::find<QPushButton>("exportAccept")->isEnabled());
        QCOMPARE(test::find<QPushButton>("exportAccept")->text(), QString("Export"));
        QVERIFY(!QFile::exists(place("large")));
        QVERIFY(document().project().exports.empty());
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    void saysBeforeAndAfterThatGltfShowsOneTexture()
    {
        QVERIFY(QDir().mkpath(place("pictures")));
        for (int f = 1; f <= 5; ++f) {
            QImage picture(2, 2, QImage::Format_RGB32);
            picture.fill(QColor(40 * f, 0, 0));
            QVERIFY(picture.save(place(QStringLiteral("pictures/t_%1.png").arg(f))));
        }
        Project project = document().project();
        project.sequences.front().texture = {TextureReference::Kind::PerFrame,
                                             {place("pictures").toStdString()}};
        document().recover(project, document().file());
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        openDialog();
        choose("gltf");
        QVERIFY(strip()->kind() == widgets::MessageStrip::Kind::Info);
        QVERIFY2(strip()->text().contains("written beside"), qPrintable(strip()->text()));
        choose("usd");
        QVERIFY(strip()->isEmpty());
        choose("gltf");
        type(place("walk.glb"));
        accept();
        QTRY_VERIFY(isDone());
        QVERIFY(strip()->kind() == widgets::MessageStrip::Kind::Info);
        QVERIFY2(strip()->text().contains("first frame"), qPrintable(strip()->text()));
        accept();
        document().save();
    }

    void aFilmBeginsWhereTheViewLooks()
    {
        SceneView& view = m_window->sequences().view();
        QTRY_VERIFY(view.scene().figureOf("walk") >= 0);
        widgets::Turntable camera = view.viewport().camera();
        camera.target = {0.25F, 0.5F, -0.125F};
        camera.yaw = 70;
        camera.pitch = 20;
        camera.distance = 3;
        for (const bool follows : {false, true}) {
            view.player().goTo(3);
            QTRY_COMPARE(view.scene().frame().value, 3);
            view.viewport().setFollowed(follows ? std::optional(view.scene().figureOf("walk"))
                                                : std::nullopt);
            view.viewport().setCamera(camera);
            openDialog();
            if (!follows)
                choose("png"); // the second time it is the format that was chosen last
            QVERIFY(test::find<QCheckBox>("pictureView")->isChecked());
            test::find<QDoubleSpinBox>("pictureWidth")->setValue(64);
            test::find<QDoubleSpinBox>("pictureHeight")->setValue(48);
            type(place(follows ? "following/walk.png" : "still/walk.png"));
            acceptAndClose();

            ProjectProblems problems;
            const ExportEntry& entry = document().project().exports.back();
            const RenderSettings settings = pictureFromJson(entry.picture, "", problems);
            QCOMPARE(settings.camera, follows ? CameraMode::Follow : CameraMode::Fixed);
            const MeshSequence* clip = m_window->context().media.sequence("walk");
            const Camera written = clipCameras(*clip, settings)[3];
            const QVector3D shift = view.viewport().figureShape(view.scene().figureOf("walk"))->shift;
            const QVector3D eye = camera.position() - shift;
            const QVector3D target = camera.target - shift;
            QVERIFY((written.eye - Vec3d(eye.x(), eye.y(), eye.z())).norm() < 1e-5);
            QVERIFY((written.target - Vec3d(target.x(), target.y(), target.z())).norm() < 1e-5);
            QCOMPARE(written.verticalFovDegrees, static_cast<double>(camera.fieldOfView));
        }
        document().save();
    }

    void drawsPictures()
    {
        openDialog();
        choose("png");
        auto* width = test::find<QDoubleSpinBox>("pictureWidth");
        QVERIFY(width->isVisible());
        width->setValue(64);
        test::find<QDoubleSpinBox>("pictureHeight")->setValue(48);
        type(place("pictures/walk.png"));
        acceptAndClose();
        QCOMPARE(QImage(place("pictures/walk_0002.png")).size(), QSize(64, 48));
        document().undo();
        document().save();
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::ExportTest);
#include "tst_export.moc"
