// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/core/mediacache.h"
#include "model/core/progress.h"
#include "model/render/camera.h"
#include "model/render/rendersettings.h"
#include "model/sequence/meshsequence.h"

#include <memory>
#include <optional>

namespace quadrille {

/// The box around frames of a sequence.
/// \param samples how many frames to look at, evenly spread over the sequence; all when it has fewer.
/// \throws Error as MeshSequence::frame, Cancelled.
Bounds boundsOf(const MeshSequence& sequence, std::int64_t samples = 24, const Progress& progress = {});

/// Draws frames of one sequence; keeps what frames share (normals' neighbours, scaled textures, the height of
/// the ground). Safe from any thread; the same bytes for any number of threads.
class FrameRenderer
{
public:
    /// \throws Error as MeshSequence::frame (a few frames are read to find the ground), BadArgument.
    FrameRenderer(MeshSequence sequence, const RenderOptions& options);
    ~FrameRenderer();
    FrameRenderer(const FrameRenderer&) = delete;
    FrameRenderer& operator=(const FrameRenderer&) = delete;

    const RenderOptions& options() const { return m_options; }
    /// \pre 0 ≤ frame < frameCount().
    /// \throws Error as MeshSequence::frame and MeshSequence::texture.
    Image render(FrameIndex frame, const Camera& camera) const;

private:
    struct Shared;
    MeshSequence m_sequence;
    RenderOptions m_options;
    std::unique_ptr<Shared> m_shared;
};

/// One frame as a picture of options.width × options.height.
/// \throws Error as FrameRenderer.
Image renderFrame(const MeshSequence& sequence, FrameIndex frame, const Camera& camera,
                  const RenderOptions& options = {});

} // namespace quadrille
