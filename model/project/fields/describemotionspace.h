// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describeshared.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<SpaceTakeEntry>)
{
    using E = SpaceTakeEntry;
    f.about("space_take", "A take of a motion space, and how it is performed.");
    f.reference("sequence", &E::sequence, NamedKind::Sequence, {.need = Need::Required});
    f.field("range", &E::range);
    f.field("mirrored", &E::isMirrored,
            {.help = "Left and right are exchanged; the character's mesh must be symmetric."});
    f.field("reversed", &E::isReversed, {.help = "It is played from its last frame to its first."});
    f.field("speed", &E::speed,
            {.help = "In which it is played: 1 is as it was captured.",
             .limits = Limits::between(0.1, 10, "The speed of a take must be from 0.1 to 10",
                                       "Write 1 for as it was captured.")});
    f.field("place", &E::place,
            {.help = "Where it lies on the axes, a value of each parameter; measured where it is left out."});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<SpaceParameterEntry>)
{
    using E = SpaceParameterEntry;
    f.about("space_parameter", "What the takes of a motion space differ in.");
    f.name("name", &E::name);
    f.word("measure", &E::measure,
           words<SpaceMeasure>({{"speed", SpaceMeasure::Speed},
                                {"turning", SpaceMeasure::Turning},
                                {"jump-height", SpaceMeasure::JumpHeight},
                                {"jump-length", SpaceMeasure::JumpLength},
                                {"height", SpaceMeasure::Height},
                                {"forward", SpaceMeasure::Forward},
                                {"side", SpaceMeasure::Side},
                                {"by-hand", SpaceMeasure::ByHand}}),
           {.help = "Speed over the ground, m/s; turning to the left, degrees a second; height and length of "
                    "a jump, m; how high a vertex is, how far before the body and how far to its left where "
                    "it is farthest from it, m; or places that all takes name.",
            .need = Need::Always});
    f.field("vertex", &E::vertex,
            {.help = "Of the character's mesh, zero-based: whose height, way forward or to the side it is.",
             .limits = Limits::from(0, "Vertices are counted from 0")});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<MotionSpaceEntry>)
{
    using E = MotionSpaceEntry;
    f.about("motion_space", "Takes of one kind of movement as one that parameters steer.");
    f.name("name", &E::name);
    f.as(Role::Character, "character", &E::character, {.help = ownCharacterHelp});
    f.list("takes", &E::takes,
           {.help = "One to eight, as “walk” or {\"sequence\": \"walk\", \"speed\": 1.2}.",
            .need = Need::Always,
            .loss = Loss::OfOwner,
            .shortKey = "sequence"});
    f.list("parameters", &E::parameters,
           {.help = "One to three that steer it; none with one take alone.", .need = Need::Always});
    f.reference("reference", &E::reference, NamedKind::Sequence,
                {.help = "The take whose frames are those of the space; the first."});
    f.field("cycles", &E::cycles, {.help = "Takes of locomotion are cut to one cycle."});
    f.field("tolerance", &E::tolerance,
            {.help = "By how much its blends may miss the non-linear ones at most, metres.",
             .limits = Limits::between(1e-5, 1, "The tolerance must be from 0.00001 to 1 metre",
                                       "Write 0.005, as usual.")});
    f.as(
        Role::Count, "most_references", &E::mostReferences,
        {.help = "Non-linear blends that are stored to keep the tolerance, at most; 0 for linear blends.",
         .limits = limits::count.upTo(1000, {"There are more than 1000 references", "Write 31, as usual."})});
    f.unknown(&E::unknown);
}

} // namespace quadrille
