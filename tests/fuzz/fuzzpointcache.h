// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/pointcache.h"
#include "tests/fuzz/fuzzfile.h"

namespace quadrille {

using ReadLayout = PointCacheLayout (*)(const InputFile&);

/// Reads the layout from the fuzzer's bytes, and the last frame that it promises. Anything but a layout that
/// fits the file or an Error is a bug.
inline void fuzzPointCache(const std::uint8_t* data, std::size_t size, const char* ending,
                           ReadLayout readLayout)
{
    try {
        const InputFile file(fuzzFile(data, size, ending));
        const PointCacheLayout layout = readLayout(file);
        checkLayout(layout, file);
        std::vector<std::byte> frame(layout.frameBytes());
        file.read(layout.offset + static_cast<std::uint64_t>(layout.frameCount - 1) * layout.frameBytes(),
                  frame);
    } catch (const Error&) {
    }
}

} // namespace quadrille
