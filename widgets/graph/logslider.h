// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QSlider;

namespace quadrille::widgets {

/// A slider over powers of ten with the number beside it. Steps of the keyboard and the wheel change the
/// value by a factor.
class LogSlider : public QWidget
{
    Q_OBJECT

public:
    /// \pre 0 < minimum < maximum.
    LogSlider(double minimum, double maximum, QWidget* parent = nullptr);

    /// Emits nothing. Values beyond the ends show as the ends.
    void setValue(double value);
    double value() const { return m_value; }
    QSlider* slider() const { return m_slider; }
    QDoubleSpinBox* spinBox() const { return m_number; }
    bool isDragging() const;

signals:
    /// While the handle is held `committed` is false; a last time with true when it is let go.
    void valueEdited(double value, bool committed);

private:
    int stepOf(double value) const;
    double valueOf(int step) const;
    void edit(double value, bool committed);
    void display(double value);

    double m_minimum;
    double m_maximum;
    double m_value;
    QSlider* m_slider;
    QDoubleSpinBox* m_number;
};

} // namespace quadrille::widgets
