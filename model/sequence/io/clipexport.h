// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/sequence/io/files/format.h"

#include <functional>
#include <memory>

namespace quadrille {

/// Draws every frame of a clip, several at a time.
/// \param prepare what can be done with a picture beside others, on any thread: encoding, writing.
/// \param finish is given the pictures one after the other in frame order.
/// \throws Error what drawing and the two functions throw, Cancelled.
void drawClip(const MeshSequence& sequence, const RenderSettings& settings, const Progress& progress,
              const std::function<void(FrameIndex, Image&)>& prepare,
              const std::function<void(FrameIndex, const Image&)>& finish);

/// PNG pictures DIR/NAME_0000.png, …; the same bytes for any number of threads.
std::unique_ptr<Exporter> makePngExporter();
/// Video: H.264 with sound in `.mp4`, of an even width and height; Motion JPEG in `.avi`. The same bytes for
/// any number of threads.
std::unique_ptr<Exporter> makeVideoExporter();

} // namespace quadrille
