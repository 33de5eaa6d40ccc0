// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/file.h"
#include "model/sequence/io/files/format.h"

#include <memory>
#include <optional>

namespace quadrille {

/// How a file lays out positions: frames one after the other, each vertices × 3 numbers without gaps.
struct PointCacheLayout
{
    std::int64_t frameCount = 0;
    std::int64_t vertexCount = 0;
    std::uint64_t offset = 0; ///< bytes before the first frame
    unsigned numberBytes = 4; ///< of one coordinate: 2, 4 or 8, as IEEE 754 has them
    bool isBigEndian = false;
    std::optional<double> fps; ///< when the file names a real rate
    std::vector<Issue> issues;

    std::uint64_t frameBytes() const { return static_cast<std::uint64_t>(vertexCount) * 3 * numberBytes; }
};

/// Checks a layout against the size of its file before anything is allocated.
/// \throws Error NoVertices, SeriesEmpty, CountTooLarge, FileTruncated.
void checkLayout(const PointCacheLayout& layout, const InputFile& file);

/// A format that holds positions only.
struct PointCacheFormat
{
    FormatInfo info;
    bool (*recognises)(std::string_view head) = nullptr;
    /// \throws Error FileSyntax, FileTruncated, FormatRefused and what checkLayout throws.
    PointCacheLayout (*readLayout)(const InputFile& file) = nullptr;
};

/// The importer of such a format: faces, UVs and textures come from options.mesh, or from a mesh beside the
/// file that has as many vertices: of the same name, called `mesh`, or the only one there. Frames are read
/// when asked for.
std::unique_ptr<Importer> makePointCacheImporter(PointCacheFormat format);

/// How such a format is written: a header, then the positions of all frames as 32-bit numbers.
struct PointCacheWriterFormat
{
    FormatInfo info;
    std::string (*header)(const MeshSequence& sequence) = nullptr;
    bool isBigEndian = false;
};
std::unique_ptr<Exporter> makePointCacheExporter(PointCacheWriterFormat format);

} // namespace quadrille
