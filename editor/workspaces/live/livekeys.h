// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/live/livesteering.h"

#include <QObject>
#include <QSet>

class QKeyEvent;
class QWidget;

namespace quadrille {

/// Steers by keys while it is enabled: W, A, S, D and arrows, Page up and down for a third parameter, digits
/// for spaces, J to jump, R for the responsive mode. Fields, lists and sliders that have the focus keep
/// theirs.
class LiveKeys : public QObject
{
    Q_OBJECT

public:
    /// \param widget  whose window's keys are taken. The keys live no longer than it.
    explicit LiveKeys(QWidget& widget);

    void setEnabled(bool enabled);
    /// What is held now.
    SteeringState state() const;

signals:
    /// \param space  from 0.
    void spacePressed(int space);
    void jumpPressed();
    void responsivePressed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isMine(const QKeyEvent& event) const;
    void press(int key);

    QWidget& m_widget;
    bool m_isEnabled = false;
    QSet<int> m_held;
};

} // namespace quadrille
