// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/pointcache.h"

namespace quadrille {

/// Positions as a NumPy array: frames × vertices × 3, or vertices × 3 for one frame; float32 or float64 of
/// either byte order, in C order.
/// \throws Error FileSyntax, FileTruncated, FormatRefused for other types and orders.
PointCacheLayout readNpyLayout(const InputFile& file);

std::unique_ptr<Importer> makeNpyImporter();
/// Writes format 1.0, float32, little endian.
std::unique_ptr<Exporter> makeNpyExporter();

} // namespace quadrille
