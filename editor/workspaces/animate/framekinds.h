// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clip.h"
#include "widgets/timeline/framekind.h"

namespace quadrille {

/// What a frame of a clip is, as it is coloured everywhere.
inline widgets::FrameKind frameKindOf(const FrameProvenance& origin)
{
    return origin.isCaptured() ? widgets::FrameKind::Captured
           : origin.isSingle() ? widgets::FrameKind::Varied
                               : widgets::FrameKind::Transition;
}

} // namespace quadrille
