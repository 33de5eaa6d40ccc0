// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <array>

namespace quadrille {

/// The parts of a transition's cost as one bar: deformation – poses, feet and speeds – plain, duration
/// hatched.
class CostBar : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;
    /// \param deformation  of poses, feet and speeds.
    void setParts(const std::array<double, 3>& deformation, double duration);
    QSize sizeHint() const override { return {160, 16}; }
    QSize minimumSizeHint() const override { return {80, 16}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::array<double, 3> m_deformation{};
    double m_duration = 0;
};

} // namespace quadrille
