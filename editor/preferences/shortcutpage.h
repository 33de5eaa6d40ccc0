// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QKeySequenceEdit;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace quadrille {

class ActionRegistry;

namespace widgets {
class MessageStrip;
} // namespace widgets

/// The shortcut of every action, to be found, changed and given back.
class ShortcutPage : public QWidget
{
    Q_OBJECT

public:
    explicit ShortcutPage(ActionRegistry& actions, QWidget* parent = nullptr);

private:
    void fill();
    void filter(const QString& text);
    void showCurrent();
    void change();
    void resetCurrent();
    void resetAll();
    void retranslate();
    QAction* actionOf(const QTreeWidgetItem* item) const;

    ActionRegistry& m_actions;
    QLineEdit* m_search;
    QTreeWidget* m_list;
    QKeySequenceEdit* m_keys;
    QPushButton* m_reset;
    QPushButton* m_resetAll;
    widgets::MessageStrip* m_strip;
};

} // namespace quadrille
