// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What exports ask about or refuse: files that are there already, those of takes, places outside of the
// project.
#include "exportfixture.h"
#include "model/core/file.h"
#include "tests/qt/registry.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QLabel>
#include <QMessageBox>
#include <QTimer>

namespace quadrille {

class ExportQuestionsTest : public ExportFixture
{
    Q_OBJECT

private:
    /// Answers the next question; what it said is in `m_asked`.
    void answer(bool yes)
    {
        m_asked.clear();
        auto* timer = new QTimer(this);
        connect(timer, &QTimer::timeout, this, [this, timer, yes] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr)
                return;
            timer->deleteLater();
            m_asked = box->objectName() + ": " + box->text();
            for (QAbstractButton* button : box->buttons()) {
                if ((box->buttonRole(button) == QMessageBox::AcceptRole) == yes)
                    return button->click();
            }
        });
        timer->start(10);
    }
    void openExport(const QString& name)
    {
        m_window->context().selection.select({Section::Exports, name});
        openDialog();
    }
    /// The project with one export of its take, saved.
    void addEntry(const std::string& path)
    {
        Project project = document().project();
        ExportEntry entry;
        entry.name = "walk PC2";
        entry.what = "sequences/walk";
        entry.path = path;
        project.exports = {entry};
        document().recover(project, document().file());
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        document().save();
    }

    QString m_asked;

private slots:
    void namesTheFilesOfASeriesAndAsksBeforeWritingOver()
    {
        openDialog();
        choose("ply");
        QTest::mouseClick(test::find<QCheckBox>("exportKeep"), Qt::LeftButton, {}, {8, 8});
        type(place("walk.ply"));
        QVERIFY(test::find<QLabel>("exportFiles")->text().startsWith("walk_0000.ply … walk_0004.ply"));
        acceptAndClose();
        QVERIFY(document().project().exports.empty());
        QVERIFY(QFile::exists(place("walk_0004.ply")));

        openDialog();
        choose("ply");
        type(place("walk.ply"));
        answer(false);
        accept();
        QTRY_COMPARE(m_asked, QString("exportOverwrite: “walk_0000.ply” and 4 more are there already."));
        QTRY_VERIFY(test::find<QPushButton>("exportAccept")->isEnabled());
        QVERIFY(dialog() != nullptr); // nothing was written, and nothing is lost
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    void aTakesOwnFilesAreNeverWrittenOver()
    {
        const FileContent before = readFile(place("walk_1.obj").toStdString());
        openDialog();
        choose("obj");
        type(place("walk_#.obj"));
        accept();
        QTRY_VERIFY(!strip()->isEmpty());
        QVERIFY2(strip()->text().contains("is an input (sequences/walk)"), qPrintable(strip()->text()));
        QTest::keyClick(dialog(), Qt::Key_Escape);
        QTRY_VERIFY(dialog() == nullptr);

        // Changing an export that somebody wrote by hand.
        addEntry(place("walk_1.obj").toStdString());
        Project project = document().project();
        project.exports.front().format = "pc2";
        document().recover(project, document().file());
        QVERIFY(test::waitForSequence(*m_window, "walk"));
        openExport("walk PC2");
        accept();
        QTRY_VERIFY(!strip()->isEmpty());
        QVERIFY2(strip()->text().contains("never written over"), qPrintable(strip()->text()));
        QVERIFY(readFile(place("walk_1.obj").toStdString()).text() == before.text());
        QTest::keyClick(dialog(), Qt::Key_Escape);
        document().save();
    }

    void anExportThatIsKeptTakesThePlaceOfThatWhichWritesThere()
    {
        addEntry(place("walk.pc2").toStdString());
        openDialog();
        choose("pc2");
        type(place("walk.pc2"));
        answer(true);
        accept();
        QTRY_VERIFY(isDone());
        QVERIFY2(m_asked.contains("“walk PC2”"), qPrintable(m_asked));
        QCOMPARE(document().project().exports.size(), 1U);
        accept();
        document().save();
    }

    void whatSomebodyElseWroteIsAskedAboutAlsoWhenAnExportIsWrittenAgain()
    {
        addEntry(place("out/walk.pc2").toStdString());
        openExport("walk PC2");
        acceptAndClose();
        openExport("walk PC2");
        acceptAndClose(); // what it wrote itself is no question
        QFile file(place("out/walk.pc2"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("mine");
        file.close();
        openExport("walk PC2");
        answer(false);
        accept();
        QTRY_COMPARE(m_asked, QString("exportOverwrite: “walk.pc2” is there already."));
        QTRY_VERIFY(test::find<QPushButton>("exportAccept")->isEnabled());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("mine"));
        QTest::keyClick(dialog(), Qt::Key_Escape);
        document().save();
    }

    void aPlaceOutsideOfTheProjectIsAskedAboutOnce()
    {
        const QTemporaryDir elsewhere;
        addEntry(elsewhere.filePath("walk.pc2").toStdString());
        openExport("walk PC2");
        answer(false);
        accept();
        QTRY_VERIFY(m_asked.startsWith("exportOutside: "));
        QTRY_VERIFY(test::find<QPushButton>("exportAccept")->isEnabled());
        QVERIFY(!QFile::exists(elsewhere.filePath("walk.pc2")));
        answer(true);
        accept();
        QTRY_VERIFY(isDone());
        QVERIFY(QFile::exists(elsewhere.filePath("walk.pc2")));
        accept();
        QTRY_VERIFY(dialog() == nullptr);
        openExport("walk PC2");
        acceptAndClose();
        document().save();
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::ExportQuestionsTest);
#include "tst_exportquestions.moc"
