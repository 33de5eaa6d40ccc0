// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describebodyparts.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<TransferEntry>)
{
    using E = TransferEntry;
    f.about("transfer", "A clip that another mesh performs.");
    f.name("name", &E::name);
    f.as(Role::Clip, "clip", &E::clip,
         {.help = "What is performed: a clip of the template as “SECTION/NAME”.", .need = Need::Required});
    f.object(
        "target", &E::target,
        {.help = "The mesh that performs it, in a frame of a sequence of its own.", .need = Need::Required});
    f.object("reference", &E::reference,
             {.help = "The frame of the template whose pose is the target's; where it is left out the most "
                      "alike of the template's takes and mesh."});
    f.field("pairs", &E::pairs);
    f.word("field", &E::field,
           words<FieldKind>({{"quaternions", FieldKind::Quaternions}, {"logarithms", FieldKind::Logarithms}}),
           {.help = "What of the marked triangles' rotations is spread over the target: quaternions, as "
                    "published, or logarithms, which turn evenly where a part turns far."});
    f.field("scale", &E::scale,
            {.help = "Of the way over the ground and of heights above it; what the target's steps ask for "
                     "where it is left out.",
             .limits = Limits::between(0.01, 100, "The scale of a transfer must be from 0.01 to 100",
                                       "Leave it out, as usual.")});
    f.field("pose_correction", &E::correctsPose,
            {.help = "Limbs that the target holds otherwise than the template does in the reference pose are "
                     "brought there first: the arms of a scan in A- or T-pose. Else the difference stays."});
    f.field("stretch", &E::carriesStretch,
            {.help =
                 "How the template's skin stretches and is pressed together about each pair is carried as "
                 "well, so that bends keep more of their volume. Else rotations only, as published."});
    f.field("surroundings", &E::marksSurroundings,
            {.help = "Each pair stands for what lies about it, some 8 cm on a grown-up and less where pairs "
                     "are dense: bends stay where they are, however fine the target is. Else single "
                     "triangles, as published."});
    f.field("contact_correction", &E::correctsContacts,
            {.help = "Feet that stand in the clip stand still in the result as well."});
    f.as(Role::Clip, "truth", &E::truth,
         {.help = "What the result ought to be, where it is known: a clip of the target's mesh as "
                  "“SECTION/NAME”, with as many frames as the clip. The result does not depend on it; the "
                  "evaluation “transfer-error” compares them."});
    f.unknown(&E::unknown);
}

} // namespace quadrille
