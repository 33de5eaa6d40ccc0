// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/logslider.h"

#include "widgets/graph/chartscale.h"
#include "widgets/theme/theme.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr int steps = 1000;          // of the slider from end to end
constexpr double keyFactor = 1.0593; // a twelfth of doubling
constexpr int digits = 3;            // that matter

double rounded(double value)
{
    const double power = std::pow(10.0, digits - 1 - std::floor(std::log10(value)));
    return std::round(value * power) / power;
}

/// Shows as many digits as matter, and steps by a factor.
class FactorSpinBox : public QDoubleSpinBox
{
public:
    using QDoubleSpinBox::QDoubleSpinBox;
    QString textFromValue(double value) const override { return chartNumber(value, digits); }
    void stepBy(int count) override
    {
        const double stepped = rounded(value() * std::pow(keyFactor, count));
        const double least = std::pow(10.0, std::floor(std::log10(value())) - digits + 1);
        setValue(stepped != value() ? stepped : value() + count * least);
    }
};

} // namespace

LogSlider::LogSlider(double minimum, double maximum, QWidget* parent)
    : QWidget(parent)
    , m_minimum(minimum)
    , m_maximum(maximum)
    , m_value(minimum)
    , m_slider(new QSlider(Qt::Horizontal))
    , m_number(new FactorSpinBox)
{
    m_slider->setRange(0, steps);
    m_slider->setSingleStep(steps / 100);
    m_slider->setPageStep(steps / 20);
    m_slider->setMinimumWidth(120);
    m_slider->setObjectName(QStringLiteral("logSliderHandle"));
    m_number->setRange(minimum, maximum);
    m_number->setDecimals(std::max(0, static_cast<int>(std::ceil(-std::log10(minimum))) + digits - 1));
    m_number->setObjectName(QStringLiteral("logSliderNumber"));
    m_number->setFont(Theme::tabularFont(m_number->font()));
    m_number->setAlignment(Qt::AlignRight);
    m_number->setKeyboardTracking(false);
    m_number->setMinimumWidth(84);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_slider, 1);
    row->addWidget(m_number);
    setFocusProxy(m_slider);
    display(minimum);
    connect(m_slider, &QSlider::valueChanged, this,
            [this](int step) { edit(rounded(valueOf(step)), !m_slider->isSliderDown()); });
    connect(m_slider, &QSlider::sliderReleased, this, [this] { emit valueEdited(m_value, true); });
    connect(m_number, &QDoubleSpinBox::valueChanged, this, [this](double number) { edit(number, true); });
}

bool LogSlider::isDragging() const
{
    return m_slider->isSliderDown();
}

void LogSlider::setValue(double value)
{
    if (isDragging())
        return;
    display(std::clamp(value, m_minimum, m_maximum));
}

void LogSlider::display(double value)
{
    m_value = value;
    const QSignalBlocker slider(m_slider);
    const QSignalBlocker number(m_number);
    // The handle stays where the user put it, though the number is a rounded one.
    if (!m_slider->isSliderDown() && value != rounded(valueOf(m_slider->value())))
        m_slider->setValue(stepOf(value));
    m_number->setValue(value);
}

void LogSlider::edit(double value, bool committed)
{
    display(std::clamp(value, m_minimum, m_maximum));
    emit valueEdited(m_value, committed);
}

int LogSlider::stepOf(double value) const
{
    return static_cast<int>(
        std::lround(steps * std::log(value / m_minimum) / std::log(m_maximum / m_minimum)));
}

double LogSlider::valueOf(int step) const
{
    return m_minimum * std::pow(m_maximum / m_minimum, static_cast<double>(step) / steps);
}

} // namespace quadrille::widgets
