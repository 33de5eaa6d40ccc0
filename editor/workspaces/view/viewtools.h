// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QToolBar>

class QSpinBox;

namespace quadrille {

class ActionRegistry;

/// The strip of tools over a view: shading, ground, ghosts with their distance, comparing, camera. Its
/// buttons are the registry's actions, so that texts, shortcuts and states are the same everywhere.
class ViewTools : public QToolBar
{
    Q_OBJECT

public:
    /// \pre the view actions are registered.
    explicit ViewTools(ActionRegistry& actions, QWidget* parent = nullptr);

    /// Frames from one ghost to the next.
    int ghostInterval() const;
    /// Shows how to lay out several sequences, or not.
    void setComparing(bool comparing);

signals:
    void ghostIntervalChanged(int frames);

private:
    void addTools(ActionRegistry& actions, const QStringList& ids);
    void retranslate();

    QSpinBox* m_interval;
    QList<QAction*> m_comparing;
};

} // namespace quadrille
