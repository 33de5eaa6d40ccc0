// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/application/session.h"

#include <QObject>
#include <optional>

class QMainWindow;

namespace quadrille {

class SequencesWorkspace;
struct ChangeEvent;
struct EditorContext;

/// Remembers how a project was last looked at, and brings it back when it is opened again.
class SessionKeeper : public QObject
{
    Q_OBJECT

public:
    SessionKeeper(EditorContext& context, SequencesWorkspace& workspace, QMainWindow& window);

    /// Remembers the open project, if it has a file, with a picture of it.
    void keep();

private:
    void follow(const ChangeEvent& event);
    void showView();

    EditorContext& m_context;
    SequencesWorkspace& m_workspace;
    QMainWindow& m_window;
    std::optional<Session> m_pending; ///< camera and frame wait for the first picture
};

} // namespace quadrille
