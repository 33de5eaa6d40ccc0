// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace quadrille {

/// Puts small GLB files together for tests: accessors by values, the rest as JSON.
class GlbBuilder
{
public:
    GlbBuilder();

    /// Adds an accessor of floats and returns its index.
    int floats(const std::vector<float>& values, const std::string& type);
    int vectors(const std::vector<Vec3f>& values);
    /// Adds an accessor of 8-, 16- or 32-bit unsigned integers.
    int integers(const std::vector<std::uint32_t>& values, const std::string& type, int bytes);
    /// Adds a buffer view of raw bytes and returns its index.
    int bytes(const std::string& data);
    std::string glb() const;
    /// The same as .gltf with the buffer as a data URI, or without the buffer's URI.
    std::string gltf(const std::string& bufferUri) const;

    nlohmann::json json;
    std::string buffer;

private:
    int accessor(int components, std::size_t valueCount, const std::string& type);
};

/// A quad of two triangles split along its diagonal, skinned to two joints of which the second moves along x
/// from 0 to 1 in one second ("Slide").
GlbBuilder skinnedQuad();

} // namespace quadrille
