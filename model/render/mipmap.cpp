// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/mipmap.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace quadrille {

namespace {

/// Half the size, each pixel the rounded mean of four; what is left over where the size is odd is left out.
Image halved(const Image& source)
{
    Image half(std::max(source.width / 2, 1), std::max(source.height / 2, 1));
    const cv::Mat from(std::min(source.height, 2 * half.height), std::min(source.width, 2 * half.width),
                       CV_8UC4, const_cast<std::uint8_t*>(source.pixels.data()),
                       static_cast<std::size_t>(source.width) * 4);
    cv::Mat to(half.height, half.width, CV_8UC4, half.pixels.data());
    cv::resize(from, to, to.size(), 0, 0, cv::INTER_AREA);
    return half;
}

/// Base-2 logarithm of a positive normal number, exact at powers of two, linear between them.
float roughLog2(float value)
{
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return static_cast<float>(static_cast<std::int32_t>(bits) - 0x3F800000) / 8388608.0F;
}

} // namespace

MipTexture::MipTexture(std::shared_ptr<const Image> image) : m_full(std::move(image))
{
    const Image* last = m_full.get();
    while (last->width > 1 || last->height > 1) {
        m_smaller.push_back(halved(*last));
        last = &m_smaller.back();
    }
}

const Image& MipTexture::level(int index) const
{
    return index == 0 ? *m_full : m_smaller[static_cast<std::size_t>(index - 1)];
}

Vec3f MipTexture::bilinear(const Image& image, const Vec2f& uv) const
{
    // uv is within 0 … 1; positions are in 1/256 of a texel, the first texel's middle at 0.
    const int x = static_cast<int>(std::lrint(uv.x() * static_cast<float>(image.width) * 256.0F)) - 128;
    const int y =
        static_cast<int>(std::lrint((1 - uv.y()) * static_cast<float>(image.height) * 256.0F)) - 128;
    const auto wrapped = [](int i, int size) { return i < 0 ? i + size : i >= size ? i - size : i; };
    const int x0 = wrapped(x >> 8, image.width);
    const int y0 = wrapped(y >> 8, image.height);
    const int x1 = wrapped(x0 + 1, image.width);
    const int y1 = wrapped(y0 + 1, image.height);
    const int fx = x & 255;
    const int fy = y & 255;
    const int w11 = fx * fy;
    const int w10 = 256 * fx - w11; // right, upper
    const int w01 = 256 * fy - w11;
    const int w00 = 65536 - 256 * fx - 256 * fy + w11;
    const std::uint8_t* a = image.pixel(x0, y0);
    const std::uint8_t* b = image.pixel(x1, y0);
    const std::uint8_t* c = image.pixel(x0, y1);
    const std::uint8_t* d = image.pixel(x1, y1);
    const auto mix = [&](int i) {
        return static_cast<float>(a[i] * w00 + b[i] * w10 + c[i] * w01 + d[i] * w11) * (1.0F / 65536.0F);
    };
    return {mix(0), mix(1), mix(2)};
}

Vec3f MipTexture::sample(const Vec2f& uv, float level) const
{
    const auto repeated = [](float value) {
        const float fraction = value - std::floor(value);
        return fraction >= 0 && fraction <= 1 ? fraction : 0.0F; // also where it is not a number
    };
    const Vec2f inside(repeated(uv.x()), repeated(uv.y()));
    const auto last = static_cast<float>(m_smaller.size());
    const float clamped = std::clamp(level, 0.0F, last);
    const int lower = static_cast<int>(clamped);
    const float fraction = clamped - static_cast<float>(lower);
    Vec3f fine = bilinear(this->level(lower), inside);
    if (fraction < 1.0F / 64.0F)
        return fine;
    return fine + (bilinear(this->level(lower + 1), inside) - fine) * fraction;
}

float MipTexture::levelFor(const Vec2f& alongX, const Vec2f& alongY)
{
    // The footprint's area rules, so that slanted surfaces stay sharp; supersampling covers its length.
    const float area = std::abs(alongX.x() * alongY.y() - alongX.y() * alongY.x());
    const float longest = std::max(alongX.squaredNorm(), alongY.squaredNorm());
    const float size = std::max(area, longest * (1.0F / 16.0F));
    if (!(size > 1.0F))
        return 0;
    return roughLog2(std::min(size, 1e12F)) * 0.5F;
}

} // namespace quadrille
