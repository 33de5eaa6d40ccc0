// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/film/filmwriter.h"

#include <memory>
#include <string>

namespace quadrille {

/// One picture of a compressed film.
struct CompressedPicture
{
    std::string bytes;
    bool isKey = false; ///< can be shown without those before it
};

/// How coarsely H264Encoder writes where nothing else is asked for: 0 … 51; two steps less are a fifth more
/// bytes and half a decibel.
inline constexpr int usualQuantizer = 20;

/// Compresses pictures with H.264 (ISO/IEC 14496-10), main profile, by OpenH264: about 4 ms for 1280 × 720
/// pixels.
///
/// Every picture has the same quality, whatever it takes: PSNR 44 dB for the sample's films. One thread: with
/// several OpenH264 writes other bytes. Every two seconds a picture can be shown by itself, for seeking.
class H264Encoder
{
public:
    /// \param film  names it in errors. \param quantizer  0 … 51.
    /// \throws Error BadArgument where the size cannot be written: it must be even, of 16 × 16 pixels at
    /// least, and of 9.4 million at most; WriteFailed where the encoder cannot begin.
    H264Encoder(const FilmFormat& format, const std::filesystem::path& film, int quantizer = usualQuantizer);
    ~H264Encoder();
    H264Encoder(const H264Encoder&) = delete;
    H264Encoder& operator=(const H264Encoder&) = delete;

    /// What a decoder must know first: profile, size, colours; and how pictures are written.
    const std::string& sequenceSet() const;
    const std::string& pictureSet() const;
    /// \return its units, each behind its size in four bytes. \throws Error WriteFailed.
    CompressedPicture encode(const Image& picture);

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace quadrille
