// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describeshared.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<ProjectionEntry>)
{
    using E = ProjectionEntry;
    f.about("projection", "A clip with textures from pictures of calibrated cameras.");
    f.name("name", &E::name);
    f.as(Role::Clip, "clip", &E::clip,
         {.help = "What cameras saw, frame by frame: a clip as “SECTION/NAME”.", .need = Need::Required});
    f.as(Role::File, "cameras", &E::cameras,
         {.help = "A table of the cameras and their pictures, JSON.", .need = Need::Required});
    f.field("camera_", &E::cameraAxes);
    f.field("size", &E::size,
            {.help = "Side of the textures, texels.",
             .need = Need::Always,
             .limits = Limits::between(16, 8192, "The size of textures must be from 16 to 8192 texels",
                                       "Write 1024, as usual.")});
    f.field(
        "sharpness", &E::sharpness,
        {.help = "How much more cameras count that see a surface from the front: the power of the cosine "
                 "of the angle of view.",
         .limits = Limits::between(0, 16, "The sharpness must be from 0 to 16", "Leave it out, as usual.")});
    f.field("fill", &E::fills,
            {.help = "Texels that no camera sees are filled from other frames, and else from their "
                     "neighbours; otherwise they are black."});
    f.unknown(&E::unknown);
}

} // namespace quadrille
