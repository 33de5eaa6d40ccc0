// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Opening and saving when something is wrong: files that cannot be read, that others have open or write.
#include "editor/commands/projectedits.h"
#include "editor/documents/projectpaths.h"
#include "model/project/store/resultplaces.h"
#include "model/project/store/resultstore.h"
#include "projectfilesfixture.h"
#include "tests/qt/registry.h"
#include "widgets/controls/fieldnote.h"

#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTimer>
#include <QTreeView>

namespace quadrille {

namespace {

/// Presses buttons of the question that comes next, once it is there.
class Answer : public QObject
{
public:
    Answer(const QString& question, const QString& button) : m_question(question), m_button(button)
    {
        connect(&m_timer, &QTimer::timeout, this, &Answer::look);
        m_timer.start(20);
    }
    bool wasRequested() const { return m_wasRequested; }

private:
    void look()
    {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (box == nullptr || box->objectName() != m_question)
            return;
        m_timer.stop();
        m_wasRequested = true;
        if (auto* button = box->findChild<QPushButton*>(m_button))
            button->click();
        else
            box->button(QMessageBox::Cancel)->click();
    }

    QString m_question;
    QString m_button;
    QTimer m_timer;
    bool m_wasRequested = false;
};

} // namespace

class ProjectFilesTest : public ProjectFilesFixture
{
    Q_OBJECT

private:
    widgets::MessageStrip* strip(const QString& name)
    {
        return m_window->findChild<widgets::MessageStrip*>(name);
    }
    QString note() const
    {
        auto* shown = m_window->findChild<widgets::FieldNote*>();
        return shown == nullptr ? QString() : shown->text();
    }
    void replaceInFile(const QByteArray& before, const QByteArray& after)
    {
        QByteArray text = contentOf(file());
        QVERIFY(text.contains(before));
        write(file(), text.replace(before, after));
    }

private slots:
    void aNameThatNoFileTakesIsRefusedAtItsField()
    {
        openSaved();
        auto* field = test::find<QLineEdit>("sequenceName");
        for (const auto& [name, word] : {std::pair{"take 1/2", "slashes"}, {"..", "cannot be a name"}}) {
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, name);
            QTest::keyClick(field, Qt::Key_Return);
            QTRY_VERIFY2(note().contains(word), qPrintable(note()));
            QCOMPARE(field->text(), QString(name));
            QVERIFY(document().sequence("walk") != nullptr);
        }
        QVERIFY(!document().isModified());
        QTest::keyClick(field, Qt::Key_Backspace);
        QTRY_COMPARE(note(), QString());
        field->selectAll();
        QTest::keyClicks(field, "stroll");
        // Left by the mouse or Tab, it is as with Return.
        QTest::keyClick(field, Qt::Key_Tab);
        QTRY_VERIFY(document().sequence("stroll") != nullptr);
        QVERIFY(files().save());
        newWindow();
        m_window->open({file()});
        QVERIFY(document().sequence("stroll") != nullptr);
    }

    void aFileThatCannotBeReadWholeOpensAsFarAsItCan()
    {
        openSaved();
        duplicateSequence(document(), "walk");
        QVERIFY(files().save());
        replaceInFile("\"walk 2\"", "\"take 1/2\"");
        const QByteArray before = contentOf(file());
        newWindow();
        m_window->open({file()});
        QCOMPARE(document().project().sequences.size(), 1U);
        QVERIFY(strip("brokenStrip")->isVisible());
        QCOMPARE(context().issues.count(IssueLog::Severity::Error), 1);
        QVERIFY(!document().isModified());
        setCharacterNotes(document(), QString::fromStdString(document().project().characters[0].name), "x");
        QVERIFY(files().save());
        QVERIFY(contentOf(file()).contains("\"take 1/2\""));
        document().undo();
        QVERIFY(files().save());
        QCOMPARE(contentOf(file()), before);

        emit strip("brokenStrip")->actionTriggered();
        const auto title = [] {
            return test::find<QLabel>("propertiesTitle")
                ->text()
                .remove(QChar(0x200B)); // where lines may break
        };
        QTRY_COMPARE(title(), QString("sequences/take 1/2"));
        QVERIFY(test::find<QLabel>("brokenProblem")->text().contains("slashes"));
        QVERIFY(test::find<QLabel>("brokenPlace")->text().contains("line"));
        auto* text = test::find<QPlainTextEdit>("brokenText");
        text->setPlainText(text->toPlainText().replace("take 1/2", "take 1, 2").chopped(1));
        test::find<QPushButton>("brokenReadAgain")->click();
        QTRY_VERIFY2(note().contains("JSON"), qPrintable(note()));
        text->appendPlainText("}");
        test::find<QPushButton>("brokenReadAgain")->click();
        QTRY_VERIFY(document().sequence("take 1, 2") != nullptr);
        QVERIFY(!strip("brokenStrip")->isVisible());
        document().undo();
        QVERIFY(document().sequence("take 1, 2") == nullptr);
        QVERIFY(strip("brokenStrip")->isVisible());
    }

    void aFileThatIsNoJsonOffersItsBackup()
    {
        openSaved();
        duplicateSequence(document(), "walk");
        QVERIFY(files().save());
        const QByteArray whole = contentOf(file());
        write(file(), whole.left(whole.size() / 2));
        newWindow();
        {
            const Answer answer("projectBackup", "backupAccept");
            m_window->open({file()});
            QVERIFY(answer.wasRequested());
        }
        QCOMPARE(document().project().sequences.size(), 1U);
        QVERIFY(document().isModified());
        QCOMPARE(toQString(document().file()), file());
        QVERIFY(files().save());
        newWindow();
        m_window->open({file()});
        QCOMPARE(document().project().sequences.size(), 1U);
    }

    void aProjectThatIsOpenElsewhereIsAskedAbout()
    {
        openSaved();
        newWindow();
        const ProjectLock other(toPath(file()), "another editor");
        {
            const Answer answer("projectLocked", "cancel");
            m_window->open({file()});
            QVERIFY(answer.wasRequested());
        }
        QVERIFY(document().isUntitled() && document().project().sequences.empty());
        ResultStore(cacheFolder(toPath(file()))).save("graph/transitions", "key", Result{});
        {
            const Answer answer("projectLocked", "lockedCopy");
            m_window->open({file()});
        }
        QVERIFY(document().isUntitled());
        const ResultStore copied(cacheFolder(document().workingFile()));
        QVERIFY(copied.load("graph/transitions", "key").state == ResultStore::State::Fresh);
        QCOMPARE(document().project().sequences.size(), 1U);
        {
            const Answer answer("projectLocked", "lockedReadOnly");
            m_window->open({file()});
        }
        QVERIFY(m_window->windowTitle().contains("read only"));
        QVERIFY(strip("accessStrip")->isVisible());
        const QByteArray before = contentOf(file());
        duplicateSequence(document(), "walk");
        {
            const Answer answer("projectUnwritable", "cancel");
            QVERIFY(!files().save());
            QVERIFY(answer.wasRequested());
        }
        QCOMPARE(contentOf(file()), before);
        QVERIFY(files().saveTo(toPath(m_folder->filePath("mine.quadrille"))));
        QVERIFY(!m_window->windowTitle().contains("read only"));
        QVERIFY(!strip("accessStrip")->isVisible());
    }

    void aProjectThatIsTakenOverCannotBeSavedSilently()
    {
        openSaved();
        ProjectLock other(toPath(file()), "another editor");
        QVERIFY(other.state() == ProjectLock::State::Foreign);
        other.takeOver();
        QTRY_VERIFY(files().guard().access() == ProjectGuard::Access::TakenOver);
        QVERIFY(strip("accessStrip")->isVisible());
        const QByteArray before = contentOf(file());
        duplicateSequence(document(), "walk");
        {
            const Answer answer("projectUnwritable", "cancel");
            QVERIFY(!files().save());
            QVERIFY(answer.wasRequested());
        }
        QCOMPARE(contentOf(file()), before);
        {
            const Answer answer("projectUnwritable", "unwritableTakeOver");
            QVERIFY(files().save());
        }
        QVERIFY(contentOf(file()) != before);
        QVERIFY(other.look() == ProjectLock::State::Foreign);
    }

    void aFileThatSomebodyElseWroteIsNotOverwrittenUnasked()
    {
        openSaved();
        replaceInFile("\"walk\"", "\"stroll\"");
        const QByteArray theirs = contentOf(file());
        duplicateSequence(document(), "walk");
        {
            const Answer answer("projectChanged", "cancel");
            QVERIFY(!files().save());
            QVERIFY(answer.wasRequested());
        }
        QCOMPARE(contentOf(file()), theirs);
        {
            const Answer answer("projectChanged", "changedReload");
            QVERIFY(!files().save());
        }
        QVERIFY(document().sequence("stroll") != nullptr);
        QVERIFY(!document().isModified());
        replaceInFile("\"stroll\"", "\"march\"");
        duplicateSequence(document(), "stroll");
        {
            const Answer answer("projectChanged", "changedOverwrite");
            QVERIFY(files().save());
        }
        QVERIFY(!contentOf(file()).contains("march"));
        duplicateSequence(document(), "stroll");
        QVERIFY(files().save()); // what one wrote oneself is not asked about
    }

    void aFileThatSomebodyElseWroteIsOfferedAnew()
    {
        openSaved();
        write(file(), contentOf(file())); // the same again
        replaceInFile("\"walk\"", "\"stroll\"");
        QTRY_VERIFY(strip("changedStrip")->isVisible());
        emit strip("changedStrip")->actionTriggered();
        QVERIFY(document().sequence("stroll") != nullptr);
        QVERIFY(!strip("changedStrip")->isVisible());
    }

    void mediaThatWereWrittenAreOfferedAnew()
    {
        // Known as they were opened, not as the next look in turn finds them.
        MediaWatch& watch = m_window->strips().media();
        watch.setInterval(3'600'000);
        openSaved();
        const auto firstX = [this] {
            const MeshSequence* sequence = context().media.sequence("walk");
            return sequence == nullptr ? 99 : sequence->frame(FrameIndex(0)).positions()[0].x();
        };
        QTRY_COMPARE(firstX(), 0.F);
        QTRY_VERIFY(watch.isWatching());
        duplicateSequence(document(), "walk");
        const QString take = m_folder->filePath("walk_1.obj");
        write(take, contentOf(take).replace("v 0 0 0\n", "v -0.5 0 0\n"));
        watch.setInterval(50);
        QTRY_VERIFY(strip("mediaStrip")->isVisible());
        QCOMPARE(watch.changedFiles(), QStringList{take});
        emit strip("mediaStrip")->actionTriggered();
        QTRY_VERIFY(!strip("mediaStrip")->isVisible());
        QTRY_COMPARE(firstX(), -0.5F);
        QCOMPARE(document().project().sequences.size(), 2U);
        document().undo();
        QCOMPARE(document().project().sequences.size(), 1U);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::ProjectFilesTest);
#include "tst_projectfiles.moc"
