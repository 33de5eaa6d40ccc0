// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/pointcache.h"

namespace quadrille {

/// Header of PC2: "POINTCACHE2\0", int32 version 1, int32 points, float32 start frame, float32 sample rate,
/// int32 samples; little endian, 32 bytes. A sample rate is taken for frames a second where it can be one
/// (10 … 1000); usually it is 1 and says nothing.
/// \throws Error FileSyntax, FileTruncated.
PointCacheLayout readPc2Layout(const InputFile& file);

std::unique_ptr<Importer> makePc2Importer();
std::unique_ptr<Exporter> makePc2Exporter();

} // namespace quadrille
