// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/audio/mp4sound.h"

#include "model/core/error.h"
#include "model/core/message.h"

#include <algorithm>
#include <fstream>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// Frames that lie together.
constexpr std::size_t chunkFrames = 32;

[[noreturn]] void refuseBoxes(const fs::path& file)
{
    throw Error(ErrorCode::FileSyntax,
                {file, {}, {{"reason", QUADRILLE_MESSAGE("a box of the MP4 is missing")}}});
}

/// Big-endian numbers, one after the other.
class Bytes
{
public:
    Bytes& add(std::uint64_t value, int bytes)
    {
        for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
            m_text += static_cast<char>((value >> static_cast<unsigned>(shift)) & 0xFFU);
        return *this;
    }
    Bytes& add8(std::uint64_t value) { return add(value, 1); }
    Bytes& add16(std::uint64_t value) { return add(value, 2); }
    Bytes& add32(std::uint64_t value) { return add(value, 4); }
    Bytes& add(std::string_view text)
    {
        m_text += text;
        return *this;
    }
    Bytes& zeros(std::size_t count)
    {
        m_text.append(count, '\0');
        return *this;
    }
    const std::string& text() const { return m_text; }

private:
    std::string m_text;
};

std::string box(std::string_view type, const std::string& content)
{
    return Bytes().add32(8 + content.size()).add(type).add(content).text();
}

/// A box with version 0 and flags.
std::string fullBox(std::string_view type, std::uint32_t flags, const std::string& content)
{
    return box(type, Bytes().add32(flags).add(content).text());
}

std::uint64_t numberAt(std::string_view bytes, std::size_t at, std::size_t count)
{
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
        value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

/// Where the “moov” box of a file is, and what is in it.
struct Movie
{
    std::uint64_t at = 0;
    std::uint64_t fileSize = 0;
    std::string moov; ///< with its header
};

Movie readMovie(const fs::path& file, std::istream& in)
{
    Movie movie{.fileSize = fs::file_size(file)};
    for (std::uint64_t at = 0; at + 8 <= movie.fileSize;) {
        std::string head(16, '\0');
        in.clear();
        in.seekg(static_cast<std::streamoff>(at));
        in.read(head.data(), 16);
        std::uint64_t size = numberAt(head, 0, 4);
        if (size == 1)
            size = numberAt(head, 8, 8);
        else if (size == 0)
            size = movie.fileSize - at;
        if (size < 8 || size > movie.fileSize - at)
            refuseBoxes(file);
        if (head.substr(4, 4) == "moov" && numberAt(head, 0, 4) > 1) {
            movie.at = at;
            movie.moov.resize(size);
            in.clear();
            in.seekg(static_cast<std::streamoff>(at));
            in.read(movie.moov.data(), static_cast<std::streamsize>(size));
            return movie;
        }
        at += size;
    }
    refuseBoxes(file);
}

/// What the movie header says, and where in the moov box its next track's number is.
struct MovieHeader
{
    std::uint64_t duration = 0; ///< in its own units
    std::size_t nextTrackAt = 0;
};

MovieHeader headerOf(const fs::path& file, const std::string& moov)
{
    const std::size_t at = 8;
    if (moov.size() < at + 108 || moov.substr(at + 4, 4) != "mvhd")
        refuseBoxes(file);
    const bool isLong = moov[at + 8] == 1;
    if (isLong && moov.size() < at + 120)
        refuseBoxes(file);
    return isLong ? MovieHeader{numberAt(moov, at + 32, 8), at + 116}
                  : MovieHeader{numberAt(moov, at + 24, 4), at + 104};
}

std::string unityMatrix()
{
    return Bytes().add32(0x10000).zeros(12).add32(0x10000).zeros(12).add32(0x40000000).text();
}

/// How the samples are to be decoded (ISO/IEC 14496-1: “esds”).
std::string sampleDescription(const Mp3Stream& sound)
{
    constexpr std::uint64_t mpeg1Audio = 0x6B;
    std::size_t largest = 0;
    for (const std::string& frame : sound.frames)
        largest = std::max(largest, frame.size());
    const std::string decoder = Bytes()
                                    .add8(mpeg1Audio)
                                    .add8(0x15) // a stream of sound
                                    .add(largest, 3)
                                    .add32(static_cast<std::uint64_t>(sound.bitsPerSecond))
                                    .add32(static_cast<std::uint64_t>(sound.bitsPerSecond))
                                    .text();
    const std::string stream =
        Bytes().add16(0).add8(0).add8(4).add8(decoder.size()).add(decoder).add8(6).add8(1).add8(2).text();
    const std::string esds = fullBox("esds", 0, Bytes().add8(3).add8(stream.size()).add(stream).text());
    const std::string entry = Bytes()
                                  .zeros(6)
                                  .add16(1) // data reference
                                  .zeros(8)
                                  .add16(static_cast<std::uint64_t>(sound.channels))
                                  .add16(16)
                                  .zeros(4)
                                  .add16(static_cast<std::uint64_t>(sound.rate))
                                  .add16(0)
                                  .add(esds)
                                  .text();
    return fullBox("stsd", 0, Bytes().add32(1).add(box("mp4a", entry)).text());
}

/// Which bytes of the file each frame is. \param at  of the first.
std::string sampleTable(const Mp3Stream& sound, std::uint64_t at)
{
    const std::size_t count = sound.frames.size();
    const std::size_t chunks = (count + chunkFrames - 1) / chunkFrames;
    const std::size_t lastFrames = count - (chunks - 1) * chunkFrames;
    Bytes sizes;
    sizes.add32(0).add32(count);
    Bytes offsets;
    offsets.add32(chunks);
    for (std::size_t i = 0; i < count; ++i) {
        if (i % chunkFrames == 0)
            offsets.add(at, 8);
        sizes.add32(sound.frames[i].size());
        at += sound.frames[i].size();
    }
    Bytes perChunk;
    perChunk.add32(chunks > 1 && lastFrames != chunkFrames ? 2 : 1);
    perChunk.add32(1).add32(chunks > 1 ? chunkFrames : lastFrames).add32(1);
    if (chunks > 1 && lastFrames != chunkFrames)
        perChunk.add32(chunks).add32(lastFrames).add32(1);
    const std::string times =
        Bytes().add32(1).add32(count).add32(static_cast<std::uint64_t>(sound.samplesPerFrame)).text();
    return box("stbl", sampleDescription(sound) + fullBox("stts", 0, times) +
                           fullBox("stsc", 0, perChunk.text()) + fullBox("stsz", 0, sizes.text()) +
                           fullBox("co64", 0, offsets.text()));
}

/// The track of the sound: it shows as long as the movie, from behind the encoder's delay.
std::string trackBox(const Mp3Stream& sound, std::uint64_t track, std::uint64_t duration, std::uint64_t at)
{
    const std::string header = Bytes()
                                   .zeros(8)
                                   .add32(track)
                                   .zeros(4)
                                   .add32(duration)
                                   .zeros(8)
                                   .add16(0)
                                   .add16(1) // to be chosen among tracks of sound
                                   .add16(0x0100)
                                   .zeros(2)
                                   .add(unityMatrix())
                                   .zeros(8)
                                   .text();
    const std::string edit =
        Bytes().add32(1).add32(duration).add32(static_cast<std::uint64_t>(sound.delay)).add32(0x10000).text();
    const auto length = static_cast<std::uint64_t>(sound.samplesPerFrame) * sound.frames.size();
    constexpr std::uint64_t undetermined = 0x55C4; // language
    const std::string media = Bytes()
                                  .zeros(8)
                                  .add32(static_cast<std::uint64_t>(sound.rate))
                                  .add32(length)
                                  .add16(undetermined)
                                  .add16(0)
                                  .text();
    const std::string handler = Bytes().zeros(4).add("soun").zeros(12).add("Sound").zeros(1).text();
    const std::string reference = fullBox("dref", 0, Bytes().add32(1).add(fullBox("url ", 1, {})).text());
    const std::string information = box("minf", fullBox("smhd", 0, Bytes().zeros(4).text()) +
                                                    box("dinf", reference) + sampleTable(sound, at));
    return box("trak",
               fullBox("tkhd", 3, header) + box("edts", fullBox("elst", 0, edit)) +
                   box("mdia", fullBox("mdhd", 0, media) + fullBox("hdlr", 0, handler) + information));
}

} // namespace

void addSound(const fs::path& mp4, const Mp3Stream& sound)
{
    std::fstream file(mp4, std::ios::in | std::ios::out | std::ios::binary);
    if (!file)
        throw Error(ErrorCode::ReadFailed, {mp4, {}, {{"reason", QUADRILLE_MESSAGE("it cannot be opened")}}});
    Movie movie = readMovie(mp4, file);
    const MovieHeader header = headerOf(mp4, movie.moov);
    if (sound.frames.empty())
        return;
    // The old tables at the end of the file give way; elsewhere they become free space.
    const bool isLast = movie.at + movie.moov.size() == movie.fileSize;
    const std::uint64_t end = isLast ? movie.at : movie.fileSize;
    const std::uint64_t track = numberAt(movie.moov, header.nextTrackAt, 4);
    movie.moov.replace(header.nextTrackAt, 4, Bytes().add32(track + 1).text());
    movie.moov += trackBox(sound, track, header.duration, end + 8);
    movie.moov.replace(0, 4, Bytes().add32(movie.moov.size()).text());
    std::uint64_t bytes = 8;
    for (const std::string& frame : sound.frames)
        bytes += frame.size();
    file.clear();
    if (!isLast) {
        file.seekp(static_cast<std::streamoff>(movie.at + 4));
        file << "free";
    }
    file.seekp(static_cast<std::streamoff>(end));
    file << Bytes().add32(bytes).add("mdat").text();
    for (const std::string& frame : sound.frames)
        file << frame;
    file << movie.moov;
    file.close();
    if (file.fail())
        throw Error(ErrorCode::WriteFailed,
                    {mp4, {}, {{"reason", QUADRILLE_MESSAGE("the disk may be full")}}});
}

} // namespace quadrille
