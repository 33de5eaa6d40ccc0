// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>

class QTextBrowser;
class QToolButton;

namespace quadrille {

/// The page of a widget: that of the nearest widget above it that was given one; "index" without any.
QString helpPageOf(const QWidget* widget);
/// Gives a widget, and what is in it, a page of resources/help for F1.
void setHelpPage(QWidget* widget, const QString& page);

/// Shows the help pages in the language of the interface, English where a page has no translation.
class HelpViewer : public QDialog
{
    Q_OBJECT
public:
    explicit HelpViewer(QWidget* parent = nullptr);

    /// \param page file name without ending, e.g. "importing".
    void showPage(const QString& page);
    /// The page that is shown.
    QString page() const;

    /// Folder and file of a page in a language, or in English; empty when there is no such page.
    static QString pageFile(const QString& page, const QString& language);

private:
    void retranslate();

    QTextBrowser* m_browser;
    QToolButton* m_contents;
    QToolButton* m_back;
};

} // namespace quadrille
