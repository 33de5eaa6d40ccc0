// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/errors/issuelog.h"
#include "editor/errors/issuespanel.h"
#include "editor/language/languagemanager.h"
#include "editor/language/retranslate.h"
#include "tests/qt/registry.h"

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>

using namespace quadrille;

/// The language of the interface and what is said in it: errors, issues.
class LanguageTest : public QObject
{
    Q_OBJECT
private slots:
    void cleanup();
    void frenchIsThere();
    void languageSwitchesAtRunTime();
    void unknownLanguageFallsBack();
    void qtsOwnTextsSwitchToo();
    void errorsAreTranslatedWithTheirValues();
    void placeNamesFileAndLine();
    void issueLogCountsRepeats();
    void issueLogFollowsTheLanguage();
    void issueLogForgetsASubject();
    void issueLogJumpsToTheCulprit();
    void cancellingIsNoIssue();
    void issuesPanelShowsAndJumps();

private:
    LanguageManager m_language;
};

void LanguageTest::cleanup()
{
    m_language.setLanguage("en");
}

void LanguageTest::frenchIsThere()
{
    const auto languages = LanguageManager::languages();
    QCOMPARE(languages.front().code, QString("en"));
    const auto french = std::ranges::find(languages, QString("fr"), &Language::code);
    QVERIFY(french != languages.end());
    QCOMPARE(french->name, QString("Français"));
}

void LanguageTest::languageSwitchesAtRunTime()
{
    QLabel label;
    retranslates(&label, [&label] { label.setText(describe(Error(ErrorCode::FileEmpty)).sentence); });
    QCOMPARE(label.text(), QString("The file is empty."));
    QSignalSpy changed(&m_language, &LanguageManager::changed);
    m_language.setLanguage("fr");
    QCOMPARE(changed.count(), 1);
    QCOMPARE(m_language.language(), QString("fr"));
    QTRY_COMPARE(label.text(), QString("Le fichier est vide."));
    QCOMPARE(QLocale().language(), QLocale::French);
    m_language.setLanguage("en");
    QTRY_COMPARE(label.text(), QString("The file is empty."));
}

void LanguageTest::unknownLanguageFallsBack()
{
    m_language.setLanguage("xx");
    const auto languages = LanguageManager::languages();
    QVERIFY(
        std::ranges::any_of(languages, [&](const Language& l) { return l.code == m_language.language(); }));
}

void LanguageTest::qtsOwnTextsSwitchToo()
{
    m_language.setLanguage("fr");
    QCOMPARE(QCoreApplication::translate("QPlatformTheme", "Cancel"), QString("Annuler"));
}

void LanguageTest::errorsAreTranslatedWithTheirValues()
{
    const Error error(ErrorCode::VertexCountMismatch, {.values = {{"found", "12"}, {"expected", "8431"}}});
    QCOMPARE(describe(error).sentence, QString("12 vertices where 8431 are expected."));
    m_language.setLanguage("fr");
    const ErrorText french = describe(error);
    QVERIFY(french.sentence.contains("12") && french.sentence.contains("8431"));
    QVERIFY(french.sentence != QString("12 vertices where 8431 are expected."));
    QVERIFY(!french.remedy.contains("sequence need"));
    // So are those that count something.
    const Error cut(ErrorCode::FileTruncated,
                    {.values = {{"expected", "at least 68 bytes"}, {"found", "7"}}});
    QVERIFY2(describe(cut).sentence.contains("au moins 68 octets"), qPrintable(describe(cut).sentence));
}

void LanguageTest::placeNamesFileAndLine()
{
    const Error error(
        ErrorCode::FileSyntax,
        {.file = "/some/where/take_0007.obj", .place = {.line = 12}, .values = {{"reason", "x"}}});
    QCOMPARE(describe(error).where, QString("take_0007.obj, line 12"));
    QVERIFY(describe(error).oneLine().endsWith("(take_0007.obj, line 12)"));
}

void LanguageTest::issueLogCountsRepeats()
{
    IssueLog log;
    QAbstractItemModelTester tester(&log, QAbstractItemModelTester::FailureReportingMode::QtTest);
    const Issue gap{Issue::Severity::Warning, Issue::Code::NumberingGap, {.values = {{"missing", "4"}}}};
    log.add(gap, "walk");
    log.add(gap, "walk");
    log.add(gap, "run");
    QCOMPARE(log.rowCount(), 2);
    QCOMPARE(log.index(0, IssueLog::CountColumn).data().toInt(), 2);
    QVERIFY(!log.index(1, IssueLog::CountColumn).data().isValid());
    QCOMPARE(log.count(IssueLog::Severity::Warning), 2);
    QCOMPARE(log.count(IssueLog::Severity::Error), 0);
}

void LanguageTest::issueLogFollowsTheLanguage()
{
    IssueLog log;
    log.add(Error(ErrorCode::FileEmpty));
    const QString english = log.index(0, IssueLog::MessageColumn).data().toString();
    m_language.setLanguage("fr");
    QVERIFY(log.index(0, IssueLog::MessageColumn).data().toString() != english);
}

void LanguageTest::issueLogForgetsASubject()
{
    IssueLog log;
    log.add(Error(ErrorCode::FileEmpty), "walk");
    log.add(Error(ErrorCode::NoFaces), "walk");
    log.add(Error(ErrorCode::NoFaces), "run");
    log.clear("walk");
    QCOMPARE(log.rowCount(), 1);
    QCOMPARE(log.index(0, IssueLog::SubjectColumn).data().toString(), QString("run"));
}

void LanguageTest::issueLogJumpsToTheCulprit()
{
    IssueLog log;
    int jumps = 0;
    log.add(Error(ErrorCode::FileEmpty));
    log.add(Error(ErrorCode::NoFaces), "walk", [&jumps] { ++jumps; });
    QVERIFY(!log.index(0, 0).data(IssueLog::CanJumpRole).toBool());
    QVERIFY(log.index(1, 0).data(IssueLog::CanJumpRole).toBool());
    log.jump(log.index(0, 0));
    QCOMPARE(jumps, 0);
    log.jump(log.index(1, 0));
    QCOMPARE(jumps, 1);
}

void LanguageTest::cancellingIsNoIssue()
{
    IssueLog log;
    log.add(Error(ErrorCode::Cancelled));
    QCOMPARE(log.rowCount(), 0);
}

void LanguageTest::issuesPanelShowsAndJumps()
{
    IssueLog log;
    IssuesPanel panel(log);
    panel.show();
    auto* list = panel.findChild<QTreeView*>("issuesList");
    auto* show = panel.findChild<QToolButton*>("issuesShow");
    QVERIFY(!list->isVisible());
    int jumps = 0;
    log.add(Error(ErrorCode::NoFaces), "walk", [&jumps] { ++jumps; });
    QVERIFY(list->isVisible());
    QVERIFY(!show->isEnabled());
    list->setCurrentIndex(log.index(0, 0));
    QVERIFY(show->isEnabled());
    show->click();
    QCOMPARE(jumps, 1);
    panel.findChild<QToolButton*>("issuesClear")->click();
    QVERIFY(!list->isVisible());
}

QUADRILLE_QT_TEST(LanguageTest);
#include "tst_language.moc"
