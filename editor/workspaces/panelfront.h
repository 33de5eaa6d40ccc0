// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QPointer>

class QDockWidget;
class QWidget;

namespace quadrille {

/// Whether a panel can be seen: it is shown, and its dock is in front of those that share its place. (A dock
/// behind others is “visible” to Qt, which only moves it out of the window.)
class PanelFront : public QObject
{
    Q_OBJECT

public:
    /// \param panel  what is watched, and this one's parent; the dock may come later.
    explicit PanelFront(QWidget& panel);

    bool isInFront() const { return m_isInFront; }

signals:
    void changed(bool isInFront);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void watchDock();
    void update();

    QWidget& m_panel;
    QPointer<QDockWidget> m_dock;
    bool m_isInFront = false;
};

} // namespace quadrille
