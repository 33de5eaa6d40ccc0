// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/mesh/meshfile.h"

#include <cstdint>

namespace quadrille {

using ParseMesh = MeshFile (*)(std::string_view, const std::filesystem::path&);
using MakePositionReader = std::shared_ptr<const PositionReader> (*)(std::string_view, const MeshFile&);

/// Parses the fuzzer's bytes; then the position reader must agree with the parser about the same bytes.
/// Anything but a mesh or an Error is a bug.
inline void fuzzMesh(const std::uint8_t* data, std::size_t size, ParseMesh parse,
                     MakePositionReader makeReader = nullptr)
{
    const std::string_view content(reinterpret_cast<const char*>(data), size);
    try {
        const MeshFile mesh = parse(content, "fuzz");
        std::vector<Issue> issues;
        buildTopology(mesh.topology, mesh.positions, "fuzz", issues);
        const auto reader = makeReader ? makeReader(content, mesh) : nullptr;
        std::vector<Vec3f> positions(mesh.positions.size());
        if (reader && !reader->read(content, positions))
            __builtin_trap();
    } catch (const Error&) {
    }
}

} // namespace quadrille
