// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/ruler.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double foot = 0.3048; // metres
constexpr double inch = 0.0254;

} // namespace

Ruler::Ruler(double metresPerUnit) : m_metresPerUnit(metresPerUnit) {}

bool Ruler::isImperial() const
{
    return m_metresPerUnit == foot || m_metresPerUnit == inch;
}

double Ruler::coarse() const
{
    return of(isImperial() ? foot : 1.0);
}

double Ruler::decade() const
{
    constexpr double rounding = 1e-9;
    return std::pow(10.0, std::ceil(std::log10(m_metresPerUnit) - rounding));
}

int Ruler::decimals(int inMetres) const
{
    return std::max(0, inMetres + static_cast<int>(std::lround(std::log10(decade()))));
}

double Ruler::rounded(double length, int decimalsInMetres) const
{
    const double finest = std::pow(10.0, decimals(decimalsInMetres));
    return std::round(length * finest) / finest;
}

QString Ruler::text(double length, const QLocale& locale) const
{
    const auto text = [&](const char* pattern, double number, int decimals) {
        return QCoreApplication::translate("Length", pattern).arg(locale.toString(number, 'f', decimals));
    };
    const double metres = length * m_metresPerUnit;
    if (isImperial())
        return metres >= foot ? text(QT_TRANSLATE_NOOP("Length", "%1 ft"), metres / foot, 2)
                              : text(QT_TRANSLATE_NOOP("Length", "%1 in"), metres / inch, 2);
    constexpr double centi = 0.01;
    if (metres >= 1.0)
        return text(QT_TRANSLATE_NOOP("Length", "%1 m"), metres, 3);
    if (metres >= centi)
        return text(QT_TRANSLATE_NOOP("Length", "%1 cm"), metres * 100.0, 1);
    return text(QT_TRANSLATE_NOOP("Length", "%1 mm"), metres * 1000.0, 2);
}

} // namespace quadrille::widgets
