// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/help/helpviewer.h"
#include "editor/language/languagemanager.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>

using namespace quadrille;

class HelpTest : public QObject
{
    Q_OBJECT
private slots:
    void cleanup() { m_language.setLanguage("en"); }
    void everyLanguageHasEveryPage();
    void everyPageIsReachedFromTheContents_data();
    void everyPageIsReachedFromTheContents();
    void pageFollowsTheLanguage();
    void unknownPageShowsTheContents();
    void widgetsHaveThePageOfTheirParent();
    void linkOpensAndBackReturns();

private:
    static QStringList pages(const QString& language)
    {
        return QDir(":/help/" + language).entryList({"*.md"}, QDir::Files, QDir::Name);
    }
    static QStringList linksOf(const QString& file)
    {
        QFile page(file);
        if (!page.open(QIODevice::ReadOnly))
            return {};
        QStringList links;
        static const QRegularExpression link(R"(\]\(([^)]+)\))");
        for (const auto& match : link.globalMatch(QString::fromUtf8(page.readAll())))
            links += match.captured(1);
        return links;
    }
    LanguageManager m_language;
};

void HelpTest::everyLanguageHasEveryPage()
{
    QVERIFY(pages("en").size() > 10);
    QCOMPARE(pages("fr"), pages("en"));
}

void HelpTest::everyPageIsReachedFromTheContents_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << "en";
    QTest::newRow("French") << "fr";
}

void HelpTest::everyPageIsReachedFromTheContents()
{
    QFETCH(QString, language);
    QSet<QString> reached{"index.md"};
    QStringList open{"index.md"};
    while (!open.isEmpty()) {
        const QString page = open.takeFirst();
        const QString file = ":/help/" + language + "/" + page;
        QVERIFY2(QFile::exists(file), qPrintable(page + " is linked, but not there"));
        for (const QString& link : linksOf(file)) {
            if (reached.contains(link))
                continue;
            reached += link;
            if (link.endsWith(".md"))
                open += link;
            else
                QVERIFY2(QFile::exists(":/help/" + language + "/" + link), qPrintable(link));
        }
    }
    for (const QString& page : pages(language))
        QVERIFY2(reached.contains(page), qPrintable(page + " is not linked"));
}

void HelpTest::pageFollowsTheLanguage()
{
    HelpViewer viewer;
    auto* browser = viewer.findChild<QTextBrowser*>("helpBrowser");
    viewer.showPage("importing");
    QVERIFY(browser->toPlainText().startsWith("Importing"));
    m_language.setLanguage("fr");
    QTRY_VERIFY(browser->toPlainText().startsWith("Importer"));
    QCOMPARE(viewer.page(), QString("importing"));
}

void HelpTest::unknownPageShowsTheContents()
{
    HelpViewer viewer;
    viewer.showPage("nothing");
    QCOMPARE(viewer.page(), QString("index"));
}

void HelpTest::widgetsHaveThePageOfTheirParent()
{
    QWidget dock;
    QWidget button(&dock);
    QCOMPARE(helpPageOf(&button), QString("index"));
    setHelpPage(&dock, "playing");
    QCOMPARE(helpPageOf(&button), QString("playing"));
}

void HelpTest::linkOpensAndBackReturns()
{
    HelpViewer viewer;
    viewer.show();
    QVERIFY(QTest::qWaitForWindowExposed(&viewer));
    viewer.showPage("importing");
    viewer.findChild<QToolButton*>("helpContents")->click();
    QCOMPARE(viewer.page(), QString("index"));
    viewer.findChild<QToolButton*>("helpBack")->click();
    QCOMPARE(viewer.page(), QString("importing"));
}

QTEST_MAIN(HelpTest)
#include "tst_help.moc"
