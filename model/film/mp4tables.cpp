// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/film/mp4tables.h"

#include "model/audio/mp3.h"
#include "model/film/boxes.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr std::uint64_t one = 0x10000; ///< 1 as 16.16
constexpr std::uint64_t undeterminedLanguage = 0x55C4;

FilmBytes& addIdentity(FilmBytes& bytes)
{
    return bytes.add32(one).zeros(12).add32(one).zeros(12).add32(0x40000000);
}

std::uint64_t durationOf(const Mp4Track& track)
{
    return std::uint64_t{track.unitsPerSample} * track.sizes.size();
}

std::string movieHeader(const Mp4Track& first, std::size_t trackCount)
{
    FilmBytes bytes;
    bytes.zeros(16).add32(first.units).add64(durationOf(first)).add32(one).add16(0x100).zeros(10);
    addIdentity(bytes).zeros(24).add32(trackCount + 1);
    return fullBox("mvhd", 1, 0, bytes.text());
}

std::string trackHeader(const Mp4Track& track, std::uint64_t number, std::uint64_t shown)
{
    const bool isSound = track.width == 0;
    FilmBytes bytes;
    bytes.zeros(16).add32(number).zeros(4).add64(shown).zeros(10);
    bytes
        .add16(isSound ? 1 : 0) // tracks of which one is chosen
        .add16(isSound ? 0x100 : 0)
        .zeros(2);
    addIdentity(bytes);
    bytes.add32(static_cast<std::uint64_t>(track.width) << 16U)
        .add32(static_cast<std::uint64_t>(track.height) << 16U);
    constexpr std::uint32_t enabledInMovie = 3;
    return fullBox("tkhd", 1, enabledInMovie, bytes.text());
}

/// What of a track is shown: as much as the film is long.
std::string editBox(std::uint64_t shown)
{
    const auto edit = FilmBytes().add32(1).add64(shown).add64(0).add32(one);
    return box("edts", fullBox("elst", 1, 0, edit.text()));
}

/// How many samples the chunks have: an entry for every chunk that differs from the one before.
std::string chunkRuns(const Mp4Track& track)
{
    FilmBytes runs;
    std::uint64_t count = 0;
    for (std::size_t chunk = 0; chunk < track.samplesPerChunk.size(); ++chunk) {
        if (chunk > 0 && track.samplesPerChunk[chunk] == track.samplesPerChunk[chunk - 1])
            continue;
        runs.add32(chunk + 1).add32(track.samplesPerChunk[chunk]).add32(1);
        ++count;
    }
    return fullBox("stsc", 0, 0, FilmBytes().add32(count).add(runs.text()).text());
}

std::string sampleTable(const Mp4Track& track)
{
    const std::size_t count = track.sizes.size();
    const std::string times = FilmBytes().add32(1).add32(count).add32(track.unitsPerSample).text();
    FilmBytes keys;
    keys.add32(track.keys.size());
    for (const std::uint32_t key : track.keys)
        keys.add32(key);
    FilmBytes sizes;
    sizes.add32(0).add32(count);
    for (const std::uint32_t size : track.sizes)
        sizes.add32(size);
    FilmBytes chunks;
    chunks.add32(track.chunks.size());
    for (const std::uint64_t chunk : track.chunks)
        chunks.add64(chunk);
    return box("stbl", fullBox("stsd", 0, 0, FilmBytes().add32(1).add(track.description).text()) +
                           fullBox("stts", 0, 0, times) +
                           (track.keys.empty() ? std::string() : fullBox("stss", 0, 0, keys.text())) +
                           chunkRuns(track) + fullBox("stsz", 0, 0, sizes.text()) +
                           fullBox("co64", 0, 0, chunks.text()));
}

std::string trackBox(const Mp4Track& track, std::uint64_t number, std::uint64_t shown)
{
    const bool isSound = track.width == 0;
    const auto media = FilmBytes()
                           .zeros(16)
                           .add32(track.units)
                           .add64(durationOf(track))
                           .add16(undeterminedLanguage)
                           .zeros(2);
    const auto handler = FilmBytes()
                             .zeros(4)
                             .add(isSound ? "soun" : "vide")
                             .zeros(12)
                             .add(isSound ? "Sound" : "Pictures")
                             .zeros(1);
    const std::string kind = isSound ? fullBox("smhd", 0, 0, FilmBytes().zeros(4).text())
                                     : fullBox("vmhd", 0, 1, FilmBytes().zeros(8).text());
    const std::string here =
        fullBox("dref", 0, 0, FilmBytes().add32(1).add(fullBox("url ", 0, 1, {})).text());
    return box("trak",
               trackHeader(track, number, shown) + editBox(shown) +
                   box("mdia", fullBox("mdhd", 1, 0, media.text()) + fullBox("hdlr", 0, 0, handler.text()) +
                                   box("minf", kind + box("dinf", here) + sampleTable(track))));
}

} // namespace

std::string descriptionOfH264(int width, int height, const std::string& sequenceSet,
                              const std::string& pictureSet)
{
    // Version, profile and level as the sequence set has them, sizes of units in four bytes, one set of each
    // kind.
    const auto decoder = FilmBytes()
                             .add8(1)
                             .add(std::string_view(sequenceSet).substr(1, 3))
                             .add8(0xFF)
                             .add8(0xE1)
                             .add16(sequenceSet.size())
                             .add(sequenceSet)
                             .add8(1)
                             .add16(pictureSet.size())
                             .add(pictureSet);
    // Primaries, transfer and matrix of BT.709, in the range of films.
    const auto colors = FilmBytes().add("nclx").add16(1).add16(1).add16(1).add8(0);
    const auto entry = FilmBytes()
                           .zeros(6)
                           .add16(1) // data reference
                           .zeros(16)
                           .add16(static_cast<std::uint64_t>(width))
                           .add16(static_cast<std::uint64_t>(height))
                           .add32(72 * one) // dots an inch
                           .add32(72 * one)
                           .zeros(4)
                           .add16(1) // frame in a sample
                           .zeros(32)
                           .add16(24) // bits a pixel
                           .add16(0xFFFF)
                           .add(box("avcC", decoder.text()))
                           .add(box("colr", colors.text()));
    return box("avc1", entry.text());
}

std::string descriptionOfMp3(const Mp3Stream& sound)
{
    constexpr std::uint64_t mpeg1Audio = 0x6B;
    std::size_t largest = 0;
    for (const std::string& frame : sound.frames)
        largest = std::max(largest, frame.size());
    const auto decoder = FilmBytes()
                             .add8(mpeg1Audio)
                             .add8(0x15) // a stream of sound
                             .add(largest, 3)
                             .add32(static_cast<std::uint64_t>(sound.bitsPerSecond))
                             .add32(static_cast<std::uint64_t>(sound.bitsPerSecond));
    // Descriptors: a tag, a size, what is in it (ISO/IEC 14496-1).
    const auto stream = FilmBytes()
                            .add16(0)
                            .add8(0)
                            .add8(4)
                            .add8(decoder.text().size())
                            .add(decoder.text())
                            .add8(6)
                            .add8(1)
                            .add8(2);
    const auto descriptor = FilmBytes().add8(3).add8(stream.text().size()).add(stream.text());
    const auto entry = FilmBytes()
                           .zeros(6)
                           .add16(1) // data reference
                           .zeros(8)
                           .add16(static_cast<std::uint64_t>(sound.channels))
                           .add16(16) // bits a sample
                           .zeros(4)
                           .add16(static_cast<std::uint64_t>(sound.rate))
                           .add16(0)
                           .add(fullBox("esds", 0, 0, descriptor.text()));
    return box("mp4a", entry.text());
}

std::string movieBox(const std::vector<Mp4Track>& tracks)
{
    const std::uint64_t shown = durationOf(tracks.front());
    std::string content = movieHeader(tracks.front(), tracks.size());
    for (std::size_t i = 0; i < tracks.size(); ++i)
        content += trackBox(tracks[i], i + 1, shown);
    return box("moov", content);
}

} // namespace quadrille
