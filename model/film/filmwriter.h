// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"

#include <cstdint>
#include <fstream>
#include <string_view>

namespace quadrille {

/// Frames per second as a fraction, exact where it is one that films have: 25/1, 25/2, 2997/100, 30000/1001.
struct FrameRate
{
    std::uint32_t units = 25; ///< of time in a second
    std::uint32_t unitsPerFrame = 1;

    bool operator==(const FrameRate&) const = default;
};
/// \param fps  from 10⁻⁶ to 10⁶; the nearest of these otherwise.
FrameRate frameRateOf(double fps);

/// What is known of a film before its first picture.
struct FilmFormat
{
    int width = 0;
    int height = 0;
    double fps = 25;
    std::int64_t frames = 0;
};

/// Writes a film, picture after picture; what is written does not depend on threads.
class FilmWriter
{
public:
    FilmWriter() = default;
    virtual ~FilmWriter() = default;
    FilmWriter(const FilmWriter&) = delete;
    FilmWriter& operator=(const FilmWriter&) = delete;

    /// \pre the picture has the film's size; as many come as were promised.
    /// \throws Error WriteFailed, PermissionDenied.
    virtual void add(const Image& picture) = 0;
    /// To be called after the last picture. \throws Error WriteFailed, PermissionDenied.
    virtual void finish() = 0;
};

/// The file that a film is written into. Its errors name the film.
class FilmFile
{
public:
    /// \param place  where the film is written for now.
    /// \throws Error WriteFailed, PermissionDenied.
    FilmFile(const std::filesystem::path& place, std::filesystem::path film);

    const std::filesystem::path& film() const { return m_film; }
    std::uint64_t size() const { return m_size; }
    void write(std::string_view bytes);
    /// Writes over bytes that are there.
    void overwrite(std::uint64_t at, std::string_view bytes);
    void close();

private:
    void check() const;

    std::filesystem::path m_film;
    std::ofstream m_file;
    std::uint64_t m_size = 0;
};

} // namespace quadrille
