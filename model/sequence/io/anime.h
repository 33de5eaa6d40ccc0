// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/format.h"

namespace quadrille {

/// DeformingThings4D .anime: int32 frames, vertices, triangles; float32 positions of the first frame; int32
/// triangles; float32 offsets of every further frame from the first. Little endian. Source: Li et al.,
/// "4DComplete", ICCV 2021, anime_read in the data set's code.
class AnimeImporter : public Importer
{
public:
    const FormatInfo& format() const override;
    ImportResult open(const SourceFiles& source, const ImportOptions& options,
                      const Progress& progress) const override;
};

} // namespace quadrille
