// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/render/rendersettings.h"
#include "model/sequence/meshsequence.h"

#include <QString>
#include <optional>

namespace quadrille {

class SceneView;

/// Where a view looks from at a clip, in the clip's own coordinates.
struct SeenCamera
{
    Camera camera;
    bool follows = false; ///< it goes along with the figure
    FrameIndex frame;     ///< that is shown meanwhile
};

/// The camera of a view; nothing where it does not show the clip.
/// \param name of the clip in its section.
std::optional<SeenCamera> seenCamera(SceneView& view, const QString& name, const MeshSequence& clip);

/// The camera of a film's first frame, so that the frame that was shown looks as it did: a camera that goes
/// along with the figure is taken back along its way. A fixed camera stays as it was seen; for others, frames
/// of the film are read.
/// \param film   the clip as it is written, cut and in the project's coordinates.
/// \param shown  the frame of the film that was shown; one outside of it is taken as its nearest end.
/// \throws Error as MeshSequence::frame, Cancelled.
Camera firstCamera(const SeenCamera& seen, CameraMode mode, const MeshSequence& film, std::int64_t shown,
                   UpAxis up, const Progress& progress = {});

} // namespace quadrille
