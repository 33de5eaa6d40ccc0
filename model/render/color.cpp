// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/color.h"

namespace quadrille {

namespace {

/// x^(1/5) for 0 < x ≤ 1, by Newton's method from above.
double fifthRoot(double x)
{
    double root = 1;
    for (int i = 0; i < 60; ++i)
        root -= (root - x / (root * root * root * root)) / 5;
    return root;
}

double decode(double srgb)
{
    if (srgb <= 0.04045)
        return srgb / 12.92;
    const double x = (srgb + 0.055) / 1.055;
    return x * x * fifthRoot(x * x); // x^2.4
}

} // namespace

SrgbTables::SrgbTables()
{
    for (std::size_t i = 0; i < m_linear.size(); ++i)
        m_linear[i] = static_cast<float>(decode(static_cast<double>(i) / 1020));
    // The inverse, by walking along the curve in steps of 1/16 of a level.
    constexpr int fineSteps = 255 * 16;
    int step = 0;
    double below = 0;
    double above = decode(1.0 / fineSteps);
    for (std::size_t i = 0; i < m_srgb.size(); ++i) {
        const double linear = static_cast<double>(i) / encodeSteps;
        while (step + 1 < fineSteps && above < linear) {
            ++step;
            below = above;
            above = decode(static_cast<double>(step + 1) / fineSteps);
        }
        const double value = (step + (linear - below) / (above - below)) / 16;
        m_srgbFine[i] = static_cast<float>(value);
        m_srgb[i] = static_cast<std::uint8_t>(std::clamp(std::lrint(value), 0L, 255L));
    }
}

const SrgbTables& SrgbTables::instance()
{
    static const SrgbTables tables;
    return tables;
}

Vec3f linearColor(std::uint32_t rgb)
{
    const Vec3f srgb(static_cast<float>(rgb >> 16U & 0xFFU), static_cast<float>(rgb >> 8U & 0xFFU),
                     static_cast<float>(rgb & 0xFFU));
    return SrgbTables::instance().toLinear(srgb);
}

} // namespace quadrille
