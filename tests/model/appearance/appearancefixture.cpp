// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "appearancefixture.h"

#include "model/core/random.h"

#include <algorithm>
#include <cmath>

namespace quadrille::test {

UsedTexels texelsOfDiscs(int width, int height, const std::vector<Disc>& discs, double gutter)
{
    UsedTexels used{.width = width, .height = height, .chartCount = static_cast<int>(discs.size())};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (std::size_t d = 0; d < discs.size(); ++d) {
                const double distance = std::hypot(x - discs[d].x, y - discs[d].y);
                if (distance > discs[d].radius)
                    continue;
                used.texels.push_back(static_cast<std::uint32_t>(y * width + x));
                used.charts.push_back(static_cast<std::uint16_t>(d));
                used.covered.push_back(distance <= discs[d].radius - gutter ? 1 : 0);
            }
        }
    }
    return used;
}

UsedTexels texelsOfAtlas(int size)
{
    std::vector<Disc> discs;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            discs.push_back({size * (column + 0.5) / 4, size * (row + 0.5) / 4, size * 0.0925});
    }
    return texelsOfDiscs(size, size, discs);
}

LinearSpace randomSpace(std::vector<float> mean, int components, int samples, double spread, bool orthonormal,
                        std::uint64_t seed)
{
    LinearSpace space;
    const std::size_t size = mean.size();
    space.mean = std::move(mean);
    space.components.resize(static_cast<std::size_t>(components) * size);
    Random random(seed);
    for (int c = 0; c < components; ++c) {
        float* row = space.components.data() + static_cast<std::size_t>(c) * size;
        for (std::size_t i = 0; i < size; ++i)
            row[i] = static_cast<float>(random.between(-1, 1));
        for (int b = 0; orthonormal && b < c; ++b) {
            const float* other = space.components.data() + static_cast<std::size_t>(b) * size;
            double product = 0;
            for (std::size_t i = 0; i < size; ++i)
                product += static_cast<double>(row[i]) * static_cast<double>(other[i]);
            for (std::size_t i = 0; i < size; ++i)
                row[i] -= static_cast<float>(product) * other[i];
        }
        double squared = 0;
        for (std::size_t i = 0; i < size; ++i)
            squared += static_cast<double>(row[i]) * static_cast<double>(row[i]);
        for (std::size_t i = 0; i < size; ++i)
            row[i] /= static_cast<float>(std::sqrt(squared));
    }
    std::vector<double> deviations;
    for (int c = 0; c < components; ++c) {
        deviations.push_back(spread * std::sqrt(static_cast<double>(size)) / (1 + c));
        space.eigenvalues.push_back(deviations.back() * deviations.back());
    }
    for (int s = 0; s < samples; ++s) {
        for (const double deviation : deviations)
            space.coefficients.push_back(deviation * random.normal());
    }
    return space;
}

namespace {

/// Even waves over the nodes instead of noise.
void smoothWarps(LinearSpace& warps, const WarpGrid& grid)
{
    const std::int64_t count = warps.count();
    for (std::int64_t c = 0; c < count; ++c) {
        float* row = warps.components.data() + c * warps.size();
        double squared = 0;
        for (int j = 0; j < grid.height; ++j) {
            for (int i = 0; i < grid.width; ++i) {
                const double phase = 0.37 * static_cast<double>(c + 1);
                const std::int64_t at = 2 * (std::int64_t{j} * grid.width + i);
                row[at] = static_cast<float>(std::sin(phase * i + 0.21 * j + static_cast<double>(c)));
                row[at + 1] = static_cast<float>(std::cos(phase * j - 0.17 * i));
                squared += static_cast<double>(row[at] * row[at] + row[at + 1] * row[at + 1]);
            }
        }
        for (std::int64_t i = 0; i < warps.size(); ++i)
            row[i] /= static_cast<float>(std::sqrt(squared));
    }
}

} // namespace

AppearanceSpaces randomSpaces(const UsedTexels& texels, const FixtureSettings& settings, std::uint64_t seed)
{
    AppearanceSpaces spaces{.texels = texels, .grid = WarpGrid::over(texels.width, texels.height)};
    Random random(seed);
    std::vector<float> mean(3 * texels.texels.size());
    for (float& value : mean)
        value = static_cast<float>(random.between(40, 215));
    spaces.textures = randomSpace(std::move(mean), settings.components, settings.frames, settings.contrast,
                                  settings.orthonormal, streamSeed(seed, 1));
    std::vector<float> still(static_cast<std::size_t>(2 * spaces.grid.nodes()));
    for (float& value : still)
        value = static_cast<float>(random.between(-0.3, 0.3));
    spaces.warps = randomSpace(std::move(still), settings.warpComponents, settings.frames, settings.warp,
                               false, streamSeed(seed, 2));
    smoothWarps(spaces.warps, spaces.grid);
    for (int f = 0; f < settings.frames; ++f)
        spaces.frames.push_back({f < 3 ? "walk" : "run é", FrameIndex(f < 3 ? f : 10 * f)});
    return spaces;
}

AppearanceModel quantised(const AppearanceSpaces& spaces)
{
    return quadrille::quantised(spaces.texels, spaces.grid, spaces.textures, spaces.warps, spaces.frames);
}

AppearanceModel modelOfWaves()
{
    const UsedTexels texels = texelsOfDiscs(160, 96, {{43, 48, 40}, {121, 48, 36}});
    AppearanceSpaces spaces = randomSpaces(texels, {.components = 5, .contrast = 14, .warp = 1.5}, 31);
    LinearSpace& textures = spaces.textures;
    for (std::int64_t c = -1; c < textures.count(); ++c) {
        float* row = c < 0 ? textures.mean.data() : textures.components.data() + c * textures.size();
        double squared = 0;
        for (std::size_t t = 0; t < texels.texels.size(); ++t) {
            const int x = static_cast<int>(texels.texels[t]) % texels.width;
            const int y = static_cast<int>(texels.texels[t]) / texels.width;
            for (int channel = 0; channel < 3; ++channel) {
                const double phase = 1.3 * static_cast<double>(c) + channel;
                const double wave = std::sin((0.21 + 0.05 * static_cast<double>(c)) * x + phase) *
                                    std::cos((0.17 + 0.06 * static_cast<double>(c)) * y - phase);
                row[3 * t + static_cast<std::size_t>(channel)] =
                    static_cast<float>(c < 0 ? 125 + 70 * wave : wave);
                squared += wave * wave;
            }
        }
        for (std::int64_t i = 0; c >= 0 && i < textures.size(); ++i)
            row[i] /= static_cast<float>(std::sqrt(squared));
    }
    return quantised(spaces);
}

namespace {

std::vector<double> plainSum(const QuantisedSpace& space, const std::vector<float>& coefficients)
{
    std::vector<double> values;
    for (std::int64_t i = 0; i < space.size; ++i) {
        double value = static_cast<double>(space.meanStep) * space.mean[static_cast<std::size_t>(i)];
        for (std::size_t c = 0; c < coefficients.size(); ++c)
            value += static_cast<double>(coefficients[c]) *
                     static_cast<double>(space.component(static_cast<std::int64_t>(c), i));
        values.push_back(value);
    }
    return values;
}

/// Warp at the centre of a texel.
Vec2d plainWarp(const WarpGrid& grid, const std::vector<double>& warp, int x, int y)
{
    const double u = std::min(static_cast<double>(x) / grid.spacing, grid.width - 1.0);
    const double v = std::min(static_cast<double>(y) / grid.spacing, grid.height - 1.0);
    const int i = static_cast<int>(u);
    const int j = static_cast<int>(v);
    const auto node = [&](int a, int b) {
        const std::size_t at = 2 * static_cast<std::size_t>(std::min(b, grid.height - 1) * grid.width +
                                                            std::min(a, grid.width - 1));
        return Vec2d(warp[at], warp[at + 1]);
    };
    return (1 - v + j) * ((1 - u + i) * node(i, j) + (u - i) * node(i + 1, j)) +
           (v - j) * ((1 - u + i) * node(i, j + 1) + (u - i) * node(i + 1, j + 1));
}

} // namespace

namespace {

/// Of a value at a distance below 2.
double catmullRom(double away)
{
    const double square = away * away;
    return away < 1 ? 1.5 * away * square - 2.5 * square + 1
                    : -0.5 * away * square + 2.5 * square - 4 * away + 2;
}

} // namespace

Image plainDecode(const AppearanceModel& model, const AppearanceCoefficients& coefficients)
{
    const UsedTexels& used = model.texels;
    const std::vector<double> aligned = plainSum(model.textures, coefficients.textures);
    const std::vector<double> warp = plainSum(model.warps, coefficients.warps);
    std::vector<int> usedAt(static_cast<std::size_t>(used.width * used.height), -1);
    for (std::size_t t = 0; t < used.texels.size(); ++t)
        usedAt[used.texels[t]] = static_cast<int>(t);
    Image texture(used.width, used.height);
    for (std::size_t t = 0; t < used.texels.size(); ++t) {
        const int x = static_cast<int>(used.texels[t]) % used.width;
        const int y = static_cast<int>(used.texels[t]) / used.width;
        Vec2d offset = plainWarp(model.grid, warp, x, y);
        for (bool isDone = false; !isDone; offset /= 2) {
            const double px = std::clamp(x + offset.x(), 0.0, used.width - 1.0);
            const double py = std::clamp(y + offset.y(), 0.0, used.height - 1.0);
            const auto usedOfChart = [&](int tx, int ty) {
                if (tx < 0 || ty < 0 || tx >= used.width || ty >= used.height)
                    return -1;
                const int at = usedAt[static_cast<std::size_t>(ty * used.width + tx)];
                return at >= 0 && used.charts[static_cast<std::size_t>(at)] == used.charts[t] ? at : -1;
            };
            const int left = static_cast<int>(px);
            const int top = static_cast<int>(py);
            bool isCubic = true;
            for (int tap = 0; tap < 16; ++tap)
                isCubic = isCubic && usedOfChart(left - 1 + tap % 4, top - 1 + tap / 4) >= 0;
            double weights = 0;
            Vec3d sum = Vec3d::Zero();
            for (int tap = 0; tap < 16; ++tap) {
                const int tx = left - 1 + tap % 4;
                const int ty = top - 1 + tap / 4;
                const auto weightOf = [&](double away) {
                    return isCubic ? catmullRom(away) : std::max(0.0, 1 - away);
                };
                const int at = usedOfChart(tx, ty);
                const double weight = weightOf(std::abs(px - tx)) * weightOf(std::abs(py - ty));
                if (at < 0 || weight == 0)
                    continue;
                weights += weight;
                for (int c = 0; c < 3; ++c)
                    sum[c] +=
                        weight *
                        std::clamp(aligned[3 * static_cast<std::size_t>(at) + static_cast<std::size_t>(c)],
                                   0.0, 255.0);
            }
            isDone = weights > 0;
            for (int c = 0; isDone && c < 3; ++c)
                texture.pixel(x, y)[c] =
                    static_cast<std::uint8_t>(std::lround(std::clamp(sum[c] / weights, 0.0, 255.0)));
        }
        texture.pixel(x, y)[3] = 255;
    }
    return texture;
}

void plainFloatDecode(const AppearanceSpaces& spaces, const AppearanceCoefficients& coefficients,
                      std::vector<float>& aligned, Image& texture)
{
    const UsedTexels& used = spaces.texels;
    const auto sum = [](const LinearSpace& space, const std::vector<float>& factors) {
        std::vector<float> values = space.mean;
        for (std::size_t c = 0; c < factors.size(); ++c) {
            const float* row = space.components.data() + c * values.size();
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] += factors[c] * row[i];
        }
        return values;
    };
    const std::vector<float> values = sum(spaces.textures, coefficients.textures);
    const std::vector<float> warp = sum(spaces.warps, coefficients.warps);
    aligned.resize(3 * static_cast<std::size_t>(used.width * used.height));
    for (std::size_t t = 0; t < used.texels.size(); ++t)
        std::copy_n(values.data() + 3 * t, 3, aligned.data() + std::size_t{3} * used.texels[t]);
    const WarpGrid& grid = spaces.grid;
    for (const std::uint32_t texel : used.texels) {
        const int x = static_cast<int>(texel) % used.width;
        const int y = static_cast<int>(texel) / used.width;
        const int i = x / grid.spacing;
        const int j = y / grid.spacing;
        const float u = static_cast<float>(x % grid.spacing) / static_cast<float>(grid.spacing);
        const float v = static_cast<float>(y % grid.spacing) / static_cast<float>(grid.spacing);
        const float* upper = warp.data() + 2 * (j * grid.width + i);
        const float* lower = upper + (j + 1 < grid.height ? 2 * grid.width : 0);
        const int right = i + 1 < grid.width ? 2 : 0;
        const auto at = [&](int axis) {
            const float above = upper[axis] + u * (upper[right + axis] - upper[axis]);
            const float below = lower[axis] + u * (lower[right + axis] - lower[axis]);
            return above + v * (below - above);
        };
        const float px =
            std::clamp(static_cast<float>(x) + at(0), 0.0F, static_cast<float>(used.width) - 1.001F);
        const float py =
            std::clamp(static_cast<float>(y) + at(1), 0.0F, static_cast<float>(used.height) - 1.001F);
        const int left = static_cast<int>(px);
        const int top = static_cast<int>(py);
        const float across = px - static_cast<float>(left);
        const float down = py - static_cast<float>(top);
        const float* first = aligned.data() + 3 * (top * used.width + left);
        const float* second = first + 3 * used.width;
        std::uint8_t* colour = texture.pixel(x, y);
        for (int c = 0; c < 3; ++c) {
            const float above = first[c] + across * (first[c + 3] - first[c]);
            const float below = second[c] + across * (second[c + 3] - second[c]);
            colour[c] =
                static_cast<std::uint8_t>(std::clamp(above + down * (below - above) + 0.5F, 0.0F, 255.0F));
        }
        colour[3] = 255;
    }
}

} // namespace quadrille::test
