// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/core/progress.h"
#include "model/render/rendersettings.h"
#include "model/sequence/meshsequence.h"

#include <span>
#include <string>
#include <vector>

namespace quadrille {

struct ContactSheetOptions
{
    std::string title;         ///< over everything; no line when empty
    int framesPerSequence = 8; ///< at most, evenly spread from the first to the last
    int columns = 8;           ///< pictures side by side; more frames go on in the next row
    int cellWidth = 168;       ///< of a picture, in units of `scale` pixels
    int cellHeight = 224;
    double scale = 1; ///< pixels per unit: everything grows with it
    RenderOptions::Background background = RenderOptions::Background::Light;
    RenderOptions::Shading shading = RenderOptions::Shading::Textured;
    CoordinateSystem axes;
};

/// A rectangle of pixels.
struct SheetBox
{
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    bool operator==(const SheetBox&) const = default;
};

/// Where everything lies on a sheet.
struct ContactSheetLayout
{
    int width = 0;
    int height = 0;
    SheetBox title;
    std::vector<SheetBox> headings;           ///< one per sequence
    std::vector<std::vector<SheetBox>> cells; ///< per sequence its pictures
};

/// \param pictures how many each sequence has.
ContactSheetLayout layoutContactSheet(std::span<const int> pictures, const ContactSheetOptions& options);

/// One picture of several sequences: for each a heading with name, frames and duration, and its frames in
/// rows, with their numbers. A transparent background stays transparent.
/// \throws Error as FrameRenderer, BadArgument when there is no sequence or the sheet is too large,
/// Cancelled.
Image contactSheet(std::span<const MeshSequence> sequences, const ContactSheetOptions& options = {},
                   const Progress& progress = {});

} // namespace quadrille
