// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describeanimation.h"
#include "model/project/fields/describeappearance.h"
#include "model/project/fields/describeexport.h"
#include "model/project/fields/describegraph.h"
#include "model/project/fields/describelive.h"
#include "model/project/fields/describemotionspace.h"
#include "model/project/fields/describeprojection.h"
#include "model/project/fields/describetransfer.h"
#include "model/project/fields/describevariation.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<ProjectSettings>)
{
    using E = ProjectSettings;
    f.about("settings");
    f.field("fps", &E::fps, {.help = frameRateHelp, .need = Need::Always, .limits = limits::frameRate});
    f.field("", &E::axes);
    f.field("cache_megabytes", &E::cacheMegabytes,
            {.help = "Frames and textures kept in memory.",
             .need = Need::Always,
             .limits = Limits::between(1, 1e9, ""),
             .expected = "a positive number of megabytes"});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<CharacterEntry>)
{
    using E = CharacterEntry;
    f.about("character");
    f.name("name", &E::name);
    f.as(Role::File, "mesh", &E::mesh, {.help = "The mesh that gives faces and UVs."});
    f.field("texture", &E::texture);
    f.field("notes", &E::notes);
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<SequenceEntry>)
{
    using E = SequenceEntry;
    f.about("sequence");
    f.name("name", &E::name);
    f.as(Role::Character, "character", &E::character,
         {.help = "Whose performance it is; may be left out with one character."});
    f.as(Role::Source, "source", &E::source,
         {.help = "A file, a folder or pattern of a numbered series, or “clip:SECTION/NAME”.",
          .need = Need::Required});
    f.field("clip", &E::clip, {.help = "One animation clip of a scene file."});
    f.field("range", &E::range);
    f.field("source_fps", &E::sourceFps, {.help = frameRateHelp, .limits = limits::frameRate});
    f.field("source_", &E::sourceAxes);
    f.field("texture", &E::texture);
    f.spans("labels", &E::labels, "label", &LabelSpan::label, &E::unknownOfSpans,
            "A name for some frames of the sequence.");
    f.spans("contacts", &E::contacts, "foot", &ContactSpan::foot, &E::unknownOfSpans,
            "A foot stands on the ground during these frames.");
    f.as(Role::File, "joint_angles", &E::jointAngles,
         {.help = "A BVH file with reference joint angles, for evaluation."});
    f.field("notes", &E::unknown);
    f.unknown(&E::unknown);
}

/// The sections of the file, in their order.
template <typename Fields>
void describe(Fields& f, Type<Project>)
{
    using E = Project;
    f.constant("format", "quadrille-project");
    f.constant("version", Project::currentVersion);
    f.object("settings", &E::settings, {.need = Need::Always});
    f.list("characters", &E::characters, {.need = Need::Always});
    f.list("sequences", &E::sequences, {.need = Need::Always});
    f.perCharacter("body_parts", &E::bodyParts,
                   {.help = "The parts of each character's body; with one character without a list, too."});
    f.perCharacter(
        "graph", &E::graphs,
        {.help = "Transitions and graphs of each character; with one character without a list, too."});
    f.list("animations", &E::animations);
    f.list("variations", &E::variations);
    f.list("motion_spaces", &E::motionSpaces,
           {.help =
                "Takes of one kind of movement that parameters steer; those of one character are compared, "
                "so that one goes over to another."});
    f.list("live", &E::lives, {.help = "Performances that were steered live."});
    f.list("appearance", &E::appearances,
           {.help = "Models of the textures of characters; clips of a character take the first of its own."});
    f.list("transfers", &E::transfers, {.help = "Clips that other meshes perform."});
    f.list("projections", &E::projections,
           {.help = "Clips with textures from pictures of calibrated cameras."});
    f.list("evaluations", &E::evaluations,
           {.help = "Which of the papers' tables to compute, as “fig7” or {\"table\": \"fig7\", …}.",
            .shortKey = "table"});
    f.list("exports", &E::exports, {.need = Need::Always});
    f.unknown(&E::unknown);
}

} // namespace quadrille
