// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/theme/colormap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace quadrille::widgets {

namespace {

// Every sixteenth step of matplotlib's viridis (CC0).
constexpr std::array<QRgb, 17> viridis = {0x440154, 0x48186A, 0x472D7B, 0x424086, 0x3B528B, 0x33638D,
                                          0x2C728E, 0x26828E, 0x21918C, 0x1FA088, 0x28AE80, 0x3FBC73,
                                          0x5EC962, 0x84D44B, 0xADDC30, 0xD8E219, 0xFDE725};
// Brewer's RdBu, reversed, with its middle taken to white.
constexpr std::array<QRgb, 9> blueWhiteRed = {0x2166AC, 0x4393C3, 0x92C5DE, 0xD1E5F0, 0xF7F7F7,
                                              0xFDDBC7, 0xF4A582, 0xD6604D, 0xB2182B};

QColor interpolate(std::span<const QRgb> table, double t)
{
    const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(table.size() - 1);
    const auto index = std::min(static_cast<std::size_t>(place), table.size() - 2);
    const double rest = place - static_cast<double>(index);
    const QColor a(table[index]);
    const QColor b(table[index + 1]);
    const auto mix = [rest](int from, int to) { return qRound(from + (to - from) * rest); };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

} // namespace

QColor mapColor(ColorMap map, double t)
{
    if (std::isnan(t))
        return {128, 128, 128};
    return map == ColorMap::Sequential ? interpolate(viridis, t) : interpolate(blueWhiteRed, t);
}

} // namespace quadrille::widgets
