// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/audio/mp3.h"

#include "model/core/error.h"
#include "model/core/message.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <lame/lame.h>
#include <memory>

namespace quadrille {

namespace {

/// Of every decoder, sample frames.
constexpr int decoderDelay = 529;

[[noreturn]] void fail()
{
    throw Error(ErrorCode::WriteFailed,
                {{}, {}, {{"reason", QUADRILLE_MESSAGE("the sound cannot be encoded")}}});
}

/// The nearest rate of MPEG-1; all players know them.
int rateFor(int rate)
{
    constexpr std::array<int, 3> rates{32000, 44100, 48000};
    return *std::min_element(rates.begin(), rates.end(),
                             [rate](int a, int b) { return std::abs(a - rate) < std::abs(b - rate); });
}

/// Bytes of the frame that begins with four bytes; 0 where none does.
std::size_t frameSize(std::string_view bytes)
{
    constexpr std::array<int, 15> kilobits{0, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320};
    constexpr std::array<int, 3> rates{44100, 48000, 32000};
    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned>(static_cast<unsigned char>(bytes[i]));
    };
    // Synchronisation, MPEG-1, layer III.
    if (bytes.size() < 4 || byte(0) != 0xFF || (byte(1) & 0xFEU) != 0xFA)
        return 0;
    const unsigned bitrate = byte(2) >> 4U;
    const unsigned rate = (byte(2) >> 2U) & 3U;
    if (bitrate == 0 || bitrate == 15 || rate == 3)
        return 0;
    return static_cast<std::size_t>(144 * kilobits[bitrate] * 1000 / rates[rate]) + ((byte(2) >> 1U) & 1U);
}

} // namespace

Mp3Stream encodeMp3(const Sound& sound, const Progress& progress)
{
    constexpr std::int64_t atOnce = std::int64_t{1152} * 64;
    assert(sound.channels == 1 || sound.channels == 2);
    const std::unique_ptr<lame_global_flags, int (*)(lame_global_flags*)> lame(lame_init(), &lame_close);
    if (!lame)
        fail();
    Mp3Stream stream{.rate = rateFor(sound.rate), .channels = sound.channels};
    stream.bitsPerSecond = sound.channels == 1 ? 128000 : 192000;
    lame_set_in_samplerate(lame.get(), sound.rate);
    lame_set_out_samplerate(lame.get(), stream.rate);
    lame_set_num_channels(lame.get(), sound.channels);
    lame_set_mode(lame.get(), sound.channels == 1 ? MONO : JOINT_STEREO);
    lame_set_brate(lame.get(), stream.bitsPerSecond / 1000);
    lame_set_bWriteVbrTag(lame.get(), 0);
    lame_set_disable_reservoir(lame.get(), 1); // frames stand alone where a player begins in the middle
    lame_set_errorf(lame.get(), [](const char*, va_list) {});
    lame_set_msgf(lame.get(), [](const char*, va_list) {});
    lame_set_debugf(lame.get(), [](const char*, va_list) {});
    if (lame_init_params(lame.get()) < 0)
        fail();
    stream.length = std::llround(sound.seconds() * stream.rate);

    std::string bytes;
    std::vector<unsigned char> out(static_cast<std::size_t>(atOnce * 5 / 4 + 7200) * 4);
    const auto capacity = static_cast<int>(out.size());
    const auto take = [&](int written) {
        if (written < 0)
            fail();
        bytes.append(reinterpret_cast<const char*>(out.data()), static_cast<std::size_t>(written));
    };
    const auto encode = [&](const float* samples, std::int64_t frames) {
        const auto count = static_cast<int>(frames);
        take(sound.channels == 1
                 ? lame_encode_buffer_ieee_float(lame.get(), samples, samples, count, out.data(), capacity)
                 : lame_encode_buffer_interleaved_ieee_float(lame.get(), samples, count, out.data(),
                                                             capacity));
    };
    // Behind this silence all comes out of a decoder one whole frame late, and the first frame is left out.
    const int late = stream.samplesPerFrame - lame_get_encoder_delay(lame.get()) - decoderDelay;
    const std::int64_t silence =
        std::llround(static_cast<double>(std::max(late, 0)) * sound.rate / stream.rate);
    encode(std::vector<float>(static_cast<std::size_t>(silence * sound.channels)).data(), silence);
    for (std::int64_t at = 0; at < sound.frameCount(); at += atOnce) {
        progress.report(at, sound.frameCount());
        encode(sound.samples.data() + at * sound.channels, std::min(atOnce, sound.frameCount() - at));
    }
    take(lame_encode_flush(lame.get(), out.data(), capacity));
    const auto count =
        static_cast<std::size_t>((stream.length + stream.samplesPerFrame - 1) / stream.samplesPerFrame);
    std::size_t at = frameSize(bytes);
    while (stream.frames.size() < count) {
        const std::size_t size = at < bytes.size() ? frameSize(std::string_view(bytes).substr(at)) : 0;
        if (size == 0 || at + size > bytes.size())
            fail();
        stream.frames.push_back(bytes.substr(at, size));
        at += size;
    }
    return stream;
}

} // namespace quadrille
