// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/texturequality.h"

#include "model/appearance/qualitykernels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

std::array<float, windowWidth> windowWeights()
{
    constexpr double deviation = 1.5;
    std::array<double, windowWidth> weights{};
    double sum = 0;
    for (int k = 0; k < windowWidth; ++k) {
        const double z = (k - windowReach) / deviation;
        weights[static_cast<std::size_t>(k)] = std::exp(-z * z / 2);
        sum += weights[static_cast<std::size_t>(k)];
    }
    std::array<float, windowWidth> result{};
    std::ranges::transform(weights, result.begin(),
                           [sum](double weight) { return static_cast<float>(weight / sum); });
    return result;
}

/// Pixels of a picture, from first to behind the last.
struct PixelBox
{
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
};

/// Around the pixels of a mask; outside of it pixels count as little as outside of the picture.
PixelBox boxOf(std::span<const std::uint8_t> mask, int width, int height)
{
    if (mask.empty())
        return {0, 0, width, height};
    PixelBox box{width, height, 0, 0};
    for (int y = 0; y < height; ++y) {
        const auto row = mask.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(width),
                                      static_cast<std::size_t>(width));
        const auto counts = [](std::uint8_t pixel) { return pixel != 0; };
        const auto first = std::ranges::find_if(row, counts);
        if (first == row.end())
            continue;
        const auto behind = std::find_if(row.rbegin(), row.rend(), counts).base();
        box.left = std::min(box.left, static_cast<int>(first - row.begin()));
        box.right = std::max(box.right, static_cast<int>(behind - row.begin()));
        box.top = std::min(box.top, y);
        box.bottom = y + 1;
    }
    return box;
}

/// The moments of two pictures in a box, filtered along rows; the rows of one window are kept.
class FilteredRows
{
public:
    /// \pre The box is not empty, and all of the mask lies in it.
    FilteredRows(const Image& reference, const Image& picture, std::span<const std::uint8_t> mask,
                 const PixelBox& box)
        : m_reference(reference)
        , m_picture(picture)
        , m_mask(mask)
        , m_box(box)
        , m_width(static_cast<std::size_t>(box.right - box.left))
        , m_stride(m_width + windowWidth - 1)
        , m_padded(momentCount * m_stride)
        , m_kept(windowWidth * rowSize())
        , m_nothing(rowSize())
        , m_moments(rowSize())
    {
    }

    /// \pre Rows are made in their order.
    void make(int y)
    {
        const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(m_reference.width) +
                           static_cast<std::size_t>(m_box.left);
        pixelMoments(m_reference.pixels.data() + 4 * first, m_picture.pixels.data() + 4 * first,
                     m_mask.empty() ? nullptr : m_mask.data() + first, static_cast<int>(m_width),
                     m_padded.data() + windowReach, static_cast<int>(m_stride));
        for (std::size_t m = 0; m < momentCount; ++m)
            filterRow(m_padded.data() + m * m_stride, static_cast<int>(m_width), m_weights.data(),
                      m_kept.data() + slot(y) + m * m_width);
    }
    /// SSIM of a row of the box. \pre All rows of its windows were made.
    void similarity(int y, float* values)
    {
        std::array<const float*, windowWidth> rows;
        for (int k = 0; k < windowWidth; ++k) {
            const int row = y + k - windowReach;
            const bool isInside = row >= m_box.top && row < m_box.bottom;
            rows[static_cast<std::size_t>(k)] = isInside ? m_kept.data() + slot(row) : m_nothing.data();
        }
        similarityOfRow(rows.data(), static_cast<int>(m_width), m_weights.data(), m_moments.data(), values);
    }

private:
    std::size_t rowSize() const { return momentCount * m_width; }
    std::size_t slot(int y) const { return static_cast<std::size_t>(y % windowWidth) * rowSize(); }

    const Image& m_reference;
    const Image& m_picture;
    std::span<const std::uint8_t> m_mask;
    PixelBox m_box;
    std::size_t m_width;
    std::size_t m_stride;
    std::array<float, windowWidth> m_weights = windowWeights();
    std::vector<float> m_padded;  ///< moments × stride of one row, zero beyond both ends
    std::vector<float> m_kept;    ///< windowWidth × moments × width
    std::vector<float> m_nothing; ///< a row outside of the box
    std::vector<float> m_moments; ///< of the windows about a row
};

} // namespace

std::vector<float> similarityMap(const Image& reference, const Image& picture,
                                 std::span<const std::uint8_t> mask)
{
    assert(reference.width == picture.width && reference.height == picture.height);
    assert(mask.empty() || 4 * mask.size() == reference.pixels.size());
    std::vector<float> map(reference.pixels.size() / 4);
    const PixelBox box = boxOf(mask, reference.width, reference.height);
    if (box.left >= box.right)
        return map;
    FilteredRows rows(reference, picture, mask, box);
    int made = box.top;
    for (int y = box.top; y < box.bottom; ++y) {
        for (; made < std::min(box.bottom, y + windowReach + 1); ++made)
            rows.make(made);
        rows.similarity(y, map.data() + std::ptrdiff_t{y} * reference.width + box.left);
    }
    for (std::size_t i = 0; i < mask.size(); ++i)
        map[i] = mask[i] != 0 ? map[i] : 0;
    return map;
}

PictureQuality pictureQuality(const Image& reference, const Image& picture,
                              std::span<const std::uint8_t> mask)
{
    const std::vector<float> map = similarityMap(reference, picture, mask);
    double similarity = 0;
    std::int64_t squares = 0;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < map.size(); ++i) {
        if (!mask.empty() && mask[i] == 0)
            continue;
        similarity += static_cast<double>(map[i]);
        for (std::size_t c = 0; c < 3; ++c) {
            const int difference = int{reference.pixels[4 * i + c]} - int{picture.pixels[4 * i + c]};
            squares += std::int64_t{difference} * difference;
        }
        ++count;
    }
    if (count == 0)
        return {};
    return {similarity / static_cast<double>(count),
            static_cast<double>(squares) / static_cast<double>(3 * count)};
}

PictureQuality textureQuality(const Image& reference, const Image& texture, const UsedTexels& texels)
{
    assert(reference.width == texels.width && reference.height == texels.height);
    return pictureQuality(reference, texture, coveredMask(texels));
}

std::vector<std::uint8_t> coveredMask(const UsedTexels& texels)
{
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(texels.width) *
                                   static_cast<std::size_t>(texels.height));
    for (std::size_t t = 0; t < texels.texels.size(); ++t)
        mask[texels.texels[t]] = texels.covered[t];
    return mask;
}

} // namespace quadrille
