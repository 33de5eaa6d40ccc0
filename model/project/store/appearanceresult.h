// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/modeltextures.h"
#include "model/project/document/project.h"
#include "model/project/store/result.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace quadrille {

// The section “appearance” as results: the model of an entry in a file of its own, and the textures that it
// completes as pictures.

/// The steps of an entry.
std::string appearanceModelStep(const std::string& name);
std::string appearanceCompletionsStep(const std::string& name);
std::string appearancePosesStep(const std::string& name);
/// Whether there is a step of poses: frames of variations are to take their textures from it.
bool learnsPoses(const Project& project, const AppearanceEntry& entry);
/// Those that make what clips of a character take their textures from; none where it has no model.
std::vector<std::string> appearanceSteps(const Project& project, const std::string& character);
/// Where they write, in the folder of a project's results.
std::filesystem::path appearanceFolder(const std::filesystem::path& results, const std::string& name);

/// A frame that was learned from, and its row among the model's coefficients. Frames that show the same
/// texture share one.
struct AppearanceRow
{
    std::string sequence;
    FrameIndex frame; ///< of the sequence
    std::int64_t row = 0;
};

/// A texture that was completed.
struct CompletedFrame
{
    std::string sequence;
    FrameIndex frame;
    std::filesystem::path file; ///< the picture
    AppearanceCoefficients coefficients;
};

/// The table “frames” of a model's result, and back. \pre Of `appearanceRows`: there is such a table.
DataTable rowsTable(std::span<const AppearanceRow> rows);
std::vector<AppearanceRow> appearanceRows(const Result& result);

/// The file of the model that a result names. \param folder  the project's. \pre It is a model's result.
std::filesystem::path modelFileOf(const Result& model, const std::filesystem::path& folder);

/// What lies in the model's file rather than in a result: `components` (k × R, G, B of each used texel),
/// `warps` (k × x, y of each node) and `texels` (row · width + column of each used texel), of single
/// precision and no longer quantised. Cost: O(components · values), 200 MB for 33 Eigen textures of 1024² of
/// which half of the texels are used.
std::vector<DataArray> appearanceArrays(const AppearanceModel& model);

/// The table “completions” and the arrays of coefficients of a result, without its files.
Result completionsResult(std::span<const CompletedFrame> frames);

/// How appearance varies with poses: captured ones, the frames that have them, and by what scales
/// coefficients are regressed on them.
struct LearnedPoses
{
    PosePlaces places;
    std::vector<FrameAppearances::Key> frames; ///< of each place
    PoseScales scales;
};
/// \param unit  of positions.
Result posesResult(const LearnedPoses& poses, const std::string& unit);

/// The model of an entry and all textures that it knows, as they were computed last; nothing where there is
/// no model that can be read: clips are shown all the same, and a rebuild makes it anew. Poses are there
/// where the entry wants them and they are of frames that the model has.
/// \param folder  the project's.
std::optional<FrameAppearances> readAppearances(const std::filesystem::path& results,
                                                const std::filesystem::path& folder,
                                                const AppearanceEntry& entry);

} // namespace quadrille
