// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/registry.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <optional>
#include <string>

namespace quadrille::test {

/// A take of rb_m04, a man driven by motion capture, 30 fps; nothing where the real data are not there.
inline std::optional<MeshSequence> realTake(const std::string& name)
{
    const std::filesystem::path folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/rb_m04";
    if (!std::filesystem::exists(folder))
        return std::nullopt;
    ImportOptions options;
    options.mesh = folder / "mesh.obj";
    options.fps = 30;
    return openSequences(folder / (name + ".pc2"), options).sequences.front();
}

} // namespace quadrille::test
