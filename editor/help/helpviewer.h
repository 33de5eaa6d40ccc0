// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/help/helptopics.h"

#include <QDialog>

class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QStackedWidget;
class QTextBrowser;
class QToolButton;

namespace quadrille {

/// Shows the help pages in the language of the interface, English where a page has no translation, and finds
/// words in them.
class HelpViewer : public QDialog
{
    Q_OBJECT
public:
    explicit HelpViewer(QWidget* parent = nullptr);

    /// \param page file name without ending, e.g. "importing".
    void showPage(const QString& page);
    /// Shows a page from one of its headings on.
    void showTopic(const HelpTopic& topic);
    /// The page that is shown.
    QString page() const;
    /// The heading that is uppermost.
    QString shownHeading() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* makeBar();
    void scrollTo(int heading);
    void search(const QString& words);
    void openHit(const QListWidgetItem* hit);
    void retranslate();

    QTextBrowser* m_browser;
    QListWidget* m_hits;
    QStackedWidget* m_pages;
    QLineEdit* m_search;
    QToolButton* m_contents;
    QToolButton* m_back;
};

} // namespace quadrille
