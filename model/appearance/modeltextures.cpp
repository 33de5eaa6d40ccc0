// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/modeltextures.h"

#include "model/appearance/decodekernels.h"

#include <array>

namespace quadrille {

struct ModelTextures::Opened
{
    explicit Opened(FrameAppearances known) : appearances(std::move(known)), decoder(appearances.model) {}

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

    /// A picture, with scratch that other pictures have used before. \param make  (DecodeScratch&) → Image
    template <typename Make>
    Image make(const Make& make) const
    {
        std::unique_ptr<DecodeScratch> scratch = takeScratch();
        Image picture = make(*scratch);
        const std::scoped_lock lock(m_mutex);
        m_scratch.push_back(std::move(scratch));
        return picture;
    }

    FrameAppearances appearances;
    AppearanceDecoder decoder;

private:
    std::unique_ptr<DecodeScratch> takeScratch() const
    {
        const std::scoped_lock lock(m_mutex);
        if (m_scratch.empty())
            return std::make_unique<DecodeScratch>();
        std::unique_ptr<DecodeScratch> scratch = std::move(m_scratch.back());
        m_scratch.pop_back();
        return scratch;
    }

    mutable std::mutex m_mutex;
    mutable std::vector<std::unique_ptr<DecodeScratch>> m_scratch; ///< as many as pictures were made at once
};

Image mixedTexture(const Image& first, const Image& second, double weight)
{
    Image mixed(first.width, first.height);
    mixBytes(first.pixels.data(), second.pixels.data(), static_cast<float>(weight), std::ssize(mixed.pixels),
             mixed.pixels.data());
    return mixed;
}

Image blendedTexture(const AppearanceDecoder& decoder, const AppearanceCoefficients& first,
                     const Image& firstTexture, const AppearanceCoefficients& second,
                     const Image& secondTexture, double weight, DecodeScratch& scratch)
{
    const AppearanceModel& model = decoder.model();
    Image blended = mixedTexture(firstTexture, secondTexture, weight);
    if (model.warps.count == 0 || weight <= 0 || weight >= 1)
        return blended;
    combine(model.warps, interpolated(first, second, weight).warps, scratch.blendWarp);
    const std::array own{&first, &second};
    for (std::size_t i = 0; i < own.size(); ++i) {
        combine(model.warps, own[i]->warps, scratch.ownWarp);
        setWarpBetween(scratch.ownWarp, scratch.blendWarp, model.grid, decoder.nodes(), scratch.moves[i]);
    }
    decoder.mix({firstTexture, scratch.moves[0]}, {secondTexture, scratch.moves[1]},
                static_cast<float>(weight), scratch, blended);
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
        return known->make([&](DecodeScratch& scratch) {
            return blendedTexture(known->decoder, *atFirst, *firstPicture, *atSecond, *secondPicture, weight,
                                  scratch);
        });
    }};
}

Texture ModelTextures::ofPose(const std::shared_ptr<const FrameSource>& poses, FrameIndex frame, double share,
                              const Texture& captured) const
{
    const auto known = opened();
    if (!known || !known->appearances.poses || !known->appearances.poses->fits(poses->vertexCount()))
        return {};
    return {.made = [known, poses, frame, share, captured] {
        std::vector<Vec3f> pose(poses->vertexCount());
        poses->read(frame, pose);
        Image own = known->make([&](DecodeScratch& scratch) {
            Image decoded;
            known->decoder.decode(known->appearances.poses->at(pose), scratch, decoded);
            return decoded;
        });
        if (share >= 1 || captured.isEmpty())
            return own;
        const auto other = captured.load();
        return known->fits(*other) ? mixedTexture(*other, own, share) : own;
    }};
}

} // namespace quadrille
