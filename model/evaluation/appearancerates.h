// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/appearancemodel.h"
#include "model/evaluation/appearanceerrors.h"

#include <optional>
#include <string>

namespace quadrille {

/// What a way to store all textures takes and loses.
struct AppearanceRate
{
    std::string kind;         ///< "model", "jpeg" or "h264"
    std::int64_t setting = 0; ///< components, quality, quantizer
    std::uint64_t bytes = 0;  ///< of all textures together
    PictureQuality quality;   ///< over covered texels, mean over textures
};

/// Files of models with some numbers of components. \param frames  of the textures.
/// \param alignment,textureShare  see appearanceCompactness.
/// \throws Error Cancelled, WriteFailed (scratch), and what reading textures throws.
std::vector<AppearanceRate> modelRates(const AppearanceSubject& subject, TextureAlignment* alignment,
                                       const std::vector<AppearanceFrame>& frames,
                                       std::span<const std::int64_t> components, double textureShare,
                                       const Progress& progress = {},
                                       const Executor& executor = localExecutor());

/// Series of JPEG pictures. \throws Error Cancelled, and what reading textures throws.
std::vector<AppearanceRate> jpegRates(const AppearanceSubject& subject, std::span<const int> qualities,
                                      const Progress& progress = {},
                                      const Executor& executor = localExecutor());

/// Films of the textures in their order, by H264Encoder, without the boxes of a file around them. None where
/// H.264 cannot hold pictures of their size.
/// \throws Error Cancelled, and what reading textures throws.
std::vector<AppearanceRate> filmRates(const AppearanceSubject& subject, std::span<const int> quantizers,
                                      const Progress& progress = {});

/// How many bytes a kind takes for an SSIM: between settings as the logarithm of bytes runs, those of the
/// worst setting where it is better than that; none where no setting is as good.
std::optional<double> bytesAt(std::span<const AppearanceRate> rates, const std::string& kind,
                              double similarity);

} // namespace quadrille
