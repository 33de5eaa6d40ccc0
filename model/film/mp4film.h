// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/audio/mp3.h"
#include "model/film/h264.h"
#include "model/film/mp4tables.h"

#include <optional>

namespace quadrille {

/// A film in MP4 (ISO/IEC 14496-12): pictures as H.264, sound as MP3, both of which every browser plays.
///
/// Its tables come before pictures and sound, which lie beside each other every half second, so that players
/// begin before they have all of it. The sound begins with the first picture and ends with the last.
class Mp4Film : public FilmWriter
{
public:
    /// \param place  where the film is written for now. \param film  names it in errors.
    /// \throws Error what H264Encoder and FilmFile throw.
    Mp4Film(const std::filesystem::path& place, const std::filesystem::path& film, const FilmFormat& format,
            std::optional<Mp3Stream> sound = {});

    void add(const Image& picture) override;
    void finish() override;

private:
    void reserveTables();
    void writeSoundUntil(double seconds);

    FilmFormat m_format;
    H264Encoder m_encoder;
    std::optional<Mp3Stream> m_sound;
    FilmFile m_file;
    std::int64_t m_chunkPictures = 1;
    std::vector<Mp4Track> m_tracks; ///< pictures, sound
    std::uint64_t m_tablesAt = 0;
    std::uint64_t m_tableBytes = 0;
};

} // namespace quadrille
