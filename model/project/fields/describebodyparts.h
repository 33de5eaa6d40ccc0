// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describeshared.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<NamedFrame>)
{
    using E = NamedFrame;
    f.about("named_frame");
    f.reference("sequence", &E::sequence, NamedKind::Sequence,
                {.need = Need::Required, .isAnyOfProject = true});
    f.field("frame", &E::frame,
            {.help = "Zero-based.",
             .need = Need::Always,
             .limits = Limits::from(0, "Frames are counted from 0")});
}

template <typename Fields>
void describe(Fields& f, Type<PartCurveEntry>)
{
    using E = PartCurveEntry;
    f.about("part_curve");
    f.name("name", at(&E::curve, &PartCurve::name));
    f.field(
        "vertices", at(&E::curve, &PartCurve::vertices),
        {.help =
             "A closed curve of zero-based vertices of the character's mesh: each shares an edge with the "
             "next, the last with the first.",
         .need = Need::Required});
    f.field("points", &E::points,
            {.help = "The vertices that were chosen; the others lie on the way between them."});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<PartEntry>)
{
    using E = PartEntry;
    f.about("part");
    f.name("name", at(&E::part, &PartDescription::name));
    f.field("parent", at(&E::part, &PartDescription::parent));
    f.field("curves", at(&E::part, &PartDescription::curves),
            {.help = "The two curves that bound what the part shares with its parent.",
             .expected = "A name in quotes is expected here"});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<BodyPartsEntry>)
{
    using E = BodyPartsEntry;
    f.about("body_parts");
    f.as(Role::Character, "character", &E::character, {.help = ownCharacterHelp});
    f.object("pose", &E::pose,
             {.help = "The frame in which curves are drawn; the first of the character's first sequence."});
    f.list("curves", &E::curves, {.need = Need::Always});
    f.list(
        "parts", &E::parts,
        {.help = "A tree; the root has neither parent nor curves. Without any, the whole body is one part.",
         .need = Need::Always});
    f.unknown(&E::unknown);
}

} // namespace quadrille
