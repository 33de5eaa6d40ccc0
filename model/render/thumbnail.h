// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/core/progress.h"
#include "model/render/rendersettings.h"
#include "model/sequence/meshsequence.h"

#include <vector>

namespace quadrille {

/// How small pictures are drawn: three samples per pixel and direction.
/// \param width, height in device pixels.
RenderOptions thumbnailLook(int width, int height, RenderOptions::Background background,
                            const CoordinateSystem& axes = {});

/// The picture that stands for a sequence: the frame a third into it, the figure filling the picture.
/// \throws Error as FrameRenderer.
Image thumbnail(const MeshSequence& sequence, const RenderOptions& look);

/// Pictures for an animated thumbnail, evenly spread so that they can be looped; the camera goes along with
/// the figure and keeps its distance.
/// \param count at most; fewer where the sequence has fewer frames.
/// \throws Error as FrameRenderer, Cancelled.
std::vector<Image> thumbnailStrip(const MeshSequence& sequence, int count, const RenderOptions& look,
                                  const Progress& progress = {});

/// `count` frames (at most all) from the first to the last, evenly spread.
std::vector<FrameIndex> evenFrames(std::int64_t frameCount, int count);

/// A camera for each of some frames: all at the same distance and angle, moved along with the figure.
/// \throws Error as MeshSequence::frame.
std::vector<Camera> figureCameras(const MeshSequence& sequence, const std::vector<FrameIndex>& frames,
                                  const RenderOptions& look);

} // namespace quadrille
