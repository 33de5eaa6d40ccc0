// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/logslider.h"

#include "widgets/graph/chartscale.h"
#include "widgets/theme/theme.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr int steps = 1000;          // of the slider from end to end
constexpr double keyFactor = 1.0593; // a twelfth of doubling
constexpr int digits = 3;            // that matter
constexpr int sliderHeight = 28;     // logical pixels, with room for the curve

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
    , m_low(new QLabel)
    , m_high(new QLabel)
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
    m_slider->setMinimumHeight(sliderHeight);
    m_low->setObjectName(QStringLiteral("logSliderLow"));
    m_high->setObjectName(QStringLiteral("logSliderHigh"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(0);
    grid->addWidget(m_slider, 0, 0, 1, 2);
    grid->addWidget(m_number, 0, 2);
    grid->addWidget(m_low, 1, 0, Qt::AlignLeft);
    grid->addWidget(m_high, 1, 1, Qt::AlignRight);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    for (QLabel* end : {m_low, m_high}) {
        end->setForegroundRole(QPalette::PlaceholderText);
        end->hide();
    }
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
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

void LogSlider::setEnds(const QString& low, const QString& high)
{
    m_low->setText(low);
    m_high->setText(high);
    m_low->setVisible(!low.isEmpty());
    m_high->setVisible(!high.isEmpty());
}

void LogSlider::setCurve(std::vector<QPointF> curve)
{
    m_curve = std::move(curve);
    update();
}

QPointF LogSlider::curvePosition(const QPointF& point) const
{
    // The middle of the handle runs from half its width to as far before the end.
    const double inset = m_slider->style()->pixelMetric(QStyle::PM_SliderLength, nullptr, m_slider) / 2.0;
    const QRectF place = QRectF(m_slider->geometry()).adjusted(inset, 1, -inset, -1);
    const double along = std::log(point.x() / m_minimum) / std::log(m_maximum / m_minimum);
    return {place.left() + along * place.width(), place.bottom() - point.y() * place.height()};
}

void LogSlider::paintEvent(QPaintEvent* /*event*/)
{
    if (m_curve.size() < 2)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPolygonF line;
    for (const QPointF& point : m_curve)
        line += curvePosition({std::clamp(point.x(), m_minimum, m_maximum), point.y()});
    const double ground = curvePosition({m_minimum, 0}).y();
    QPolygonF area = line;
    area += QPointF(line.last().x(), ground);
    area += QPointF(line.first().x(), ground);
    constexpr float opacity = 0.16F;
    QColor color = Theme::color(ColorRole::AccentText);
    painter.setPen(QPen(color, 1.5));
    painter.drawPolyline(line);
    color.setAlphaF(opacity);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPolygon(area);
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

#include "moc_logslider.cpp"
