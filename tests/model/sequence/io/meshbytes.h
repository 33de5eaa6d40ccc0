// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <ostream>
#include <string>
#include <vector>

namespace quadrille {

/// A mesh as files have it: nothing of it need be right.
struct RawMesh
{
    std::vector<Vec3f> points;
    std::vector<std::vector<int>> faces;
};

/// A way to put a mesh into a file of one format, right or wrong.
struct RawFormat
{
    const char* name;
    const char* extension;
    std::string (*bytes)(const RawMesh& mesh);
    bool isText = false;      ///< cut text may still be a file of the format
    bool hasIndices = true;   ///< faces name vertices by index
    bool hasPolygons = false; ///< faces may have more than three corners
    bool keepsIndices = true; ///< the reader knows which corners are one vertex
};

inline std::ostream& operator<<(std::ostream& out, const RawFormat& format)
{
    return out << format.name;
}

/// Every format that holds faces.
const std::vector<RawFormat>& rawFormats();

/// A double pyramid over a square: closed, 6 vertices, 8 triangles.
RawMesh rawPyramid();

} // namespace quadrille
