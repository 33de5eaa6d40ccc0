// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/application/actionregistry.h"
#include "editor/workspaces/workspace.h"

#include <QHash>
#include <QJsonObject>
#include <vector>

class QDockWidget;
class QMainWindow;
class QStackedWidget;
class QTabBar;
class QToolBar;

namespace quadrille {

class ViewActions;
struct EditorContext;

/// The workspaces of the window as tabs on top. Each has its own arrangement of docks, which comes back with
/// it.
class WorkspaceTabs : public QWidget
{
    Q_OBJECT

public:
    struct Entry
    {
        QString id; ///< "graph": of its action "workspace.graph", of sessions
        ActionRegistry::Text title;
        Workspace* workspace;
        QList<QDockWidget*> docks;    ///< its own; hidden in all others
        bool hidesProperties = false; ///< the first time
    };

    WorkspaceTabs(EditorContext& context, QMainWindow& window);

    void setPropertiesDock(QDockWidget* dock) { m_properties = dock; }
    /// Adds a workspace at the end. \pre Called before the window's state is restored.
    void add(Entry entry);
    /// Shows the first workspace; all have been added.
    void begin();
    /// The tabs are hidden while there is no project to work on.
    void showStrip(bool shown);
    void select(const QString& id);
    QString current() const;
    Workspace* currentWorkspace() const;
    ViewActions& viewActions() { return *m_viewActions; }

    /// The arrangements of all workspaces, for a session.
    QJsonObject states();
    /// Takes arrangements from a session; workspaces that it does not name keep theirs.
    void setStates(const QJsonObject& states);

signals:
    void currentChanged(const QString& id);

private:
    void show(int index);
    void retranslate();
    void arrangeDocks(int index);

    EditorContext& m_context;
    QMainWindow& m_window;
    QToolBar* m_strip;
    QTabBar* m_bar;
    QStackedWidget* m_pages;
    ViewActions* m_viewActions;
    QDockWidget* m_properties = nullptr;
    std::vector<Entry> m_entries;
    QHash<QString, QByteArray> m_states;
    int m_current = -1;
};

} // namespace quadrille
