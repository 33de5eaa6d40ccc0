// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

namespace quadrille {

/// The wheel turns a field – of numbers, of choices, a slider, tabs – only where the keyboard is, too;
/// otherwise it goes on to what scrolls around it, and takes the keyboard nowhere.
class WheelFocus : public QObject
{
    Q_OBJECT

public:
    /// Watches the whole application for as long as it lives.
    explicit WheelFocus(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace quadrille
