// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/film/h264decoder.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/film/planes.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <wels/codec_api.h>

namespace quadrille {

namespace {

constexpr std::string_view startCode("\0\0\0\1", 4);

struct DestroyDecoder
{
    void operator()(ISVCDecoder* decoder) const
    {
        decoder->Uninitialize();
        WelsDestroyDecoder(decoder);
    }
};

[[noreturn]] void failDecoding()
{
    throw Error(ErrorCode::ReadFailed,
                {{}, {}, {{"reason", QUADRILLE_MESSAGE("the decoder of H.264 gives up")}}});
}

/// Units behind their sizes, as a stream of bytes.
std::string streamOf(std::string_view units)
{
    std::string stream;
    while (units.size() > 4) {
        std::size_t size = 0;
        for (const char byte : units.substr(0, 4))
            size = size << 8U | static_cast<unsigned char>(byte);
        stream.append(startCode).append(units.substr(4, size));
        units.remove_prefix(std::min(units.size(), 4 + size));
    }
    return stream;
}

void copyRows(const unsigned char* from, int stride, int width, int height, std::vector<std::uint8_t>& to)
{
    to.clear();
    for (int y = 0; y < height; ++y, from += stride)
        to.insert(to.end(), from, from + width);
}

} // namespace

struct H264Decoder::Parts
{
    std::unique_ptr<ISVCDecoder, DestroyDecoder> decoder;
    std::string sets; ///< go before the first picture
};

H264Decoder::H264Decoder(const H264Encoder& encoder) : m_parts(std::make_unique<Parts>())
{
    ISVCDecoder* decoder = nullptr;
    if (WelsCreateDecoder(&decoder) != 0 || decoder == nullptr)
        failDecoding();
    m_parts->decoder.reset(decoder);
    int silent = WELS_LOG_QUIET;
    decoder->SetOption(DECODER_OPTION_TRACE_LEVEL, &silent);
    const SDecodingParam parameters{};
    if (decoder->Initialize(&parameters) != 0)
        failDecoding();
    for (const std::string& set : {encoder.sequenceSet(), encoder.pictureSet()})
        m_parts->sets.append(startCode).append(set);
}

H264Decoder::~H264Decoder() = default;

Image H264Decoder::decode(const CompressedPicture& picture)
{
    const std::string stream = std::exchange(m_parts->sets, {}) + streamOf(picture.bytes);
    std::array<unsigned char*, 3> data{};
    SBufferInfo info{};
    const auto* bytes = reinterpret_cast<const unsigned char*>(stream.data());
    m_parts->decoder->DecodeFrameNoDelay(bytes, static_cast<int>(stream.size()), data.data(), &info);
    if (info.iBufferStatus != 1) // it waits for more, though none comes in between
        m_parts->decoder->FlushFrame(data.data(), &info);
    if (info.iBufferStatus != 1)
        failDecoding();
    const SSysMEMBuffer& buffer = info.UsrData.sSystemBuffer;
    Planes planes{.width = buffer.iWidth,
                  .height = buffer.iHeight,
                  .colorWidth = (buffer.iWidth + 1) / 2,
                  .colorHeight = (buffer.iHeight + 1) / 2};
    copyRows(data[0], buffer.iStride[0], planes.width, planes.height, planes.luma);
    copyRows(data[1], buffer.iStride[1], planes.colorWidth, planes.colorHeight, planes.blueness);
    copyRows(data[2], buffer.iStride[1], planes.colorWidth, planes.colorHeight, planes.redness);
    return fromPlanes(planes);
}

} // namespace quadrille
