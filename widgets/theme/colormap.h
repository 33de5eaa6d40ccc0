// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QString>
#include <vector>

namespace quadrille::widgets {

/// How a scalar becomes a colour. Both are safe for the colour-blind.
enum class ColorMap
{
    Sequential, ///< viridis
    Signed      ///< blue – white – red, white in the middle of the range
};

/// \param t  place in the range, clamped to 0 … 1; a NaN gives neutral grey.
QColor mapColor(ColorMap map, double t);

/// What colours of kinds mean.
struct ColorKey
{
    struct Item
    {
        QString name;
        QColor color;
        bool operator==(const Item&) const = default;
    };
    QString title;
    std::vector<Item> items;

    bool operator==(const ColorKey&) const = default;
};

/// What a legend says about a coloured quantity.
struct ScalarRange
{
    double minimum = 0.0;
    double maximum = 1.0;
    ColorMap map = ColorMap::Sequential;
    QString title;
    QString unit;

    bool operator==(const ScalarRange&) const = default;
    /// The place of a value in the range, not clamped.
    double place(double value) const
    {
        return maximum > minimum ? (value - minimum) / (maximum - minimum) : 0.5;
    }
    QColor color(double value) const { return mapColor(map, place(value)); }
};

} // namespace quadrille::widgets
