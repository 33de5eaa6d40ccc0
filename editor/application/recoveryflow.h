// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

class QWidget;

namespace quadrille {

class Autosave;
struct EditorContext;

/// Offers edits that a crash left unsaved.
class RecoveryFlow : public QObject
{
    Q_OBJECT

public:
    /// \param window what dialogs belong to.
    RecoveryFlow(EditorContext& context, Autosave& autosave, QWidget* window);

    /// Asks what to do with the newest copy, if there is one; nothing is lost while it is not answered.
    void offer();

private:
    EditorContext& m_context;
    Autosave& m_autosave;
    QWidget* m_window;
};

} // namespace quadrille
