// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/completionmask.h"

#include "model/core/message.h"
#include "model/core/segment.h"
#include "model/core/units.h"
#include "model/project/document/paths.h"
#include "model/project/document/throwinvalid.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// Texels of a picture, rows from the top.
struct MaskTexels
{
    int width;
    int height;
    std::span<std::uint8_t> values;
};

/// Gives the texels that are no farther than the radius from a line a value.
void paintLine(const MaskTexels& mask, const Vec2d& from, const Vec2d& to, double radius, std::uint8_t value)
{
    const auto firstOf = [&](double a, double b, int size) {
        return static_cast<int>(
            std::clamp(std::floor(std::min(a, b) - radius), 0.0, static_cast<double>(size)));
    };
    const auto endOf = [&](double a, double b, int size) {
        return static_cast<int>(
            std::clamp(std::ceil(std::max(a, b) + radius), 0.0, static_cast<double>(size)));
    };
    for (int y = firstOf(from.y(), to.y(), mask.height); y < endOf(from.y(), to.y(), mask.height); ++y) {
        for (int x = firstOf(from.x(), to.x(), mask.width); x < endOf(from.x(), to.x(), mask.width); ++x) {
            const auto texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) +
                               static_cast<std::size_t>(x);
            if (distanceFromSegment(from, to, {x + 0.5, y + 0.5}) <= radius)
                mask.values[texel] = value;
        }
    }
}

void addMask(const std::filesystem::path& file, const UsedTexels& atlas, std::span<std::uint8_t> mask)
{
    const Image picture = readImage(file);
    if (picture.width != atlas.width || picture.height != atlas.height)
        throwInvalid(file,
                     "The mask has " + sizeText(picture.width, picture.height) + " pixels, the textures " +
                         sizeText(atlas.width, atlas.height) + " texels",
                     QUADRILLE_MESSAGE("Give it the size of the textures."));
    constexpr int middle = 128; // white marks what is not known
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask[i] = picture.pixels[4 * i] >= middle ? 1 : 0;
}

} // namespace

void paintStrokes(std::span<const MaskStrokeEntry> strokes, int width, int height,
                  std::span<std::uint8_t> mask)
{
    for (const MaskStrokeEntry& stroke : strokes) {
        std::vector<Vec2d> points;
        for (std::size_t i = 0; i + 1 < stroke.points.size(); i += 2)
            points.emplace_back(stroke.points[i] * width, (1 - stroke.points[i + 1]) * height);
        for (std::size_t p = 0; p < points.size(); ++p)
            paintLine({width, height, mask}, points[p > 0 ? p - 1 : 0], points[p], stroke.radius * width,
                      stroke.erases ? 0 : 1);
    }
}

std::vector<std::uint8_t> knownTexels(const CompletionEntry& completion, const Image& texture,
                                      const UsedTexels& atlas, const std::filesystem::path& file,
                                      const std::filesystem::path& folder)
{
    if (texture.width != atlas.width || texture.height != atlas.height)
        throwInvalid(file,
                     "The texture of “" + completion.frame.sequence + "”, frame " +
                         std::to_string(completion.frame.frame.value) + ", has " +
                         sizeText(texture.width, texture.height) + " texels, those that were learned " +
                         sizeText(atlas.width, atlas.height),
                     QUADRILLE_MESSAGE("Give all textures of the character one size."));
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(atlas.width) *
                                   static_cast<std::size_t>(atlas.height));
    if (!completion.mask.empty())
        addMask(resolvePath(completion.mask, folder), atlas, mask);
    paintStrokes(completion.strokes, atlas.width, atlas.height, mask);
    for (std::uint8_t& texel : mask)
        texel = texel == 0 ? 1 : 0;
    return mask;
}

} // namespace quadrille
