// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/sliderfield.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>

namespace quadrille {

SliderField::SliderField(const char* slider, const char* number, QWidget* parent)
    : QWidget(parent), m_slider(new QSlider(Qt::Horizontal)), m_number(new QSpinBox)
{
    m_slider->setObjectName(QLatin1String(slider));
    m_number->setObjectName(QLatin1String(number));
    m_number->setAlignment(Qt::AlignRight);
    m_number->setKeyboardTracking(false);
    setMaximum(100);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_slider, 1);
    row->addWidget(m_number);
    setFocusProxy(m_slider);
    connect(m_slider, &QSlider::valueChanged, this,
            [this](int value) { emit edited(value, !m_slider->isSliderDown()); });
    connect(m_slider, &QSlider::sliderReleased, this, [this] { emit edited(m_slider->value(), true); });
    connect(m_number, &QSpinBox::valueChanged, this, [this](int value) { emit edited(value, true); });
}

void SliderField::setMaximum(int maximum)
{
    const QSignalBlocker blocks[] = {QSignalBlocker(m_slider), QSignalBlocker(m_number)};
    m_slider->setRange(0, maximum);
    m_number->setRange(0, maximum);
}

void SliderField::setValue(int value)
{
    const QSignalBlocker blocks[] = {QSignalBlocker(m_slider), QSignalBlocker(m_number)};
    if (!m_slider->isSliderDown())
        m_slider->setValue(value);
    m_number->setValue(value);
}

void SliderField::setTexts(const QString& name, const QString& unit, const QString& tip)
{
    m_slider->setAccessibleName(name);
    m_number->setAccessibleName(name);
    m_number->setSuffix(unit);
    setToolTip(tip);
}

} // namespace quadrille

#include "moc_sliderfield.cpp"
