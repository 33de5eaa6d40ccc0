// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>
#include <vector>

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;
class QTabBar;

namespace quadrille {

/// What shows and hides the panels of the window, in menus and on the panels' titles. An action brings its
/// panel to the front, where it was hidden or behind others, and hides it otherwise.
class PanelActions : public QObject
{
    Q_OBJECT

public:
    /// \param docks  all there are, which outlive this.
    PanelActions(const QList<QDockWidget*>& docks, QMainWindow& window);

    /// Of all docks; those of other workspaces are not visible.
    QList<QAction*> actions() const;

signals:
    /// The right mouse button, or the key of the menu, on the title of a panel. \param menu  has what is
    /// about the panel; more may be added.
    void menuRequested(QDockWidget* dock, QMenu& menu);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Item
    {
        QDockWidget* dock;
        QAction* action;
        bool isInFront = false;
    };
    void add(QDockWidget* dock);
    void toggle(const QDockWidget* dock);
    void showMenu(QDockWidget* dock, const QPoint& place);
    bool showTabMenu(QTabBar& tabs, const QPoint& place, const QPoint& onScreen);

    QMainWindow& m_window;
    std::vector<Item> m_items;
};

} // namespace quadrille
