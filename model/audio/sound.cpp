// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/audio/sound.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/message.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <sndfile.h>

namespace quadrille {

namespace {

/// A file in memory, as libsndfile reads it.
struct MemoryFile
{
    std::span<const std::byte> bytes;
    sf_count_t at = 0;

    static MemoryFile& of(void* self) { return *static_cast<MemoryFile*>(self); }
    static sf_count_t length(void* self) { return static_cast<sf_count_t>(of(self).bytes.size()); }
    static sf_count_t seek(sf_count_t offset, int whence, void* self)
    {
        MemoryFile& file = of(self);
        const sf_count_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? file.at : length(self);
        file.at = std::clamp<sf_count_t>(from + offset, 0, length(self));
        return file.at;
    }
    static sf_count_t read(void* to, sf_count_t count, void* self)
    {
        MemoryFile& file = of(self);
        const sf_count_t taken = std::min(count, length(self) - file.at);
        std::memcpy(to, file.bytes.data() + file.at, static_cast<std::size_t>(taken));
        file.at += taken;
        return taken;
    }
    static sf_count_t write(const void*, sf_count_t, void*) { return 0; }
    static sf_count_t tell(void* self) { return of(self).at; }
};

[[noreturn]] void refuseSound(const std::filesystem::path& file)
{
    throw Error(ErrorCode::FormatRefused, {file,
                                           {},
                                           {{"format", QUADRILLE_MESSAGE("The sound of this file")},
                                            {"remedy", QUADRILLE_MESSAGE("Save it as WAV.")}}});
}

} // namespace

Sound readSound(const std::filesystem::path& file, const Progress& progress)
{
    constexpr sf_count_t atOnce = sf_count_t{1} << 18;
    constexpr int mostChannels = 64;
    const FileContent content = readFile(file);
    MemoryFile memory{content.bytes()};
    SF_VIRTUAL_IO access{&MemoryFile::length, &MemoryFile::seek, &MemoryFile::read, &MemoryFile::write,
                         &MemoryFile::tell};
    SF_INFO info{};
    const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> opened(
        sf_open_virtual(&access, SFM_READ, &info, &memory), &sf_close);
    if (!opened || info.samplerate <= 0 || info.channels < 1 || info.channels > mostChannels ||
        info.frames < 1)
        refuseSound(file);
    Sound sound{.rate = info.samplerate, .channels = info.channels, .samples = {}};
    // What the header promises is believed only once it is read.
    std::vector<float> part(static_cast<std::size_t>(atOnce * info.channels));
    for (sf_count_t read = 1; read > 0;) {
        read = sf_readf_float(opened.get(), part.data(), atOnce);
        sound.samples.insert(sound.samples.end(), part.begin(), part.begin() + read * info.channels);
        progress.report(
            std::min(1.0, static_cast<double>(sound.frameCount()) / static_cast<double>(info.frames)));
    }
    if (sound.samples.empty())
        refuseSound(file);
    for (float& sample : sound.samples)
        sample = std::isfinite(sample) ? sample : 0.0F;
    return sound;
}

} // namespace quadrille
