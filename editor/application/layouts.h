// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QMenu>
#include <QObject>
#include <QPointer>
#include <QStringList>

class QMainWindow;

namespace quadrille {

class ActionRegistry;
class WorkspaceTabs;

/// Arrangements of panels that the user has given names, for each workspace; kept beside the user's sessions.
class Layouts
{
public:
    /// Reads the file of layouts; blocks.
    Layouts();

    /// In alphabetical order.
    QStringList names(const QString& workspace) const;
    /// As QMainWindow::saveState gave it; empty when there is none of this name.
    QByteArray state(const QString& workspace, const QString& name) const;
    /// Takes the place of another of the same name. It is written at once; so for `remove`.
    void save(const QString& workspace, const QString& name, const QByteArray& state);
    void remove(const QString& workspace, const QString& name);

private:
    void write() const;

    QJsonObject m_all; ///< workspace → name → state
};

/// The menu of layouts: saves, applies, deletes and resets those of the workspace that is shown.
class LayoutMenu : public QObject
{
    Q_OBJECT

public:
    LayoutMenu(ActionRegistry& actions, WorkspaceTabs& workspaces, QMainWindow& window);

    /// Keeps a menu filled with the layouts of the workspace that is shown.
    void fill(QMenu& menu);

private:
    void makeActions();
    void refill(QMenu& menu);
    void askName();

    ActionRegistry& m_actions;
    WorkspaceTabs& m_workspaces;
    QMainWindow& m_window;
    Layouts m_layouts;
    QPointer<QMenu> m_removal;
};

} // namespace quadrille
