// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/appearancemodel.h"
#include "model/core/writeguard.h"

#include <filesystem>

namespace quadrille {

/// Writes a model as one HDF5 file, whole or not at all. The same model gives the same bytes.
///
/// The first 512 bytes hold a text: what it is, its length, and a hash of the rest (see fileseal.h). The root
/// has an attribute `format` ("quadrille-appearance"), each dataset `description` and `unit`: `atlas` (width,
/// height, charts), `texels`, `charts`, `covered`; `mean`, `mean-step`, `components`, `component-scales`,
/// `eigenvalues`, `coefficients` of textures; `grid` (spacing, width, height), and `warp-mean`,
/// `warp-mean-step`, `warps`, `warp-scales`, `warp-eigenvalues`, `warp-coefficients`; `frame-sequences`,
/// `frames`. Components are blocks × components × values of a block, see QuantisedSpace. \param guard decides
/// whether it may be put there; null for files of the program's own. \throws Error WriteFailed,
/// PermissionDenied, and what WriteGuard::put throws.
void writeAppearanceFile(const std::filesystem::path& file, const AppearanceModel& model,
                         WriteGuard* guard = nullptr);

/// \throws Error FileNotFound, PermissionDenied, ReadFailed, FileEmpty, FileTruncated; FileSyntax where it is
/// another file or a damaged one, also when the hash differs.
AppearanceModel readAppearanceFile(const std::filesystem::path& file);

} // namespace quadrille
