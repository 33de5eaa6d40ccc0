// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/completionmask.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/core/units.h"
#include "model/project/document/paths.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

double distanceToSegment(const Vec2d& point, const Vec2d& from, const Vec2d& to)
{
    const Vec2d along = to - from;
    const double length = along.squaredNorm();
    const double part = length > 0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
    return (point - from - part * along).norm();
}

[[noreturn]] void throwMask(const std::filesystem::path& file, std::string reason, std::string remedy)
{
    throw Error(ErrorCode::ProjectInvalid,
                {file, {}, {{"reason", std::move(reason)}, {"remedy", std::move(remedy)}}});
}

std::string sizeText(int width, int height)
{
    return std::to_string(width) + " × " + std::to_string(height);
}

void addMask(const std::filesystem::path& file, const UsedTexels& atlas, std::span<std::uint8_t> mask)
{
    const Image picture = readImage(file);
    if (picture.width != atlas.width || picture.height != atlas.height)
        throwMask(file,
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
        const double radius = stroke.radius * width;
        std::vector<Vec2d> points;
        for (std::size_t i = 0; i + 1 < stroke.points.size(); i += 2)
            points.emplace_back(stroke.points[i] * width, (1 - stroke.points[i + 1]) * height);
        for (std::size_t p = 0; p < points.size(); ++p) {
            const Vec2d& from = points[p > 0 ? p - 1 : 0];
            const Vec2d& to = points[p];
            const auto clampedFloor = [](double value, int size) {
                return static_cast<int>(std::floor(std::clamp(value, 0.0, static_cast<double>(size))));
            };
            const int right = std::min(clampedFloor(std::max(from.x(), to.x()) + radius, width) + 1, width);
            const int bottom =
                std::min(clampedFloor(std::max(from.y(), to.y()) + radius, height) + 1, height);
            for (int y = clampedFloor(std::min(from.y(), to.y()) - radius, height); y < bottom; ++y) {
                for (int x = clampedFloor(std::min(from.x(), to.x()) - radius, width); x < right; ++x) {
                    if (distanceToSegment({x + 0.5, y + 0.5}, from, to) <= radius)
                        mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(x)] = stroke.erases ? 0 : 1;
                }
            }
        }
    }
}

std::vector<std::uint8_t> knownTexels(const CompletionEntry& completion, const Image& texture,
                                      const UsedTexels& atlas, const std::filesystem::path& file,
                                      const std::filesystem::path& folder)
{
    if (texture.width != atlas.width || texture.height != atlas.height)
        throwMask(file,
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
