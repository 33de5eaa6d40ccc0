// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/film/mp4film.h"

#include "model/film/boxes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace quadrille {

namespace {

constexpr std::uint64_t boxHead = 8;

/// The same fraction with units of at most a ten-thousandth of a second: some players round to those of the
/// film.
FrameRate fine(FrameRate rate)
{
    constexpr std::uint32_t fewest = 10000;
    while (rate.units < fewest && rate.unitsPerFrame < (1U << 31U)) {
        rate.units *= 2;
        rate.unitsPerFrame *= 2;
    }
    return rate;
}

} // namespace

Mp4Film::Mp4Film(const std::filesystem::path& place, const std::filesystem::path& film,
                 const FilmFormat& format, std::optional<Mp3Stream> sound)
    : m_format(format)
    , m_encoder(format, film)
    , m_sound(std::move(sound))
    , m_file(place, film)
    , m_chunkPictures(std::max<std::int64_t>(std::llround(format.fps / 2), 1))
{
    const FrameRate rate = fine(frameRateOf(format.fps));
    Mp4Track& pictures = m_tracks.emplace_back();
    pictures.units = rate.units;
    pictures.unitsPerSample = rate.unitsPerFrame;
    pictures.width = format.width;
    pictures.height = format.height;
    pictures.description =
        descriptionOfH264(format.width, format.height, m_encoder.sequenceSet(), m_encoder.pictureSet());
    if (m_sound && m_sound->frames.empty())
        m_sound.reset();
    if (m_sound) {
        Mp4Track& heard = m_tracks.emplace_back();
        heard.units = static_cast<std::uint32_t>(m_sound->rate);
        heard.unitsPerSample = static_cast<std::uint32_t>(m_sound->samplesPerFrame);
        heard.description = descriptionOfMp3(*m_sound);
    }
    m_file.write(box("ftyp", FilmBytes().add("isom").add32(512).add("isomiso2avc1mp41").text()));
    reserveTables();
    m_file.write(FilmBytes().add32(1).add("mdat").add64(0).text());
}

/// The tables are as large as if every picture were a key and every chunk differed from the one before.
void Mp4Film::reserveTables()
{
    std::vector<Mp4Track> largest = m_tracks;
    const auto frames = static_cast<std::size_t>(m_format.frames);
    // One that is not full, and one of sound behind the last picture.
    const std::size_t chunks = frames / static_cast<std::size_t>(m_chunkPictures) + 2;
    for (Mp4Track& track : largest) {
        track.sizes.resize(frames);
        track.chunks.resize(chunks);
        for (std::size_t chunk = 0; chunk < chunks; ++chunk)
            track.samplesPerChunk.push_back(chunk % 2);
    }
    largest.front().keys.resize(frames);
    if (m_sound)
        largest.back().sizes.resize(m_sound->frames.size());
    m_tablesAt = m_file.size();
    m_tableBytes = movieBox(largest).size() + boxHead;
    m_file.write(box("free", std::string(m_tableBytes - boxHead, '\0')));
}

void Mp4Film::add(const Image& picture)
{
    Mp4Track& track = m_tracks.front();
    const auto number = static_cast<std::int64_t>(track.sizes.size());
    assert(number < m_format.frames);
    if (number % m_chunkPictures == 0) {
        writeSoundUntil(static_cast<double>(number) / m_format.fps);
        track.chunks.push_back(m_file.size());
        track.samplesPerChunk.push_back(0);
    }
    const CompressedPicture compressed = m_encoder.encode(picture);
    m_file.write(compressed.bytes);
    track.sizes.push_back(static_cast<std::uint32_t>(compressed.bytes.size()));
    ++track.samplesPerChunk.back();
    if (compressed.isKey)
        track.keys.push_back(static_cast<std::uint32_t>(number + 1));
}

/// A chunk of the sound that is heard before a time and not written yet, if any.
void Mp4Film::writeSoundUntil(double seconds)
{
    if (!m_sound)
        return;
    Mp4Track& track = m_tracks.back();
    const double frames = seconds * m_sound->rate / m_sound->samplesPerFrame;
    const std::size_t end = std::min(m_sound->frames.size(), static_cast<std::size_t>(std::ceil(frames)));
    const std::size_t first = track.sizes.size();
    if (first >= end)
        return;
    track.chunks.push_back(m_file.size());
    track.samplesPerChunk.push_back(static_cast<std::uint32_t>(end - first));
    for (std::size_t i = first; i < end; ++i) {
        m_file.write(m_sound->frames[i]);
        track.sizes.push_back(static_cast<std::uint32_t>(m_sound->frames[i].size()));
    }
}

void Mp4Film::finish()
{
    writeSoundUntil(std::numeric_limits<std::int32_t>::max());
    const std::uint64_t mediaAt = m_tablesAt + m_tableBytes;
    m_file.overwrite(mediaAt + 8, FilmBytes().add64(m_file.size() - mediaAt).text());
    const std::string tables = movieBox(m_tracks);
    assert(tables.size() + boxHead <= m_tableBytes);
    const std::uint64_t rest = m_tableBytes - tables.size();
    m_file.overwrite(m_tablesAt, tables + FilmBytes().add32(rest).add("free").text());
    m_file.close();
}

} // namespace quadrille
