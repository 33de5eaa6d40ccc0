// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/format.h"

namespace quadrille {

/// USD as text (.usda): one mesh with time-sampled points and extent, texture coordinates per corner
/// (primvars:st), preview materials whose pictures are copied beside the file. Textures per frame become time
/// samples of the picture's path.
class UsdExporter : public Exporter
{
public:
    const FormatInfo& format() const override;
    /// \throws Error also FormatCannotStore for x up, which USD does not know.
    ExportResult write(const MeshSequence& sequence, const std::filesystem::path& out,
                       const ExportOptions& options, const Progress& progress) const override;
};

} // namespace quadrille
