// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QPushButton>

namespace quadrille::widgets {

/// A button that takes the width that it is given: a longer text is cut in its middle, which keeps the ending
/// of a file's name.
class ElidedButton : public QPushButton
{
    Q_OBJECT
public:
    explicit ElidedButton(QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace quadrille::widgets
