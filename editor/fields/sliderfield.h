// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QSlider;
class QSpinBox;

namespace quadrille {

/// A whole number from zero on that is dragged, or typed beside the slider.
class SliderField : public QWidget
{
    Q_OBJECT

public:
    /// \param slider, number  object names.
    SliderField(const char* slider, const char* number, QWidget* parent = nullptr);

    /// Shows a value; nothing is emitted, and a slider that is dragged stays under the pointer.
    void setValue(int value);
    void setMaximum(int maximum);
    /// \param name  what it is. \param unit  behind the number.
    void setTexts(const QString& name, const QString& unit, const QString& tip);

signals:
    /// The user chose another value. \param isFinal  false while the slider is dragged.
    void edited(int value, bool isFinal);

private:
    QSlider* m_slider;
    QSpinBox* m_number;
};

} // namespace quadrille
