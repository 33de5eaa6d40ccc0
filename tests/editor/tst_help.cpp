// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/help/helppages.h"
#include "editor/help/helpviewer.h"
#include "editor/language/languagemanager.h"
#include "tests/qt/languages.h"
#include "tests/qt/registry.h"

#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>
#include <algorithm>

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
    void everyLanguageHasTheSameHeadings();
    void everyTopicIsInTheManual();
    void aWidgetHasTheTopicOfTheNearestAboveIt();
    void aTopicIsShownFromItsHeading();
    void wordsAreFoundInAllPages_data();
    void wordsAreFoundInAllPages();
    void aPlaceThatWasFoundIsShown();
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
    test::addLanguages();
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

void HelpTest::everyLanguageHasTheSameHeadings()
{
    for (const QString& page : helpPages())
        QVERIFY2(helpSections(page, "fr").size() == helpSections(page, "en").size(), qPrintable(page));
}

void HelpTest::everyTopicIsInTheManual()
{
    QVERIFY(helpTopics().size() > 30);
    for (const HelpTopic& topic : helpTopics()) {
        QVERIFY2(helpPages().contains(topic.page), qPrintable(topic.page));
        const QList<HelpSection> sections = helpSections(topic.page, "en");
        QVERIFY2(topic.heading.isEmpty() ||
                     std::ranges::count(sections, topic.heading, &HelpSection::name) == 1,
                 qPrintable(topic.page + ": " + topic.heading));
    }
}

void HelpTest::aWidgetHasTheTopicOfTheNearestAboveIt()
{
    QWidget workspace;
    workspace.setObjectName("animateWorkspace");
    QWidget panel(&workspace);
    panel.setObjectName("keysPanel");
    QWidget button(&panel);
    QCOMPARE(helpTopicOf(&workspace).page, QString("animating"));
    QVERIFY(helpTopicOf(&button) == (HelpTopic{"animate-keys", "Keys"}));
    QWidget unknown;
    QVERIFY(helpTopicOf(&unknown) == HelpTopic{});
    QWidget cards;
    cards.setObjectName("cardsPanel");
    QVERIFY(helpTopicOf(&cards) == (HelpTopic{"playing", "Cards"}));
    QVERIFY(helpTopicOf(nullptr) == HelpTopic{});
}

void HelpTest::aTopicIsShownFromItsHeading()
{
    HelpViewer viewer;
    viewer.show();
    QVERIFY(QTest::qWaitForWindowExposed(&viewer));
    viewer.showTopic({"animate-finish", "Report"});
    QCOMPARE(viewer.page(), QString("animate-finish"));
    QCOMPARE(viewer.shownHeading(), QString("Report"));
    m_language.setLanguage("fr");
    viewer.showTopic({"animate-finish", "Report"});
    QCOMPARE(viewer.shownHeading(), helpSections("animate-finish", "fr").at(3).name);
}

void HelpTest::wordsAreFoundInAllPages_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("page"); // of the first place
    QTest::newRow("heading") << "en"
                             << "obstacles"
                             << "animate-paths";
    QTest::newRow("several words") << "en"
                                   << "ground grid"
                                   << "keyboard";
    QTest::newRow("beginnings") << "en"
                                << "foot conta"
                                << "labels";
    QTest::newRow("any case") << "en"
                              << "STORYBOARD"
                              << "animate-keys";
    QTest::newRow("without accents") << "fr"
                                     << "clavier"
                                     << "keyboard";
    QTest::newRow("nothing") << "en"
                             << "xyzzy"
                             << "";
    QTest::newRow("no words") << "en"
                              << "   "
                              << "";
}

void HelpTest::wordsAreFoundInAllPages()
{
    QFETCH(QString, language);
    QFETCH(QString, words);
    QFETCH(QString, page);
    const QList<HelpHit> hits = searchHelp(words, language);
    QCOMPARE(hits.isEmpty() ? QString() : hits.front().section.page, page);
    for (const HelpHit& hit : hits) {
        QVERIFY(hit.excerpt.size() < 200);
        QVERIFY2(!hit.excerpt.contains("](") && !hit.excerpt.contains("**"), qPrintable(hit.excerpt));
    }
}

void HelpTest::aPlaceThatWasFoundIsShown()
{
    HelpViewer viewer;
    viewer.show();
    QVERIFY(QTest::qWaitForWindowExposed(&viewer));
    auto* search = viewer.findChild<QLineEdit*>("helpSearch");
    auto* hits = viewer.findChild<QListWidget*>("helpHits");
    QTest::keyClicks(search, "latent space");
    QVERIFY(hits->isVisible());
    QVERIFY(hits->count() > 1);
    QTest::keyClick(search, Qt::Key_Return);
    QVERIFY(!hits->isVisible());
    QCOMPARE(viewer.page(), QString("variations"));
    QCOMPARE(viewer.shownHeading(), QString("Latent space"));
    search->clear();
    QTest::keyClicks(search, "xyzzy");
    QCOMPARE(hits->count(), 1);
    QVERIFY(hits->item(0)->flags() == Qt::NoItemFlags);
    search->clear();
    QVERIFY(!hits->isVisible());
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

QUADRILLE_QT_TEST(HelpTest);
#include "tst_help.moc"
