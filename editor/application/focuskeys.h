// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace quadrille {

/// Shares the keys between playing and the control that has the focus. Space, J, K, L and the like play
/// wherever no text is edited, so that nobody has to think of where the focus is; buttons, boxes to check and
/// choices are pressed by Return instead. Only controls that are moved along with arrows (sliders, tabs) keep
/// these. In dialogs and open menus everything is as usual.
class FocusKeys : public QObject
{
    Q_OBJECT

public:
    /// Watches the whole application for as long as it lives.
    explicit FocusKeys(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    static bool press(QObject* control, const QKeyEvent& event);
};

} // namespace quadrille
