// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/chartscale.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double slack = 1e-9; // relative: ticks at the very ends count

std::vector<double> linearTicks(double minimum, double maximum, int most)
{
    const double rough = (maximum - minimum) / std::max(most, 1);
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough * (1 - slack)) {
            step = factor * power;
            break;
        }
    const auto ticksAt = [minimum, maximum](double each) {
        std::vector<double> ticks;
        const double tolerance = each * 1e-6;
        for (double i = std::ceil((minimum - tolerance) / each); i * each <= maximum + tolerance; ++i)
            ticks.push_back(i * each);
        return ticks;
    };
    std::vector<double> ticks = ticksAt(step);
    // One alone says nothing of the scale.
    while (most >= 2 && maximum > minimum && ticks.size() < 2)
        ticks = ticksAt(step /= 2);
    return ticks;
}

std::vector<double> logarithmicTicks(double minimum, double maximum, int most)
{
    const auto within = [&](double value) {
        return value >= minimum * (1 - slack) && value <= maximum * (1 + slack);
    };
    const auto collect = [&](std::initializer_list<double> factors, int powerStep) {
        std::vector<double> ticks;
        const auto first = static_cast<int>(std::floor(std::log10(minimum)));
        const auto last = static_cast<int>(std::ceil(std::log10(maximum)));
        for (int power = first; power <= last; ++power)
            for (const double factor : factors)
                if (power % powerStep == 0 && within(factor * std::pow(10.0, power)))
                    ticks.push_back(factor * std::pow(10.0, power));
        return ticks;
    };
    const auto room = static_cast<std::size_t>(std::max(most, 2));
    for (auto ticks : {collect({1, 2, 5}, 1), collect({1}, 1)})
        if (ticks.size() <= room && ticks.size() >= 2)
            return ticks;
    int powerStep = 2;
    while (collect({1}, powerStep).size() > room)
        ++powerStep;
    return std::log10(maximum / minimum) > 1 ? collect({1}, powerStep) : linearTicks(minimum, maximum, most);
}

} // namespace

double ChartScale::position(double value) const
{
    const double place = isLogarithmic ? std::log(value / minimum) / std::log(maximum / minimum)
                                       : (value - minimum) / (maximum - minimum);
    return start + place * (end - start);
}

double ChartScale::value(double position) const
{
    const double place = (position - start) / (end - start);
    return isLogarithmic ? minimum * std::pow(maximum / minimum, place)
                         : minimum + place * (maximum - minimum);
}

std::vector<double> chartTicks(const ChartScale& scale, int most)
{
    return scale.isLogarithmic ? logarithmicTicks(scale.minimum, scale.maximum, most)
                               : linearTicks(scale.minimum, scale.maximum, most);
}

QString chartNumber(double value, int digits)
{
    if (value == 0 || !std::isfinite(value))
        return QLocale().toString(value, 'g', digits);
    const auto magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (magnitude < -6 || magnitude > 12)
        return QLocale().toString(value, 'g', digits);
    const int decimals = std::max(digits - 1 - magnitude, 0);
    QLocale locale;
    QString text = locale.toString(value, 'f', decimals);
    const QString point = locale.decimalPoint();
    if (!text.contains(point))
        return text;
    while (text.endsWith(locale.zeroDigit()))
        text.chop(1);
    if (text.endsWith(point))
        text.chop(point.size());
    return text;
}

} // namespace quadrille::widgets
