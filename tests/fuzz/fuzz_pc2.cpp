// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/pc2.h"
#include "tests/fuzz/fuzzpointcache.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    quadrille::fuzzPointCache(data, size, ".pc2", quadrille::readPc2Layout);
    return 0;
}
