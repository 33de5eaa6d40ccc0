// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/film/filmwriter.h"

#include "model/core/file.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <utility>

namespace quadrille {

FrameRate frameRateOf(double fps)
{
    fps = std::clamp(fps, 1e-6, 1e6);
    constexpr int largest = 1001;
    for (int perFrame = 1; perFrame <= largest; ++perFrame) {
        const double units = std::round(fps * perFrame);
        if (units >= 1 && std::abs(units - fps * perFrame) <= 1e-8 * units)
            return {static_cast<std::uint32_t>(units), static_cast<std::uint32_t>(perFrame)};
    }
    // No such fraction: a frame is a thousand units, or the units are thousandths of a second.
    const double units = std::max(1000.0, std::round(fps * 1000));
    return {static_cast<std::uint32_t>(units), static_cast<std::uint32_t>(std::llround(units / fps))};
}

FilmFile::FilmFile(const std::filesystem::path& place, std::filesystem::path film)
    : m_film(std::move(film)), m_file(place, std::ios::binary)
{
    check();
}

void FilmFile::write(std::string_view bytes)
{
    m_file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    check();
    m_size += bytes.size();
}

void FilmFile::overwrite(std::uint64_t at, std::string_view bytes)
{
    assert(at + bytes.size() <= m_size);
    m_file.seekp(static_cast<std::streamoff>(at));
    m_file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    m_file.seekp(0, std::ios::end);
    check();
}

void FilmFile::close()
{
    m_file.close();
    check();
}

void FilmFile::check() const
{
    if (!m_file)
        throwSystemError(m_film, errno, ErrorCode::WriteFailed);
}

} // namespace quadrille
