// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

namespace quadrille {

/// The two parts of a transition's cost as one bar: deformation plain, duration hatched.
class CostBar : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;
    void setParts(double deformation, double duration);
    QSize sizeHint() const override { return {160, 16}; }
    QSize minimumSizeHint() const override { return {80, 16}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double m_deformation = 0;
    double m_duration = 0;
};

} // namespace quadrille
