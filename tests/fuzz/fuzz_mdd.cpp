// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mdd.h"
#include "tests/fuzz/fuzzfile.h"

using namespace quadrille;

/// Anything but a layout that fits the file or an Error is a bug.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        const InputFile file(fuzzFile(data, size, ".mdd"));
        const PointCacheLayout layout = readMddLayout(file);
        checkLayout(layout, file);
        std::vector<std::byte> frame(layout.frameBytes());
        file.read(layout.offset + static_cast<std::uint64_t>(layout.frameCount - 1) * layout.frameBytes(),
                  frame);
    } catch (const Error&) {
    }
    return 0;
}
