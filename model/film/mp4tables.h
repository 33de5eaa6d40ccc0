// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/film/filmwriter.h"

#include <string>
#include <vector>

namespace quadrille {

struct Mp3Stream;

/// A track of an MP4 film: how to decode its samples, and where they are. Samples lie together in chunks.
struct Mp4Track
{
    std::string description; ///< the box that says how samples are coded
    std::uint32_t units = 1; ///< of time in a second
    std::uint32_t unitsPerSample = 1;
    int width = 0; ///< pixels; 0 for sound
    int height = 0;
    std::vector<std::uint32_t> sizes; ///< of the samples, bytes
    /// Numbers, from 1, of the samples that need none before them; all where empty.
    std::vector<std::uint32_t> keys;
    std::vector<std::uint64_t> chunks; ///< where they begin in the file
    std::vector<std::uint32_t> samplesPerChunk;
};

/// How samples of H.264 are coded (ISO/IEC 14496-15: “avc1”), with the colours of `Planes`.
std::string descriptionOfH264(int width, int height, const std::string& sequenceSet,
                              const std::string& pictureSet);
/// How samples of MPEG layer III are coded (ISO/IEC 14496-14: “mp4a”).
std::string descriptionOfMp3(const Mp3Stream& sound);

/// The box “moov” of a film that is as long as its first track; times are in that track's units. Its size
/// depends on how many samples, keys and chunks there are, and on how chunks differ, alone.
std::string movieBox(const std::vector<Mp4Track>& tracks);

} // namespace quadrille
