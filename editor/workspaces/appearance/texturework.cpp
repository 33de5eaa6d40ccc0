// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/texturework.h"

#include "editor/pictures/pictures.h"
#include "editor/workspaces/appearance/componentpictures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

constexpr int greyLevels = 256;
constexpr double nearlyAll = 0.99; ///< of the texels, whose differences the colours tell apart
constexpr double leastRange = 8;   // grey levels

bool isOfSize(const Image& image, const UsedTexels& texels)
{
    return image.width == texels.width && image.height == texels.height;
}

/// Mean difference of R, G and B.
double differenceAt(const Image& first, const Image& second, std::size_t texel)
{
    int sum = 0;
    for (std::size_t channel = 0; channel < 3; ++channel)
        sum += second.pixels[4 * texel + channel] - first.pixels[4 * texel + channel];
    return sum / 3.0;
}

double rangeOf(const std::array<std::int64_t, greyLevels>& histogram)
{
    std::int64_t count = 0;
    for (const std::int64_t each : histogram)
        count += each;
    std::int64_t below = 0;
    int level = 0;
    while (level < greyLevels - 1 &&
           static_cast<double>(below + histogram.at(static_cast<std::size_t>(level))) <
               nearlyAll * static_cast<double>(count))
        below += histogram.at(static_cast<std::size_t>(level++));
    double range = leastRange;
    while (range < level)
        range *= 2;
    return range;
}

} // namespace

QImage differencePicture(const Image& first, const Image& second, const UsedTexels& texels, bool isSigned,
                         widgets::ScalarRange& range)
{
    std::array<std::int64_t, greyLevels> histogram{};
    for (std::size_t i = 0; i < texels.texels.size(); ++i) {
        if (texels.covered[i] != 0)
            ++histogram.at(static_cast<std::size_t>(
                std::lround(std::abs(differenceAt(first, second, texels.texels[i])))));
    }
    range.maximum = rangeOf(histogram);
    range.minimum = isSigned ? -range.maximum : 0;
    range.map = isSigned ? widgets::ColorMap::Signed : widgets::ColorMap::Sequential;
    // Each colour once, rather than for each texel.
    std::vector<QRgb> colors;
    for (int level = -greyLevels; level <= greyLevels; ++level)
        colors.push_back(range.color(isSigned ? level : std::abs(level)).rgb());
    QImage picture(first.width, first.height, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    for (std::size_t i = 0; i < texels.texels.size(); ++i) {
        if (texels.covered[i] == 0)
            continue;
        const auto texel = static_cast<int>(texels.texels[i]);
        const auto level = std::lround(differenceAt(first, second, texels.texels[i]));
        auto* row = reinterpret_cast<QRgb*>(picture.scanLine(texel / first.width));
        row[texel % first.width] = colors[static_cast<std::size_t>(level + greyLevels)];
    }
    return picture;
}

std::shared_ptr<const Image> firstTexture(const TextureRequest& request)
{
    if (request.content == TextureContent::Component)
        return std::make_shared<const Image>(request.opened->decoder->decode(request.first));
    if (request.captured.isEmpty())
        return nullptr;
    auto captured = request.captured.load();
    if (request.content != TextureContent::Between || request.other.isEmpty())
        return captured;
    const auto other = request.other.load();
    if (captured->pixels.size() != other->pixels.size())
        return captured;
    return std::make_shared<const Image>(mixedTexture(*captured, *other, request.weight));
}

std::shared_ptr<const Image> secondTexture(const TextureRequest& request)
{
    if (request.opened == nullptr)
        return nullptr;
    const AppearanceDecoder& decoder = *request.opened->decoder;
    switch (request.content) {
    case TextureContent::Frame:
        if (request.second.textures.empty() && request.second.warps.empty() && request.captured.isEmpty())
            return nullptr;
        return std::make_shared<const Image>(decoder.decode(request.second));
    case TextureContent::Component:
        return std::make_shared<const Image>(decoder.decode(request.second));
    case TextureContent::Completed:
        return request.other.isEmpty() ? nullptr : request.other.load();
    case TextureContent::Between:
        break;
    }
    if (request.captured.isEmpty() || request.other.isEmpty())
        return nullptr;
    const auto captured = request.captured.load();
    const auto other = request.other.load();
    const UsedTexels& texels = decoder.model().texels;
    if (!isOfSize(*captured, texels) || !isOfSize(*other, texels))
        return nullptr;
    DecodeScratch scratch;
    return std::make_shared<const Image>(
        blendedTexture(decoder, request.first, *captured, request.second, *other, request.weight, scratch));
}

ShownPair makePair(const TextureRequest& request, const Progress& progress)
{
    ShownPair pair;
    const auto first = firstTexture(request);
    progress.report(0.2);
    const auto second = secondTexture(request);
    progress.report(0.5);
    if (first != nullptr)
        pair.first = widgets::prepareTexture(toQImage(first));
    if (second == nullptr)
        return pair;
    pair.second = widgets::prepareTexture(toQImage(second));
    if (request.content == TextureContent::Component) {
        constexpr int texelsOfArrow = 32;
        const AppearanceDecoder& decoder = *request.opened->decoder;
        const int arrows = decoder.model().texels.width / texelsOfArrow;
        pair.difference =
            widgets::prepareTexture(request.isWarp ? eigenWarpPicture(decoder, request.component, arrows)
                                                   : eigenTexturePicture(decoder.model(), request.component));
        return pair;
    }
    const UsedTexels& texels = request.opened->decoder->model().texels;
    if (first == nullptr || !isOfSize(*first, texels) || !isOfSize(*second, texels))
        return pair;
    progress.report(0.8);
    pair.quality = textureQuality(*first, *second, texels);
    pair.difference =
        widgets::prepareTexture(differencePicture(*first, *second, texels, request.isSigned, pair.range));
    return pair;
}

} // namespace quadrille
