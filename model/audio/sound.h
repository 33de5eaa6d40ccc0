// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace quadrille {

/// A recorded sound.
struct Sound
{
    int rate = 48000; ///< sample frames per second
    int channels = 1;
    std::vector<float> samples; ///< sample frames × channels, −1 … 1

    std::int64_t frameCount() const { return static_cast<std::int64_t>(samples.size()) / channels; }
    double seconds() const { return static_cast<double>(frameCount()) / rate; }
};

/// Reads a WAV file, or another that libsndfile knows (FLAC, AIFF, Ogg, MP3).
/// \throws Error FileNotFound, PermissionDenied, ReadFailed, FileEmpty; FormatRefused where it is no sound;
/// Cancelled.
Sound readSound(const std::filesystem::path& file, const Progress& progress = {});

} // namespace quadrille
