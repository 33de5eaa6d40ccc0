// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/decode.h"
#include "model/appearance/poseappearance.h"
#include "model/sequence/texture.h"

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace quadrille {

/// A model of appearance, and what it knows of captured frames.
struct FrameAppearances
{
    using Key = std::pair<std::string, FrameIndex>; ///< sequence and frame of it

    std::shared_ptr<const AppearanceModel> model;
    std::map<Key, AppearanceCoefficients> coefficients; ///< of the textures that it knows
    std::map<Key, Texture> completed;                   ///< shown in place of those that were captured
    /// Of poses that were not captured; null: they have those of captured frames.
    std::shared_ptr<const PoseAppearance> poses = nullptr;
};

/// Both textures as they are, each shining through the other. \param weight  of the second, 0 … 1. \pre They
/// have one size.
Image mixedTexture(const Image& first, const Image& second, double weight);

/// The texture between two whose coefficients are known: both moved to where a texture with the warp in
/// between lies, and mixed. That is what SMCAS §5.3 does, with all Eigen textures in place of the first k, so
/// that nothing of what was captured is lost. Towards the ends it becomes the captured textures
/// themselves. Texels that no triangle covers are mixed where they are.
/// \param weight  of the second, 0 … 1. \pre Both pictures have the
/// atlas's size. Cost: that of two to three decodes (bench_appearancemodel).
Image blendedTexture(const AppearanceDecoder& decoder, const AppearanceCoefficients& first,
                     const Image& firstTexture, const AppearanceCoefficients& second,
                     const Image& secondTexture, double weight, DecodeScratch& scratch);

/// Textures of clips by a model of appearance. Where a picture has not the size of the model's atlas, since
/// its file has changed, the texture in between is that of the nearer frame.
class ModelTextures : public TextureBlender
{
public:
    /// \param open  called when a texture is asked for, until it gives a model; nothing: there is none yet,
    /// and no texture is known.
    explicit ModelTextures(std::function<std::optional<FrameAppearances>()> open);

    Texture between(const CapturedTexture& first, const CapturedTexture& second,
                    double weight) const override;
    Texture inPlaceOf(const CapturedTexture& texture) const override;
    Texture ofPose(const std::shared_ptr<const FrameSource>& poses, FrameIndex frame, double share,
                   const Texture& captured) const override;

private:
    struct Opened;

    /// Null where there is no model yet.
    std::shared_ptr<const Opened> opened() const;

    std::function<std::optional<FrameAppearances>()> m_open;
    mutable std::mutex m_mutex;
    mutable std::shared_ptr<const Opened> m_opened;
};

} // namespace quadrille
