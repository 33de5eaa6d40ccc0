// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/help/helpviewer.h"

#include "editor/help/helpbrowser.h"
#include "editor/language/retranslate.h"

#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLocale>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

namespace quadrille {

namespace {

constexpr const char* pageProperty = "helpPage";

QString indexPage()
{
    return QStringLiteral("index");
}

} // namespace

QString helpPageOf(const QWidget* widget)
{
    for (; widget != nullptr; widget = widget->parentWidget()) {
        QString page = widget->property(pageProperty).toString();
        if (!page.isEmpty())
            return page;
    }
    return indexPage();
}

void setHelpPage(QWidget* widget, const QString& page)
{
    widget->setProperty(pageProperty, page);
}

HelpViewer::HelpViewer(QWidget* parent)
    : QDialog(parent), m_browser(new HelpBrowser), m_contents(new QToolButton), m_back(new QToolButton)
{
    setObjectName(QStringLiteral("helpViewer"));
    resize(640, 720);
    m_browser->setObjectName(QStringLiteral("helpBrowser"));
    m_browser->setFrameShape(QFrame::NoFrame);
    m_browser->setOpenExternalLinks(true);
    m_browser->document()->setDocumentMargin(16);
    m_contents->setObjectName(QStringLiteral("helpContents"));
    m_contents->setAutoRaise(true);
    m_back->setObjectName(QStringLiteral("helpBack"));
    m_back->setAutoRaise(true);
    m_back->setEnabled(false);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 8, 8, 8);
    row->addWidget(m_contents);
    row->addWidget(m_back);
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(row);
    column->addWidget(m_browser, 1);
    connect(m_contents, &QToolButton::clicked, this, [this] { showPage(indexPage()); });
    connect(m_back, &QToolButton::clicked, m_browser, &QTextBrowser::backward);
    connect(m_browser, &QTextBrowser::backwardAvailable, m_back, &QToolButton::setEnabled);
    retranslates(this, [this] { retranslate(); });
}

QString HelpViewer::pageFile(const QString& page, const QString& language)
{
    for (const QString& folder : {language, QStringLiteral("en")}) {
        QString file = QStringLiteral(":/help/%1/%2.md").arg(folder, page);
        if (QFile::exists(file))
            return file;
    }
    return {};
}

void HelpViewer::showPage(const QString& page)
{
    const QString language = QLocale().name().section(QLatin1Char('_'), 0, 0);
    QString file = pageFile(page, language);
    if (file.isEmpty())
        file = pageFile(indexPage(), language);
    m_browser->setSource(QUrl(QStringLiteral("qrc") + file), QTextDocument::MarkdownResource);
}

QString HelpViewer::page() const
{
    return QFileInfo(m_browser->source().path()).completeBaseName();
}

void HelpViewer::retranslate()
{
    setWindowTitle(tr("Quadrille help"));
    m_contents->setText(tr("Contents"));
    m_back->setText(tr("Back"));
    m_browser->setAccessibleName(tr("Help page"));
    const QString shown = page();
    showPage(shown.isEmpty() ? indexPage() : shown);
}

} // namespace quadrille
