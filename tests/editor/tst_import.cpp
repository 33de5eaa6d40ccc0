// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/importing/importdialog.h"
#include "editor/importing/importflow.h"
#include "editor/importing/taketable.h"
#include "editortest.h"
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSpinBox>

namespace quadrille {

namespace {

/// Drops files onto the middle of a window, as a file manager does.
void drop(QWidget& window, const QStringList& files)
{
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files)
        urls += QUrl::fromLocalFile(file);
    data.setUrls(urls);
    const QPoint place = window.rect().center();
    QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &event);
}

ImportDialog* openDialog()
{
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* dialog = qobject_cast<ImportDialog*>(widget); dialog != nullptr && dialog->isVisible())
            return dialog;
    }
    return nullptr;
}

} // namespace

class ImportTest : public QObject
{
    Q_OBJECT

private:
    void dropAndWait(const QStringList& files)
    {
        drop(*m_window, files);
        QTRY_VERIFY(openDialog() != nullptr);
        QTRY_VERIFY(!openDialog()->plan().takes.empty());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup()
    {
        m_window.reset();
        m_folder.reset();
    }

    void previewsASeriesWithAGapAndImportsIt()
    {
        test::writeSeries(m_folder->path(), {1, 2, 4, 10});
        dropAndWait({m_folder->path()});
        QVERIFY(test::find<QLabel>("importNotes")->text().contains("3, 5–9"));
        QCOMPARE(test::find<QLabel>("importHeight")->text(), QLocale().toString(1.7, 'f', 2) + " m high");

        // Nothing says the rate: it is asked for until it was looked at.
        auto* strip = test::find<widgets::MessageStrip>("messageStrip");
        auto* accept = test::find<QPushButton>("importAccept");
        auto* rate = test::find<QDoubleSpinBox>("importFps");
        QVERIFY(strip->text().contains("The rate of 1 take is not known."));
        QVERIFY(test::find<QLabel>("importRateReason")->text().startsWith("A guess"));
        QCOMPARE(accept->text(), QString("Import 1 take at 25 fps"));
        QCOMPARE(openDialog()->focusWidget(), rate);
        QTest::mouseClick(strip->findChild<QPushButton*>(), Qt::LeftButton);
        QTRY_VERIFY(!strip->isVisible());
        QCOMPARE(accept->text(), QString("Import 1 take"));
        QCOMPARE(test::find<QLabel>("importRateReason")->text(), QString("As you set it."));

        // A wrong unit leaps to the eye.
        auto* unit = openDialog()->findChild<QComboBox*>("unit");
        unit->setFocus();
        QTest::keyClick(unit, Qt::Key_Down);
        QCOMPARE(unit->currentText(), QString("cm"));
        QTRY_VERIFY(strip->isVisible());
        QVERIFY(strip->text().contains("0.017"));
        QTest::keyClick(unit, Qt::Key_Up);
        QTRY_VERIFY(!strip->isVisible());

        auto* last = test::find<QSpinBox>("importLast");
        last->setFocus();
        QTest::keyClick(last, Qt::Key_Down);
        QTest::mouseClick(test::find<QPushButton>("importAccept"), Qt::LeftButton);

        ProjectDocument& document = m_window->context().document;
        QCOMPARE(document.project().sequences.size(), 1U);
        const SequenceEntry& entry = document.project().sequences.front();
        QCOMPARE(QString::fromStdString(entry.name), QString("walk"));
        QVERIFY(entry.range == (FrameRange{FrameIndex(0), FrameIndex(2)}));
        QCOMPARE(document.project().characters.size(), 1U);
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        QCOMPARE(m_window->context().media.untrimmed("walk")->frameCount(), 4);

        QVERIFY(test::activate(*m_window));
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(document.project().sequences.empty());
        QVERIFY(document.project().characters.empty());
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(document.project().sequences.size(), 1U);
        document.undo(); // nothing unsaved is left to ask about
    }

    void importsOnlyWhatIsTicked()
    {
        test::writeSeries(m_folder->path(), {1, 2});
        std::ofstream(m_folder->filePath("broken.obj").toStdString()) << "v 0 0 0\nf 1 2 3\n";
        dropAndWait({m_folder->path()});
        auto* takes = test::find<TakeTable>("importTakes");
        QCOMPARE(takes->topLevelItemCount(), 2);
        auto* accept = test::find<QPushButton>("importAccept");
        QCOMPARE(accept->text(), QString("Import 1 take at 25 fps"));
        // The broken one says why, and cannot be ticked.
        takes->setCurrentItem(takes->topLevelItem(1));
        QVERIFY(test::find<widgets::MessageStrip>("messageStrip")->text().contains("only 1"));
        QVERIFY(!(takes->topLevelItem(1)->flags() & Qt::ItemIsUserCheckable));
        // Space unticks the good one: then there is nothing to import.
        takes->setCurrentItem(takes->topLevelItem(0));
        takes->setFocus();
        QTest::keyClick(takes, Qt::Key_Space);
        QVERIFY(!accept->isEnabled());
        QTest::keyClick(openDialog(), Qt::Key_Escape);
        QVERIFY(m_window->context().document.project().sequences.empty());
    }

    void takesTheRateOfTheMotionBesideATake()
    {
        QVERIFY(QDir(m_folder->path()).mkdir("takes"));
        test::writeSeries(m_folder->filePath("takes"), {1, 2, 3});
        test::writeSeries(m_folder->path(), {7, 8, 9});
        std::ofstream motion(m_folder->filePath("takes/walk.bvh").toStdString());
        motion << "HIERARCHY\nROOT hip\n{\n  OFFSET 0 0 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n"
                  "  End Site\n  {\n    OFFSET 0 1 0\n  }\n}\nMOTION\nFrames: 3\nFrame Time: 0.0333333\n"
                  "0 0 0\n0 0 0\n0 0 0\n";
        motion.close();
        dropAndWait({m_folder->filePath("takes")});
        QCOMPARE(test::find<QDoubleSpinBox>("importFps")->value(), 30.0);
        QCOMPARE(test::find<QLabel>("importRateReason")->text(), QString("As in walk.bvh beside it."));
        QVERIFY(!test::find<widgets::MessageStrip>("messageStrip")->isVisible());
        QTest::mouseClick(test::find<QPushButton>("importAccept"), Qt::LeftButton);
        ProjectDocument& document = m_window->context().document;
        QCOMPARE(document.project().settings.fps, 30.0);
        QTRY_VERIFY(openDialog() == nullptr);

        // A take of the same character of which nothing is said has the rate of the others.
        dropAndWait({m_folder->filePath("walk_7.obj")});
        QCOMPARE(test::find<QDoubleSpinBox>("importFps")->value(), 30.0);
        QCOMPARE(test::find<QLabel>("importRateReason")->text(),
                 QString("As the other takes of the character."));
        QTest::keyClick(openDialog(), Qt::Key_Escape);
        document.undo();
    }

    void asksForAnotherNameWhereOneCannotBeUsed()
    {
        test::writeSeries(m_folder->path(), {1, 2});
        dropAndWait({m_folder->path()});
        auto* takes = test::find<TakeTable>("importTakes");
        auto* accept = test::find<QPushButton>("importAccept");
        for (const QString& name : {QString("take 1/2"), QString("a").repeated(300)}) {
            takes->topLevelItem(0)->setText(0, name);
            QVERIFY(!accept->isEnabled());
            QTRY_VERIFY(test::find<widgets::MessageStrip>("messageStrip")->text().contains("name"));
        }
        takes->topLevelItem(0)->setText(0, "take");
        QVERIFY(accept->isEnabled());
        QTest::keyClick(openDialog(), Qt::Key_Escape);
    }

    void refusesWhatCannotBeReadAndKeepsWhatIsOpen()
    {
        test::writeSeries(m_folder->path(), {1, 2});
        m_window->open({m_folder->filePath("walk_1.obj")});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        const Project before = m_window->context().document.project();
        const QString file = m_folder->filePath("scene.abc");
        std::ofstream(file.toStdString()) << "Ogawa";
        dropAndWait({file});
        QVERIFY(test::find<widgets::MessageStrip>("messageStrip")->text().contains("Alembic"));
        QTest::keyClick(openDialog(), Qt::Key_Escape);
        QVERIFY(m_window->context().document.project() == before);
        m_window->context().document.undo();
    }

    void commandLineFilesOpenWithoutAsking()
    {
        test::writeSeries(m_folder->path(), {3, 4, 5});
        m_window->open({m_folder->filePath("walk_4.obj")});
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        QCOMPARE(m_window->context().media.untrimmed("walk")->frameCount(), 3);
        QCOMPARE(m_window->context().selection.shownSequence(), QString("walk"));
        m_window->context().document.undo();
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::ImportTest);
#include "tst_import.moc"
