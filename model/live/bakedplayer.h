// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/live/liveplayer.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// A picture as its file has it: PNG or JPEG.
using PictureBytes = std::vector<std::byte>;

/// A texture of a captured frame, and which one that is.
struct BakedFrame
{
    static constexpr std::int32_t noPicture = -1;

    std::string sequence;   ///< its name in the project
    std::int64_t frame = 0; ///< of the sequence
    bool isMirrored = false;
    std::int32_t picture = noPicture;

    bool operator==(const BakedFrame&) const = default;
};

/// All that a game needs to play motion spaces: what a LivePlayer plays, the captured frames that its
/// provenances mean, their textures, and a recording.
struct BakedPlayer
{
    std::shared_ptr<const LiveGraph> graph;
    LiveSettings settings;
    LiveStart start;
    std::vector<LiveInput> inputs; ///< of a recording, one for each tick; may be none
    std::int64_t from = 0;         ///< the tick of its first frame
    double metresPerUnit = 1;      ///< of the project that it was made from
    /// By space, then take, then frame of the space.
    std::vector<std::vector<std::vector<BakedFrame>>> frames;
    std::size_t pictureCount = 0;
    /// Reads one when it is asked for; safe from any thread. \throws Error as reading files.
    std::function<PictureBytes(std::size_t picture)> picture;

    const BakedFrame& frameOf(const LiveProvenance& provenance) const
    {
        return frames[provenance.space][provenance.take][provenance.frame];
    }
};

/// Writes one file, little-endian: “QUADPLAY”, the version, a hash of the data, the data, the pictures.
/// \pre All of it fits together, and so the frames and pictures. \throws Error WriteFailed, PermissionDenied,
/// Cancelled, and what reading pictures throws.
void writeBakedPlayer(const BakedPlayer& player, const std::filesystem::path& file,
                      const Progress& progress = {});

/// Reads such a file; pictures stay in it. What is played is the same as what was written, to the bit; takes
/// have no warps: frames say what they are.
/// \throws Error FileNotFound, PermissionDenied, ReadFailed, FileEmpty, FileTruncated, FileSyntax (not such a
/// file, another version, damaged).
BakedPlayer readBakedPlayer(const std::filesystem::path& file);

} // namespace quadrille
