// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Edits that a crash left: the copies of them, and how they are offered.
#include "editor/application/recoverynotice.h"
#include "editor/commands/projectedits.h"
#include "editor/documents/projectpaths.h"
#include "model/project/document/brokenentry.h"
#include "projectfilesfixture.h"
#include "tests/qt/registry.h"

#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

namespace quadrille {

namespace {

/// What a crash leaves: a copy that no program holds.
void leave(const QString& id, const Project& project, const QString& file)
{
    writeRecovery(project, id, file);
}

} // namespace

class RecoveryTest : public ProjectFilesFixture
{
    Q_OBJECT

private slots:
    void aCopyIsWrittenSecondsAfterAnEditAndOnlyThen()
    {
        QVERIFY(context().settings.autosaveSeconds() > 0);
        context().settings.setAutosaveSeconds(3600);
        QVERIFY(context().settings.autosaveSeconds() <= 10);
        context().settings.setAutosaveSeconds(1);
        openSaved();
        const auto copies = [] { return recoveryFolder().entryInfoList({"*.quadrille"}, QDir::Files); };
        duplicateSequence(document(), "walk");
        // Edits that go on and on do not put it off.
        QTRY_VERIFY_WITH_TIMEOUT(
            (setCharacterNotes(document(), QString::fromStdString(document().project().characters[0].name),
                               QString::number(document().undoStack()->count())),
             !copies().isEmpty()),
            10000);
        QVERIFY(files().save());
        QTRY_VERIFY(copies().isEmpty());
    }

    void aCopyThatCannotBeReadIsKeptAndToldOf()
    {
        write(recoveryFolder().filePath("left.quadrille"), "{ cut off");
        m_window->offerRecovery();
        QVERIFY(!QFile::exists(recoveryFolder().filePath("left.quadrille")));
        QCOMPARE(contentOf(recoveryFolder().filePath("unreadable/left.quadrille")), QByteArray("{ cut off"));
        QCOMPARE(context().issues.count(IssueLog::Severity::Warning), 1);
    }

    void aCopyWithANameThatNoFileTakesIsRecovered()
    {
        openSaved();
        Project project = document().project();
        document().reset({});
        project.sequences.push_back(project.sequences.front());
        project.sequences.back().name = "take 1/2";
        leave("left", project, {});
        const Recoveries found = findRecoveries();
        QCOMPARE(found.works.size(), 1U);
        QVERIFY(found.unreadable.isEmpty());
        QCOMPARE(found.works[0].title(), QString("Untitled"));
        QCOMPARE(found.works[0].entryCount(), 3); // a character, a take, and what cannot be read
        QVERIFY(files().recover(found.works[0]));
        QCOMPARE(document().project().sequences.size(), 1U);
        QCOMPARE(brokenEntries(document().project()).size(), 1U);
        QVERIFY(document().isUntitled() && document().isModified());
        document().reset({});
    }

    void neverSavedWorkIsOfferedUntilItIsDiscarded()
    {
        RecoveryNotice notice;
        notice.show();
        QVERIFY(notice.findChildren<QLabel*>("recoveryText").isEmpty());
        Project project;
        project.characters = {{.name = "Ada"}};
        leave("left", project, {});
        notice.refresh();
        const auto texts = notice.findChildren<QLabel*>("recoveryText");
        QCOMPARE(texts.size(), 1);
        QVERIFY2(texts[0]->text().contains("Untitled"), qPrintable(texts[0]->text()));
        QString asked;
        connect(&notice, &RecoveryNotice::recoverRequested, this,
                [&asked](const Recovery& recovery) { asked = recovery.id; });
        notice.findChild<QPushButton*>("recoveryRecover")->click();
        QCOMPARE(asked, QString("left"));
        notice.findChild<QPushButton*>("recoveryForget")->click();
        QVERIFY(findRecoveries().works.empty());
    }

    void recoveringAsksBeforeItReplacesWhatIsNotSaved()
    {
        openSaved();
        leave("left", document().project(), file());
        duplicateSequence(document(), "walk");
        const Recovery left = findRecoveries().works.at(0);
        QTimer::singleShot(100, this, [] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
                box->button(QMessageBox::Cancel)->click();
        });
        QVERIFY(!files().recover(left));
        QCOMPARE(document().project().sequences.size(), 2U);
        QCOMPARE(findRecoveries().works.size(), 1U);
        QVERIFY(files().save());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::RecoveryTest);
#include "tst_recovery.moc"
