// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/film/h264.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/film/boxes.h"
#include "model/film/planes.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <wels/codec_api.h>

namespace quadrille {

namespace {

constexpr int smallestSide = 16;
/// Blocks of 16 × 16 pixels in a picture of level 5.2, the highest that OpenH264 writes: 4096 × 2304 pixels.
constexpr int blocksAtMost = 36864;

/// What a unit of the stream is.
enum class UnitType
{
    SequenceSet = 7,
    PictureSet = 8,
};

struct DestroyEncoder
{
    void operator()(ISVCEncoder* encoder) const
    {
        encoder->Uninitialize();
        WelsDestroySVCEncoder(encoder);
    }
};

[[noreturn]] void refuseSize(const std::filesystem::path& film, const char* reason, const char* remedy)
{
    throw Error(ErrorCode::BadArgument, {film, {}, {{"reason", reason}, {"remedy", remedy}}});
}

void checkSize(int width, int height, const std::filesystem::path& film)
{
    if (std::min(width, height) < smallestSide)
        refuseSize(film, QUADRILLE_MESSAGE("An MP4 film has at least 16 × 16 pixels"),
                   QUADRILLE_MESSAGE("Choose a larger size."));
    if ((width + 15) / 16 * ((height + 15) / 16) > blocksAtMost)
        refuseSize(film, QUADRILLE_MESSAGE("An MP4 film has at most as many pixels as 4096 × 2304"),
                   QUADRILLE_MESSAGE("Choose a smaller size, or write PNG pictures."));
    if (width % 2 != 0 || height % 2 != 0)
        refuseSize(film, QUADRILLE_MESSAGE("The sides of an MP4 film are even"),
                   QUADRILLE_MESSAGE("Choose even numbers of pixels."));
}

SEncParamExt parametersOf(const FilmFormat& format, ISVCEncoder& encoder, int quantizer)
{
    SEncParamExt parameters;
    encoder.GetDefaultParams(&parameters);
    // It codes alike at any rate; the level that it writes depends on it.
    const auto fps = static_cast<float>(std::clamp(format.fps, 1.0, 60.0));
    parameters.iUsageType = CAMERA_VIDEO_REAL_TIME;
    parameters.iPicWidth = format.width;
    parameters.iPicHeight = format.height;
    parameters.fMaxFrameRate = fps;
    parameters.iRCMode = RC_OFF_MODE;
    parameters.bEnableFrameSkip = false;
    parameters.uiIntraPeriod = static_cast<unsigned>(std::clamp(std::lround(2 * format.fps), 1L, 600L));
    parameters.iComplexityMode = HIGH_COMPLEXITY;
    parameters.iEntropyCodingModeFlag = 1;
    parameters.iMultipleThreadIdc = 1;
    parameters.eSpsPpsIdStrategy = CONSTANT_ID;
    // Key pictures come at their time alone, and no part of a picture is taken for unchanged that is not.
    parameters.bEnableSceneChangeDetect = false;
    parameters.bEnableBackgroundDetection = false;
    parameters.bEnableAdaptiveQuant = false;
    SSpatialLayerConfig& layer = parameters.sSpatialLayers[0];
    layer.uiProfileIdc = PRO_MAIN;
    layer.iVideoWidth = format.width;
    layer.iVideoHeight = format.height;
    layer.fFrameRate = fps;
    layer.iDLayerQp = quantizer;
    // Asked for, though nothing is done with it.
    parameters.iTargetBitrate = layer.iSpatialBitrate = 5'000'000;
    layer.bVideoSignalTypePresent = true;
    layer.uiVideoFormat = VF_UNDEF;
    layer.bFullRange = false;
    layer.bColorDescriptionPresent = true;
    layer.uiColorPrimaries = CP_BT709;
    layer.uiTransferCharacteristics = TRC_BT709;
    layer.uiColorMatrix = CM_BT709;
    return parameters;
}

} // namespace

struct H264Encoder::Parts
{
    std::filesystem::path film;
    double fps = 25;
    std::unique_ptr<ISVCEncoder, DestroyEncoder> encoder;
    std::string sequenceSet;
    std::string pictureSet;
    Planes planes;
    std::int64_t pictures = 0;

    [[noreturn]] void fail() const
    {
        throw Error(ErrorCode::WriteFailed,
                    {film, {}, {{"reason", QUADRILLE_MESSAGE("the encoder of H.264 gives up")}}});
    }

    /// The units of what the encoder has written, without the sets, which are kept aside.
    std::string unitsOf(const SFrameBSInfo& written)
    {
        FilmBytes bytes;
        for (int l = 0; l < written.iLayerNum; ++l) {
            const SLayerBSInfo& layer = written.sLayerInfo[l];
            const char* at = reinterpret_cast<const char*>(layer.pBsBuf);
            for (const int size :
                 std::span(layer.pNalLengthInByte, static_cast<std::size_t>(layer.iNalCount))) {
                constexpr int startCode = 4;
                if (size <= startCode)
                    fail();
                const std::string_view unit(at + startCode, static_cast<std::size_t>(size - startCode));
                at += size;
                const auto type = static_cast<UnitType>(static_cast<unsigned char>(unit[0]) & 31U);
                if (type == UnitType::SequenceSet)
                    sequenceSet = unit;
                else if (type == UnitType::PictureSet)
                    pictureSet = unit;
                else
                    bytes.add32(unit.size()).add(unit);
            }
        }
        return bytes.text();
    }
};

H264Encoder::H264Encoder(const FilmFormat& format, const std::filesystem::path& film, int quantizer)
    : m_parts(std::make_unique<Parts>())
{
    checkSize(format.width, format.height, film);
    m_parts->film = film;
    m_parts->fps = format.fps;
    ISVCEncoder* encoder = nullptr;
    if (WelsCreateSVCEncoder(&encoder) != 0 || encoder == nullptr)
        m_parts->fail();
    m_parts->encoder.reset(encoder);
    int silent = WELS_LOG_QUIET;
    encoder->SetOption(ENCODER_OPTION_TRACE_LEVEL, &silent);
    const SEncParamExt parameters = parametersOf(format, *encoder, quantizer);
    SFrameBSInfo sets{};
    if (encoder->InitializeExt(&parameters) != cmResultSuccess ||
        encoder->EncodeParameterSets(&sets) != cmResultSuccess)
        m_parts->fail();
    m_parts->unitsOf(sets);
    if (m_parts->sequenceSet.size() < 4 || m_parts->pictureSet.empty())
        m_parts->fail();
}

H264Encoder::~H264Encoder() = default;

const std::string& H264Encoder::sequenceSet() const
{
    return m_parts->sequenceSet;
}

const std::string& H264Encoder::pictureSet() const
{
    return m_parts->pictureSet;
}

CompressedPicture H264Encoder::encode(const Image& picture)
{
    Planes& planes = m_parts->planes;
    toPlanes(picture, planes);
    SSourcePicture source{};
    source.iColorFormat = videoFormatI420;
    source.iPicWidth = planes.width;
    source.iPicHeight = planes.height;
    source.iStride[0] = planes.width;
    source.iStride[1] = source.iStride[2] = planes.colorWidth;
    source.pData[0] = planes.luma.data();
    source.pData[1] = planes.blueness.data();
    source.pData[2] = planes.redness.data();
    source.uiTimeStamp = std::llround(1000 * static_cast<double>(m_parts->pictures++) / m_parts->fps);
    SFrameBSInfo written{};
    if (m_parts->encoder->EncodeFrame(&source, &written) != cmResultSuccess)
        m_parts->fail();
    CompressedPicture compressed{m_parts->unitsOf(written), written.eFrameType == videoFrameTypeIDR};
    if (compressed.bytes.empty())
        m_parts->fail();
    return compressed;
}

} // namespace quadrille
