// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mesh/obj.h"
#include "tests/fuzz/fuzzmesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    quadrille::fuzzMesh(data, size, quadrille::parseObj, quadrille::makeObjPositionReader);
    return 0;
}
