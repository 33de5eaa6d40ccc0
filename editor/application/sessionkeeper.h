// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/application/session.h"

#include <QObject>
#include <optional>

class QMainWindow;

namespace quadrille {

class Workspace;
class WorkspaceTabs;
struct ChangeEvent;
struct EditorContext;

/// Remembers how a project was last looked at, and brings it back when it is opened again; the same for the
/// window without a project.
class SessionKeeper : public QObject
{
    Q_OBJECT

public:
    /// \param sequences  the workspace whose view is remembered.
    SessionKeeper(EditorContext& context, WorkspaceTabs& workspaces, Workspace& sequences,
                  QMainWindow& window);

    /// Gives the window the place, size and docks that it had when the program was last ended.
    /// \pre It was not shown yet.
    void restoreWindow();
    /// Remembers the open project, if it has a file, with a picture of it. Draws the view for the picture,
    /// and writes both at once.
    void keep();
    /// Remembers the window itself.
    void keepWindow();

signals:
    /// What was kept cannot be used; it lies in this file now.
    void putAside(const QString& file);

private:
    Session load(const std::filesystem::path& project);
    void follow(const ChangeEvent& event);
    void showView();

    EditorContext& m_context;
    WorkspaceTabs& m_workspaces;
    Workspace& m_sequences;
    QMainWindow& m_window;
    std::optional<Session> m_pending; ///< camera and frame wait for the first picture
};

} // namespace quadrille
