// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/audio/sound.h"

namespace quadrille {

/// A sound that belongs to a clip.
struct SoundTrack
{
    std::filesystem::path file;
    /// When it begins, seconds from the clip's first frame; below zero: its beginning is not heard.
    double offset = 0;
    double gain = 0; ///< decibels

    bool operator==(const SoundTrack&) const = default;
};

/// The sound of a clip: as long as it, silent before and after the track, with one channel or two, never
/// louder than full scale. Further channels are mixed, every second one to either side.
Sound soundOfClip(const Sound& sound, const SoundTrack& track, double seconds);

} // namespace quadrille
