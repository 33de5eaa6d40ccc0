// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/help/helpviewer.h"

#include "editor/help/helpbrowser.h"
#include "editor/help/helppages.h"
#include "editor/language/retranslate.h"
#include "widgets/theme/icons.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QScreen>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTextBlock>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

namespace quadrille {

namespace {

constexpr int pageRole = Qt::UserRole;
constexpr int headingRole = Qt::UserRole + 1;
constexpr int titleBar = 40; // logical pixels

QString indexPage()
{
    return HelpTopic().page;
}

QString shownLanguage()
{
    return QLocale().name().section(QLatin1Char('_'), 0, 0);
}

/// Which heading of its page a topic means; the first when it names none.
int headingOf(const HelpTopic& topic)
{
    const QList<HelpSection> sections = helpSections(topic.page, QStringLiteral("en"));
    const auto found = std::ranges::find(sections, topic.heading, &HelpSection::name);
    return found == sections.end() ? 0 : found->heading;
}

bool isHeading(const QTextBlock& block)
{
    return block.blockFormat().headingLevel() > 0;
}

} // namespace

HelpViewer::HelpViewer(QWidget* parent)
    : QDialog(parent)
    , m_browser(new HelpBrowser)
    , m_hits(new QListWidget)
    , m_pages(new QStackedWidget)
    , m_search(new QLineEdit)
    , m_contents(new QToolButton)
    , m_back(new QToolButton)
{
    setObjectName(QStringLiteral("helpViewer"));
    resize(QSize(640, 720).boundedTo(screen()->availableSize() - QSize(0, titleBar)));
    m_browser->setObjectName(QStringLiteral("helpBrowser"));
    m_browser->setFrameShape(QFrame::NoFrame);
    m_browser->setOpenExternalLinks(true);
    m_browser->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // pictures keep their width
    m_browser->document()->setDocumentMargin(16);
    m_hits->setObjectName(QStringLiteral("helpHits"));
    m_hits->setWordWrap(true);
    m_hits->setSpacing(4);
    m_pages->addWidget(m_browser);
    m_pages->addWidget(m_hits);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeBar());
    column->addWidget(m_pages, 1);
    connect(m_contents, &QToolButton::clicked, this, [this] { showPage(indexPage()); });
    connect(m_back, &QToolButton::clicked, m_browser, &QTextBrowser::backward);
    connect(m_browser, &QTextBrowser::backwardAvailable, m_back, &QToolButton::setEnabled);
    connect(m_browser, &QTextBrowser::sourceChanged, this, [this] { m_pages->setCurrentWidget(m_browser); });
    connect(m_search, &QLineEdit::textChanged, this, &HelpViewer::search);
    connect(m_search, &QLineEdit::returnPressed, this, [this] { openHit(m_hits->currentItem()); });
    connect(m_hits, &QListWidget::itemActivated, this, &HelpViewer::open);
    connect(m_hits, &QListWidget::itemClicked, this, &HelpViewer::open);
    retranslates(this, [this] { retranslate(); });
}

QWidget* HelpViewer::makeBar()
{
    m_search->setObjectName(QStringLiteral("helpSearch"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(widgets::icons::icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_contents->setObjectName(QStringLiteral("helpContents"));
    m_back->setObjectName(QStringLiteral("helpBack"));
    m_back->setEnabled(false);
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(8, 8, 8, 8);
    for (QToolButton* button : {m_contents, m_back}) {
        button->setAutoRaise(true);
        row->addWidget(button);
    }
    row->addWidget(m_search, 1);
    return bar;
}

void HelpViewer::showPage(const QString& page)
{
    showTopic({page, {}});
}

void HelpViewer::showTopic(const HelpTopic& topic)
{
    QString file = helpPageFile(topic.page, shownLanguage());
    if (file.isEmpty())
        file = helpPageFile(indexPage(), shownLanguage());
    m_pages->setCurrentWidget(m_browser);
    m_browser->setSource(QUrl(QStringLiteral("qrc") + file), QTextDocument::MarkdownResource);
    scrollTo(headingOf(topic));
    m_browser->setFocus();
}

void HelpViewer::scrollTo(int heading)
{
    QTextBlock block = m_browser->document()->begin();
    for (int passed = 0; block.isValid(); block = block.next()) {
        if (isHeading(block) && passed++ == heading)
            break;
    }
    if (!block.isValid() || heading == 0)
        block = m_browser->document()->begin();
    m_browser->setTextCursor(QTextCursor(block));
    const QRectF place = m_browser->document()->documentLayout()->blockBoundingRect(block);
    m_browser->verticalScrollBar()->setValue(heading == 0 ? 0 : static_cast<int>(place.top()));
}

QString HelpViewer::page() const
{
    return QFileInfo(m_browser->source().path()).completeBaseName();
}

QString HelpViewer::shownHeading() const
{
    QTextBlock block = m_browser->textCursor().block();
    while (block.isValid() && !isHeading(block))
        block = block.previous();
    return block.text();
}

void HelpViewer::search(const QString& words)
{
    m_hits->clear();
    for (const HelpHit& hit : searchHelp(words, shownLanguage())) {
        const HelpSection& section = hit.section;
        const QString where =
            section.heading == 0 ? section.title : QStringLiteral("%1 › %2").arg(section.title, section.name);
        auto* item = new QListWidgetItem(where + QLatin1Char('\n') + hit.excerpt, m_hits);
        item->setData(pageRole, section.page);
        item->setData(headingRole, section.heading);
    }
    if (m_hits->count() == 0 && !words.trimmed().isEmpty()) {
        auto* nothing = new QListWidgetItem(tr("The help does not have these words together."), m_hits);
        nothing->setFlags(Qt::NoItemFlags);
    }
    m_hits->setCurrentRow(0);
    m_pages->setCurrentWidget(words.trimmed().isEmpty() ? static_cast<QWidget*>(m_browser) : m_hits);
}

void HelpViewer::openHit(const QListWidgetItem* hit)
{
    if (hit == nullptr || !hit->data(pageRole).isValid())
        return;
    showPage(hit->data(pageRole).toString());
    scrollTo(hit->data(headingRole).toInt());
}

void HelpViewer::keyPressEvent(QKeyEvent* event)
{
    const bool isInList = event->key() == Qt::Key_Up || event->key() == Qt::Key_Down;
    if (isInList && m_search->hasFocus() && m_pages->currentWidget() == m_hits) {
        m_hits->setFocus();
        m_hits->setCurrentRow(event->key() == Qt::Key_Down ? std::min(1, m_hits->count() - 1) : 0);
        return;
    }
    if (event->matches(QKeySequence::Find)) {
        m_search->setFocus();
        m_search->selectAll();
        return;
    }
    const bool isWord = !event->text().isEmpty() && event->text().front().isLetterOrNumber();
    if (isWord && !m_search->hasFocus()) { // who types without aiming looks for something
        m_search->setFocus();
        m_search->setText(event->text());
        return;
    }
    QDialog::keyPressEvent(event);
}

void HelpViewer::retranslate()
{
    setWindowTitle(tr("Quadrille help"));
    m_contents->setText(tr("Contents"));
    m_back->setText(tr("Back"));
    m_browser->setAccessibleName(tr("Help page"));
    m_hits->setAccessibleName(tr("Places found"));
    m_search->setPlaceholderText(tr("Find in the help"));
    m_search->setAccessibleName(tr("Find in the help"));
    const QString shown = page();
    showPage(shown.isEmpty() ? indexPage() : shown);
    search(m_search->text());
}

} // namespace quadrille

#include "moc_helpviewer.cpp"
