// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QStackedWidget;
class QToolButton;
class QTreeView;

namespace quadrille {

class IssueLog;

/// Content of the Issues dock: what went wrong and what was noticed, newest last; double click, Enter or the
/// button goes to the culprit.
class IssuesPanel : public QWidget
{
    Q_OBJECT
public:
    explicit IssuesPanel(IssueLog& log, QWidget* parent = nullptr);

private:
    void retranslate();
    void updateState();
    void showMenu(const QPoint& position);

    IssueLog& m_log;
    QTreeView* m_list;
    QLabel* m_summary;
    QLabel* m_empty;
    QStackedWidget* m_pages;
    QToolButton* m_show;
    QToolButton* m_clear;
};

} // namespace quadrille
