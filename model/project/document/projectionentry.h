// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/unknownkeys.h"
#include "model/sequence/axes.h"

#include <cstdint>
#include <optional>
#include <string>

namespace quadrille {

/// A clip with textures from pictures of calibrated cameras: 3D video (SCANS §5.2).
struct ProjectionEntry
{
    std::string name;
    std::string clip;    ///< "sequences/NAME", "transfers/NAME", "variations/NAME/3", …
    std::string cameras; ///< path of the table of cameras
    /// What the world of the calibration is in; that of the project.
    std::optional<CoordinateSystem> cameraAxes;
    std::int64_t size = 1024; ///< side of the textures, texels
    double sharpness = 4;     ///< how much more cameras count that see a surface from the front
    bool fills = true;        ///< texels that no camera sees, from other frames and their neighbours
    UnknownKeys unknown;

    bool operator==(const ProjectionEntry&) const = default;
};

} // namespace quadrille
