// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/measuretext.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

namespace quadrille {

namespace {

struct MeasureText
{
    Q_DECLARE_TR_FUNCTIONS(MeasureText)
};

} // namespace

QString measureText(double value, SpaceMeasure measure)
{
    const int decimals = measure == SpaceMeasure::Turning ? 0 : 2;
    const double unit = std::pow(10.0, decimals);
    const double rounded = std::round(value * unit) / unit + 0.0; // + 0: never “-0”
    QString number = QLocale().toString(rounded, 'f', decimals);
    switch (measure) {
    case SpaceMeasure::Speed:
        return MeasureText::tr("%1 m/s").arg(number);
    case SpaceMeasure::Turning:
        return MeasureText::tr("%1 °/s").arg(number);
    case SpaceMeasure::ByHand:
        return number;
    default:
        return MeasureText::tr("%1 m").arg(number);
    }
}

} // namespace quadrille
