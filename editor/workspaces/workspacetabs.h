// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/context/actionregistry.h"
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
    /// The dock that is in front of those at its place, the first time.
    void setFirstDock(QDockWidget* dock) { m_first = dock; }
    /// Adds a workspace at the end. \pre Called before the window's state is restored.
    void add(Entry entry);
    /// Shows the first workspace; all have been added.
    void begin();
    /// Tabs and docks are hidden while there is no project to work on; what is hidden comes back as it was.
    void setShown(bool shown);
    /// Shows a workspace; nothing happens for one that is not there.
    void select(const QString& id);
    /// Its id; empty before `begin`.
    QString current() const;
    Workspace* currentWorkspace() const;
    ViewActions& viewActions() { return *m_viewActions; }

    /// The arrangements of all workspaces, for a session.
    QJsonObject states();
    /// Takes arrangements from a session; workspaces that it does not name keep theirs. The workspace that is
    /// shown is arranged at once.
    void setStates(const QJsonObject& states);

    /// What all workspaces keep for a session by their ids, and back.
    QJsonObject looks() const;
    void setLooks(const QJsonObject& looks);

    /// How the docks of the workspace that is shown are arranged now.
    QByteArray arrangement() const;
    /// Arranges them so. \param state  as `arrangement` gave it.
    void setArrangement(const QByteArray& state);
    /// Arranges them as they were at first.
    void resetArrangement();

signals:
    /// Another workspace is shown, by its id.
    void currentChanged(const QString& id);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show(int index);
    void retranslate();
    bool hasFocusOf(int index) const;
    void arrange();
    void arrangeDocks(int index);
    void arrangeFirst(const Entry& entry);
    void keepState();

    EditorContext& m_context;
    QMainWindow& m_window;
    QToolBar* m_strip;
    QTabBar* m_bar;
    QStackedWidget* m_pages;
    ViewActions* m_viewActions;
    QDockWidget* m_properties = nullptr;
    QDockWidget* m_first = nullptr;
    std::vector<Entry> m_entries;
    QHash<QString, QByteArray> m_states;
    QByteArray m_firstState;      ///< of all docks, before anything was restored
    QList<QDockWidget*> m_hidden; ///< while there is no project
    int m_current = -1;
    bool m_isShown = true;
    bool m_awaitsSize = false; ///< the window is to fill the screen, and may not be as large yet
};

} // namespace quadrille
