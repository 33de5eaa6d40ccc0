// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/format.h"

namespace quadrille {

/// GLB: one mesh, the first frame as its base and one morph target for each further frame, driven by a
/// weights animation that shows frame k at k / fps, linear between frames. glTF allows one texture coordinate
/// per vertex, so vertices on seams are written several times; the attribute "_VERTEX" keeps their place, and
/// our importer gives back the same vertices in the same order. Smooth normals go with the base and, since
/// the surface turns, with every target: without them viewers shade each triangle flat. They take as much
/// room as the positions; ExportOptions::normals leaves them out. Of textures per frame the first is
/// embedded, with an issue.
class GlbExporter : public Exporter
{
public:
    const FormatInfo& format() const override;
    /// \throws Error also FormatCannotStore above 4 GB.
    ExportResult write(const MeshSequence& sequence, const std::filesystem::path& out,
                       const ExportOptions& options, const Progress& progress) const override;
};

/// Bytes of the GLB file of a sequence without its textures, at most. The exporter raises an issue above
/// glbLargeBytes.
std::uint64_t estimateGlbBytes(const MeshSequence& sequence, bool normals = true);
inline constexpr std::uint64_t glbLargeBytes = std::uint64_t{100} << 20;

} // namespace quadrille
