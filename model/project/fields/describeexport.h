// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describeshared.h"
#include "model/render/rendersettings.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<Camera>)
{
    using E = Camera;
    f.about("view", "Where the camera stands at the first frame; without it the figure is framed.");
    f.field("eye", &E::eye);
    f.field("target", &E::target);
    f.field("up", &E::up);
    f.field("fov", &E::verticalFovDegrees,
            {.help = "Vertical, degrees.",
             .need = Need::Always,
             .limits = Limits::between(1, 170, nullptr),
             .expected = "a number from 1.0 to 170.0"});
}

/// The “picture” of an export.
template <typename Fields>
void describe(Fields& f, Type<RenderSettings>)
{
    using E = RenderSettings;
    using Look = RenderOptions;
    f.about("picture", "How pictures and videos look.");
    const FieldInfo side{.help = "Pixels.",
                         .need = Need::Always,
                         .limits = Limits::between(1, 16384, nullptr),
                         .expected = "a number of pixels from 1 to 16384"};
    f.field("width", at(&E::look, &Look::width), side);
    f.field("height", at(&E::look, &Look::height), side);
    f.word("shading", at(&E::look, &Look::shading),
           words<Look::Shading>({{"textured", Look::Shading::Textured},
                                 {"flat", Look::Shading::Flat},
                                 {"clay", Look::Shading::Clay},
                                 {"wireframe", Look::Shading::Wireframe}}),
           {.need = Need::Always});
    f.word("background", at(&E::look, &Look::background),
           words<Look::Background>({{"light", Look::Background::Light},
                                    {"dark", Look::Background::Dark},
                                    {"transparent", Look::Background::Transparent}}),
           {.need = Need::Always});
    f.field("grid", at(&E::look, &Look::grid),
            {.help = "Draw the ground with lines one metre apart.", .need = Need::Always});
    f.word("camera", &E::camera,
           words<CameraMode>({{"turntable", CameraMode::Turntable},
                              {"fixed", CameraMode::Fixed},
                              {"follow", CameraMode::Follow}}),
           {.help = "turntable: follows the figure and turns around it; fixed: sees the whole clip; follow: "
                    "keeps its "
                    "distance.",
            .need = Need::Always});
    f.field("revolutions", &E::revolutions,
            {.help = "Of the turntable over the clip.",
             .need = Need::Always,
             .limits = Limits::between(-1000, 1000, nullptr),
             .expected = "a number from -1000.0 to 1000.0"});
    f.object("view", &E::view);
}

template <typename Fields>
void describe(Fields& f, Type<ExportEntry>)
{
    using E = ExportEntry;
    f.about("export");
    f.name("name", &E::name);
    f.as(Role::Clip, "what", &E::what,
         {.help = "A clip, as “sequences/NAME”, “animations/NAME” or “variations/NAME/3”; all of "
                  "“variations/NAME” as a data set.",
          .need = Need::Required});
    f.as(Role::Output, "path", &E::path,
         {.help = "The file to write; its ending gives the format unless “format” does.",
          .need = Need::Required});
    f.field("format", &E::format, {.help = "The format's id, as “obj”."});
    f.field("range", &E::range);
    f.field("fps", &E::fps, {.help = frameRateHelp, .limits = limits::frameRate});
    f.field("", &E::axes);
    f.field("textures", &E::textures, {.help = "Write textures too."});
    f.field("picture", itself);
    f.unknown(&E::unknown);
}

} // namespace quadrille
