// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/projection/pinholecamera.h"
#include "model/sequence/axes.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

namespace quadrille {

/// A calibrated camera and its pictures.
struct CameraSeries
{
    PinholeCamera camera;
    std::map<std::int64_t, std::filesystem::path> pictures; ///< by the frame of the clip that they show

    /// The picture of a frame; empty where there is none.
    std::filesystem::path pictureOf(FrameIndex frame) const;
};

/// Reads a table of cameras: {"cameras": [{"name", "size", "matrix", "distortion", "rotation",
/// "translation", "images", "first_frame"}, …]}, as the manual has it.
/// \param from  what the world of the calibration is in; nothing: as \p to. \param to  what points are in.
/// \throws Error ProjectSyntax and ProjectInvalid with the place; FileNotFound, SeriesEmpty and
/// SeriesAmbiguous where pictures are not found; and what reading the file throws.
std::vector<CameraSeries> readCameraTable(const std::filesystem::path& file,
                                          const std::optional<CoordinateSystem>& from,
                                          const CoordinateSystem& to);

/// The camera for points in other coordinates. Its own become longer or shorter with the unit.
PinholeCamera converted(const PinholeCamera& camera, const CoordinateSystem& from,
                        const CoordinateSystem& to);

} // namespace quadrille
