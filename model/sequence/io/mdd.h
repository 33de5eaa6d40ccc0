// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/pointcache.h"

namespace quadrille {

/// Header of MDD: int32 frames, int32 points, then the time of each frame as float32 in seconds; everything
/// big endian. The rate is that of the times where it can be one (10 … 1000 a second); some writers count
/// frames instead, which says nothing. \throws Error FileTruncated, CountTooLarge.
PointCacheLayout readMddLayout(const InputFile& file);

std::unique_ptr<Importer> makeMddImporter();
std::unique_ptr<Exporter> makeMddExporter();

} // namespace quadrille
