// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/modeltextures.h"

#include "model/appearance/decodekernels.h"

namespace quadrille {

struct ModelTextures::Opened
{
    explicit Opened(FrameAppearances known)
        : appearances(std::move(known)), decoder(appearances.model), charts(appearances.model->texels)
    {
    }

    const AppearanceCoefficients* find(const CapturedTexture& texture) const
    {
        const auto found = appearances.coefficients.find({texture.sequence, texture.frame});
        return found == appearances.coefficients.end() ? nullptr : &found->second;
    }
    Texture completed(const CapturedTexture& texture) const
    {
        const auto found = appearances.completed.find({texture.sequence, texture.frame});
        return found == appearances.completed.end() ? Texture() : found->second;
    }
    bool fits(const Image& texture) const
    {
        return texture.width == appearances.model->texels.width &&
               texture.height == appearances.model->texels.height;
    }

    FrameAppearances appearances;
    AppearanceDecoder decoder;
    ChartLookup charts;
};

Image blendedTexture(const AppearanceDecoder& decoder, const ChartLookup& charts,
                     const AppearanceCoefficients& first, const Image& firstTexture,
                     const AppearanceCoefficients& second, const Image& secondTexture, double weight)
{
    const AppearanceModel& model = decoder.model();
    const auto ofSecond = static_cast<float>(weight);
    Image blended = firstTexture;
    mixBytes(firstTexture.pixels.data(), secondTexture.pixels.data(), ofSecond, std::ssize(blended.pixels),
             blended.pixels.data());
    if (model.warps.count == 0 || weight <= 0 || weight >= 1)
        return blended;
    const std::vector<float> wanted = combined(model.warps, interpolated(first, second, weight).warps);
    const auto warpFrom = [&](const AppearanceCoefficients& from) {
        return warpBetween(combined(model.warps, from.warps), wanted, model.grid);
    };
    const std::array colours{charts.colours(firstTexture), charts.colours(secondTexture)};
    const std::array warps{warpFrom(first), warpFrom(second)};
    decoder.mixDealigned({colours[0], warps[0]}, {colours[1], warps[1]}, ofSecond, blended);
    return blended;
}

ModelTextures::ModelTextures(std::function<std::optional<FrameAppearances>()> open) : m_open(std::move(open))
{
}

std::shared_ptr<const ModelTextures::Opened> ModelTextures::opened() const
{
    const std::scoped_lock lock(m_mutex);
    if (!m_opened) {
        if (auto appearances = m_open())
            m_opened = std::make_shared<const Opened>(std::move(*appearances));
    }
    return m_opened;
}

Texture ModelTextures::inPlaceOf(const CapturedTexture& texture) const
{
    const auto known = opened();
    return known ? known->completed(texture) : Texture();
}

Texture ModelTextures::between(const CapturedTexture& first, const CapturedTexture& second,
                               double weight) const
{
    const auto known = opened();
    const AppearanceCoefficients* atFirst = known ? known->find(first) : nullptr;
    const AppearanceCoefficients* atSecond = known ? known->find(second) : nullptr;
    if (!atFirst || !atSecond)
        return {};
    const auto pictureOf = [&](const CapturedTexture& captured) {
        Texture completed = known->completed(captured);
        return completed.isEmpty() ? captured.texture : completed;
    };
    return {.made = [known, atFirst, atSecond, firstTexture = pictureOf(first),
                     secondTexture = pictureOf(second), weight] {
        const auto firstPicture = firstTexture.load();
        const auto secondPicture = secondTexture.load();
        if (!known->fits(*firstPicture) || !known->fits(*secondPicture)) // files that changed meanwhile
            return weight < 0.5 ? *firstPicture : *secondPicture;
        return blendedTexture(known->decoder, known->charts, *atFirst, *firstPicture, *atSecond,
                              *secondPicture, weight);
    }};
}

} // namespace quadrille
