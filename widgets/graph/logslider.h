// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QWidget>
#include <vector>

class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace quadrille::widgets {

/// A slider over powers of ten with the number beside it, a curve behind it and the names of its ends below.
/// Steps of the keyboard and the wheel change the value by a factor.
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
    /// Whether the handle is held.
    bool isDragging() const;
    /// What the ends stand for, in a word each; the place for them is there once there are any.
    void setEnds(const QString& low, const QString& high);
    /// What goes with the values, drawn behind the handle: values ascending, heights from 0 to 1. None: no
    /// curve.
    void setCurve(std::vector<QPointF> curve);
    const std::vector<QPointF>& curve() const { return m_curve; }
    /// Where a value of the curve is drawn, in this widget's coordinates.
    QPointF curvePosition(const QPointF& point) const;

signals:
    /// While the handle is held `committed` is false; a last time with true when it is let go.
    void valueEdited(double value, bool committed);

protected:
    void paintEvent(QPaintEvent* event) override;

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
    QLabel* m_low;
    QLabel* m_high;
    std::vector<QPointF> m_curve;
};

} // namespace quadrille::widgets
