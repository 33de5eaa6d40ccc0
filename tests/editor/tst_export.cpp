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
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>

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
