// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/film/avifilm.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/film/boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// A chunk of RIFF: its type, its size, what is in it.
std::string chunkOf(std::string_view type, std::string_view content)
{
    return FilmBytes().add(type).addLittle(content.size(), 4).add(content).text();
}

constexpr std::string_view pictureChunk = "00dc";
constexpr int jpegQuality = 90; ///< PSNR 44 to 45 dB for the sample's films

} // namespace

AviFilm::AviFilm(const std::filesystem::path& place, const std::filesystem::path& film,
                 const FilmFormat& format, std::uint64_t largest)
    : m_format(format), m_file(place, film), m_largestFile(largest)
{
    m_file.write(head());
}

/// All before the first picture. Written twice, as it says what is known in the end alone.
std::string AviFilm::head() const
{
    const FrameRate rate = frameRateOf(m_format.fps);
    const auto width = static_cast<std::uint64_t>(m_format.width);
    const auto height = static_cast<std::uint64_t>(m_format.height);
    constexpr std::uint64_t hasIndex = 0x10;
    const auto film = FilmBytes()
                          .addLittle(static_cast<std::uint64_t>(std::llround(1e6 / m_format.fps)), 4)
                          .zeros(8)
                          .addLittle(hasIndex, 4)
                          .addLittle(m_sizes.size(), 4)
                          .zeros(4)
                          .addLittle(1, 4) // streams
                          .addLittle(m_largestPicture, 4)
                          .addLittle(width, 4)
                          .addLittle(height, 4)
                          .zeros(16);
    const auto stream = FilmBytes()
                            .add("vidsMJPG")
                            .zeros(12)
                            .addLittle(rate.unitsPerFrame, 4)
                            .addLittle(rate.units, 4)
                            .zeros(4)
                            .addLittle(m_sizes.size(), 4)
                            .addLittle(m_largestPicture, 4)
                            .addLittle(std::numeric_limits<std::uint32_t>::max(), 4) // quality: the usual
                            .zeros(8)
                            .addLittle(width, 2)
                            .addLittle(height, 2);
    const auto picture = FilmBytes()
                             .addLittle(40, 4)
                             .addLittle(width, 4)
                             .addLittle(height, 4)
                             .addLittle(1, 2)
                             .addLittle(24, 2) // bits a pixel
                             .add("MJPG")
                             .addLittle(width * height * 3, 4)
                             .zeros(16);
    const std::string streams =
        chunkOf("LIST", "strl" + chunkOf("strh", stream.text()) + chunkOf("strf", picture.text()));
    const std::string heads = chunkOf("LIST", "hdrl" + chunkOf("avih", film.text()) + streams);
    const std::uint64_t pictures = 4 + m_pictureBytes;
    const std::uint64_t index = 8 + 16 * m_sizes.size();
    return FilmBytes()
        .add("RIFF")
        .addLittle(4 + heads.size() + 8 + pictures + index, 4)
        .add("AVI ")
        .add(heads)
        .add("LIST")
        .addLittle(pictures, 4)
        .add("movi")
        .text();
}

void AviFilm::add(const Image& picture)
{
    const std::vector<std::byte> jpeg = encodeImage(picture, ".jpg", jpegQuality);
    FilmBytes bytes;
    bytes.add(chunkOf(pictureChunk, {reinterpret_cast<const char*>(jpeg.data()), jpeg.size()}));
    bytes.zeros(jpeg.size() % 2);
    const std::uint64_t indexBytes = 16 * (m_sizes.size() + 1) + 8;
    if (m_file.size() + bytes.text().size() + indexBytes > m_largestFile) {
        throw Error(ErrorCode::BadArgument,
                    {m_file.film(),
                     {},
                     {{"reason", QUADRILLE_MESSAGE("An AVI film cannot be larger than 4 GB")},
                      {"remedy", QUADRILLE_MESSAGE("Write MP4, or fewer frames.")}}});
    }
    m_file.write(bytes.text());
    m_pictureBytes += bytes.text().size();
    m_sizes.push_back(static_cast<std::uint32_t>(jpeg.size()));
    m_largestPicture = std::max(m_largestPicture, m_sizes.back());
}

void AviFilm::finish()
{
    FilmBytes index;
    std::uint64_t at = 4; // behind “movi”
    for (const std::uint32_t size : m_sizes) {
        constexpr std::uint64_t isKey = 0x10;
        index.add(pictureChunk).addLittle(isKey, 4).addLittle(at, 4).addLittle(size, 4);
        at += 8 + size + size % 2;
    }
    m_file.write(chunkOf("idx1", index.text()));
    m_file.overwrite(0, head());
    m_file.close();
}

} // namespace quadrille
