// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/io/files/format.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace quadrille {

/// What a mesh file gives to positions without faces.
struct BaseMesh
{
    std::shared_ptr<const Topology> topology;
    TextureSet textures;
    std::vector<Issue> issues;
};

/// Reads a mesh file. While anybody holds its topology and the file stays as it is, the file is read once:
/// all takes of a character share one topology. Safe from any thread; who asks meanwhile waits. \throws Error
/// what the format's importer throws; NoFaces where it has positions only.
BaseMesh readBaseMesh(const std::filesystem::path& file, const Progress& progress = {});

} // namespace quadrille
