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

/// Gives a window the place and size that it had, as far as the screen of now has room.
void restoreWindow(QMainWindow& window, const QByteArray& geometry);

/// Remembers how a project was last looked at, and brings it back when it is opened again.
class SessionKeeper : public QObject
{
    Q_OBJECT

public:
    /// \param sequences  the workspace whose view is remembered.
    SessionKeeper(EditorContext& context, WorkspaceTabs& workspaces, Workspace& sequences,
                  QMainWindow& window);

    /// Remembers the open project, if it has a file, with a picture of it.
    void keep();

private:
    void follow(const ChangeEvent& event);
    void showView();

    EditorContext& m_context;
    WorkspaceTabs& m_workspaces;
    Workspace& m_sequences;
    QMainWindow& m_window;
    std::optional<Session> m_pending; ///< camera and frame wait for the first picture
};

} // namespace quadrille
