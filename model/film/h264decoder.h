// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/film/h264.h"

namespace quadrille {

/// Gives back the pictures of an H264Encoder, as players show them.
class H264Decoder
{
public:
    /// \throws Error ReadFailed where the decoder cannot begin.
    explicit H264Decoder(const H264Encoder& encoder);
    ~H264Decoder();
    H264Decoder(const H264Decoder&) = delete;
    H264Decoder& operator=(const H264Decoder&) = delete;

    /// \pre Pictures come in the order in which they were compressed. \throws Error ReadFailed.
    Image decode(const CompressedPicture& picture);

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace quadrille
