// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/audio/sound.h"

#include <string>

namespace quadrille {

/// A sound as MPEG layer III, frame by frame, each of which can be decoded by itself and the one before it.
///
/// A decoder gives every sample at its time, as if there were no delay: players take out none, or the same
/// twice. For this the sound fades in over the first hundredth of a second.
struct Mp3Stream
{
    int rate = 48000;
    int channels = 1;
    int samplesPerFrame = 1152;
    int bitsPerSecond = 0;
    std::int64_t length = 0; ///< sample frames of the sound; the last frame is filled up with silence
    std::vector<std::string> frames;
};

/// Compresses a sound of one channel or two at a constant rate; one whose rate the format does not know is
/// resampled. \throws Error WriteFailed, Cancelled.
Mp3Stream encodeMp3(const Sound& sound, const Progress& progress = {});

} // namespace quadrille
