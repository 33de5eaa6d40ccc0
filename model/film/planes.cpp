// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/film/planes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

constexpr int fraction = 16; ///< bits

constexpr int fixed(double value)
{
    const double scaled = value * (1 << fraction);
    return static_cast<int>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
}

// BT.709: brightness is 0.2126 R + 0.7152 G + 0.0722 B; the differences are scaled to ±112.
constexpr double red = 0.2126;
constexpr double blue = 0.0722;
constexpr double green = 1 - red - blue;
constexpr std::array<int, 3> lumaOf{fixed(red * 219 / 255), fixed(green * 219 / 255),
                                    fixed(blue * 219 / 255)};
constexpr double perBlue = 112.0 / 255 / (1 - blue);
constexpr double perRed = 112.0 / 255 / (1 - red);
constexpr std::array<int, 3> bluenessOf{fixed(-red * perBlue), fixed(-green* perBlue),
                                        fixed((1 - blue) * perBlue)};
constexpr std::array<int, 3> rednessOf{fixed((1 - red) * perRed), fixed(-green* perRed),
                                       fixed(-blue* perRed)};

/// \param scale of the three values, a power of two as bits.
std::uint8_t weighted(const std::array<int, 3>& weights, int r, int g, int b, int zero, int scale)
{
    const int bits = fraction + scale;
    return static_cast<std::uint8_t>(
        (weights[0] * r + weights[1] * g + weights[2] * b + (zero << bits) + (1 << (bits - 1))) >> bits);
}

} // namespace

void toPlanes(const Image& picture, Planes& out)
{
    out.width = picture.width;
    out.height = picture.height;
    out.colorWidth = (picture.width + 1) / 2;
    out.colorHeight = (picture.height + 1) / 2;
    const auto size = [](int width, int height) {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    };
    out.luma.resize(size(out.width, out.height));
    out.blueness.resize(size(out.colorWidth, out.colorHeight));
    out.redness.resize(out.blueness.size());
    const std::uint8_t* pixel = picture.pixels.data();
    for (std::uint8_t& luma : out.luma) {
        luma = weighted(lumaOf, pixel[0], pixel[1], pixel[2], 16, 0);
        pixel += 4;
    }
    std::size_t at = 0;
    for (int y = 0; y < out.colorHeight; ++y) {
        const std::array<const std::uint8_t*, 2> rows{
            picture.pixel(0, 2 * y), picture.pixel(0, std::min(2 * y + 1, picture.height - 1))};
        for (int x = 0; x < out.colorWidth; ++x, ++at) {
            // A quarter, a half, a quarter of three columns: the mean around the even one.
            const int before = 4 * std::max(2 * x - 1, 0);
            const int here = 8 * x;
            const int after = 4 * std::min(2 * x + 1, picture.width - 1);
            std::array<int, 3> sum{};
            for (const std::uint8_t* row : rows) {
                for (int c = 0; c < 3; ++c)
                    sum[static_cast<std::size_t>(c)] += row[before + c] + 2 * row[here + c] + row[after + c];
            }
            out.blueness[at] = weighted(bluenessOf, sum[0], sum[1], sum[2], 128, 3);
            out.redness[at] = weighted(rednessOf, sum[0], sum[1], sum[2], 128, 3);
        }
    }
}

Image fromPlanes(const Planes& planes)
{
    Image picture(planes.width, planes.height);
    const auto byte = [](double value) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    };
    for (int y = 0; y < planes.height; ++y) {
        const auto row = static_cast<std::size_t>(y / 2) * static_cast<std::size_t>(planes.colorWidth);
        for (int x = 0; x < planes.width; ++x) {
            const auto left = row + static_cast<std::size_t>(x / 2);
            const auto right = row + static_cast<std::size_t>(std::min((x + 1) / 2, planes.colorWidth - 1));
            const auto difference = [&](const std::vector<std::uint8_t>& plane) {
                return (plane[left] + plane[right]) / 2.0 - 128;
            };
            const double luma =
                (planes.luma[static_cast<std::size_t>(y) * static_cast<std::size_t>(planes.width) +
                             static_cast<std::size_t>(x)] -
                 16) *
                255.0 / 219;
            const double r = luma + difference(planes.redness) / perRed;
            const double b = luma + difference(planes.blueness) / perBlue;
            std::uint8_t* pixel = picture.pixel(x, y);
            pixel[0] = byte(r);
            pixel[1] = byte((luma - red * r - blue * b) / green);
            pixel[2] = byte(b);
            pixel[3] = 255;
        }
    }
    return picture;
}

} // namespace quadrille
