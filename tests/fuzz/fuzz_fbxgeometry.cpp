// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/fbxgeometry.h"

#include <span>

using namespace quadrille;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    readFbxGeometries(std::as_bytes(std::span(data, size)));
    return 0;
}
