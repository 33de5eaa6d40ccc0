// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/format.h"
#include "model/sequence/io/scene/scene.h"

namespace quadrille {

/// Turns a scene into sequences: one per clip, baked from its first to its last key at the rate of its
/// keys, or at options.fps where they have none (keyRate); or one of one frame where there are no clips. The
/// meshes of all nodes become one topology, split vertices welded. \param formatName  names the format in
/// messages. \throws Error SceneWithoutMesh, NonFiniteCoordinate, BadArgument (no such clip, impossible fps),
/// CountTooLarge (a clip of more than 10 million frames), what Topology throws.
ImportResult sequencesFromScene(Scene scene, const std::filesystem::path& file, const ImportOptions& options,
                                const Progress& progress);

} // namespace quadrille
