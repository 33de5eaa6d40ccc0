// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/film/filmwriter.h"

#include <limits>
#include <vector>

namespace quadrille {

/// A film in AVI whose pictures are JPEG, each by itself (Motion JPEG): for programs that cut films picture
/// by picture. It has no sound, and holds four gigabytes.
class AviFilm : public FilmWriter
{
public:
    /// \param place  where the film is written for now. \param film  names it in errors.
    /// \param largest  bytes of the file, at most.
    /// \throws Error what FilmFile throws.
    AviFilm(const std::filesystem::path& place, const std::filesystem::path& film, const FilmFormat& format,
            std::uint64_t largest = std::numeric_limits<std::uint32_t>::max());

    /// \throws Error BadArgument where the film becomes too large; WriteFailed, PermissionDenied.
    void add(const Image& picture) override;
    void finish() override;

private:
    std::string head() const;

    FilmFormat m_format;
    FilmFile m_file;
    std::uint64_t m_largestFile;
    std::vector<std::uint32_t> m_sizes; ///< of the pictures, bytes
    std::uint64_t m_pictureBytes = 0;   ///< with their heads and what fills them up
    std::uint32_t m_largestPicture = 0;
};

} // namespace quadrille
