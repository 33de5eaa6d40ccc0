// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

namespace quadrille {

/// Gives a control that has the focus the keys that it is used with, before the window takes them for
/// shortcuts: Space presses a button there and does not play.
class FocusKeys : public QObject
{
    Q_OBJECT

public:
    /// Watches the whole application for as long as it lives.
    explicit FocusKeys(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace quadrille
