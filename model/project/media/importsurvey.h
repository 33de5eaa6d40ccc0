// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/core/progress.h"
#include "model/sequence/axes.h"
#include "model/sequence/io/ratebeside.h"
#include "model/sequence/meshsequence.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// What files and folders hold, before anything of it is opened.
struct FoundSources
{
    /// Files, and folders or patterns that hold one numbered series, in natural order.
    std::vector<std::filesystem::path> sources;
    /// The mesh that was among them and belongs to the files with positions only; empty without any.
    std::filesystem::path mesh;
};

/// Looks into what a user chose or dropped: a numbered file stands for its series, a folder for the takes in
/// it and in the folders below it that hold a series. A single mesh beside point caches is their base mesh.
/// \throws Error FileNotFound, PermissionDenied; SeriesEmpty where nothing in it can be read.
FoundSources findSources(std::span<const std::filesystem::path> paths);

/// A take that could be imported: one for each source, or for each animation clip of it.
struct SurveyedTake
{
    std::filesystem::path source;
    std::string name;
    std::string clip;   ///< empty unless the source holds several
    std::string format; ///< a proper name, "Wavefront OBJ"
    /// All frames; empty when it cannot be opened. In metres with y up where the file names its unit and
    /// axes, else as the file has it.
    std::optional<MeshSequence> sequence;
    std::optional<Error> error; ///< why it cannot be opened
    std::vector<Issue> issues;
    std::optional<CoordinateSystem> coordinates; ///< that the file itself names
    bool hasOwnFps = false;
    bool isSampled = false;            ///< its times are seconds, see ImportResult::isSampled
    std::optional<RateBeside> rate;    ///< where the file names none and what lies beside it does
    std::filesystem::path mesh;        ///< that gives faces to positions; empty when the file has its own
    std::filesystem::path jointAngles; ///< BVH of the same name beside it; empty without one
    Vec3f size = Vec3f::Zero();        ///< of the first frame, along x, y and z
};

struct SurveyOptions
{
    std::filesystem::path mesh; ///< of files with positions only; looked for beside them when empty
    /// Meshes of characters: those that have none beside them take the first that has as many vertices.
    std::vector<std::filesystem::path> knownMeshes;
    double fps = 25; ///< of sources that name none
};

/// Opens each source as far as needed to describe it. One that cannot be opened says why and does not hinder
/// the others.
/// \throws Error Cancelled.
std::vector<SurveyedTake> surveySources(const std::vector<std::filesystem::path>& sources,
                                        const SurveyOptions& options, const Progress& progress = {});

/// Metres per unit that give a figure of this height, in units, the size of a person; 1 where no usual unit
/// does.
double likelyMetresPerUnit(double height);

} // namespace quadrille
