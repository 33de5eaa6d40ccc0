// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <vector>

namespace quadrille::widgets {

/// Values along an axis of pixels, linear or by their logarithms.
struct ChartScale
{
    double minimum = 0;
    double maximum = 1;         ///< > minimum
    bool isLogarithmic = false; ///< then minimum > 0
    double start = 0;           ///< where the minimum is, in pixels
    double end = 1;             ///< where the maximum is

    double position(double value) const;
    double value(double position) const;
};

constexpr double chartGap = 8;         ///< between the parts of a chart, logical pixels
constexpr double chartKeyZoom = 1.25;  ///< for one press of + or −
constexpr double chartWheelZoom = 1.2; ///< for one notch of the wheel
constexpr double wheelNotch = 120;     ///< eighths of a degree

/// Round values between minimum and maximum: 1, 2, 5, 10, … apart, or powers of ten and maybe their double
/// and fivefold. \param most  how many there is room for.
std::vector<double> chartTicks(const ChartScale& scale, int most);

/// A number with about so many digits that matter, without trailing zeros: "0.05", "12,300".
QString chartNumber(double value, int digits = 3);

} // namespace quadrille::widgets
