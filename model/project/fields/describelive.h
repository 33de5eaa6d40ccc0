// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describemotionspace.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<LiveEntry>)
{
    using E = LiveEntry;
    f.about("live", "A performance that was steered live: what was wanted at each tick.");
    f.name("name", &E::name);
    f.reference("spaces", &E::spaces, NamedKind::MotionSpace,
                {.help = "Motion spaces of one character.", .need = Need::Required, .loss = Loss::OfOwner});
    f.field("inputs", &E::inputs);
    f.as(Role::Count, "ticks", &E::ticks, {.help = "Of the performance.", .need = Need::Always});
    f.as(Role::Count, "from", &E::from, {.help = "The tick of the clip's first frame."});
    f.field("ticks_per_frame", &E::ticksPerFrame,
            {.help = "The clip has a frame after each of so many ticks.",
             .limits = Limits::between(1, 100, "The ticks of a frame must be from 1 to 100",
                                       "Write 2, as usual.")});
    f.field("position", &E::position);
    f.field("heading", &E::heading, {.help = "Where it looks first, degrees to the left."});
    f.field("depth", &E::depth,
            {.help = "How many frames ahead a transition is looked for, in either space.",
             .limits = Limits::between(0, 100, "The depth must be from 0 to 100 frames",
                                       "Write 12, as published.")});
    f.field(
        "latency_weight", &E::latencyWeight,
        {.help = "What a frame of waiting costs, against dissimilarities from 0 to 1000.",
         .limits = Limits::above(0, "The weight of latency must be above zero", "Write 5, as published.")});
    f.field("responsive_weight", &E::responsiveWeight,
            {.help = "The same where latency counts more than likeness.",
             .limits = Limits::above(0, "The weight of latency must be above zero", "Write 40, as usual.")});
    f.field("fade", &E::fadeSeconds,
            {.help = "Seconds in which one space takes over from another.",
             .limits = Limits::above(0, "A fade takes a time").upTo(5, "A fade", "seconds")});
    f.field("across", &E::secondsAcross,
            {.help = "Seconds in which a parameter may go over all of its range.",
             .limits = Limits::above(0, "Going over a range takes a time").upTo(60, "It", "seconds")});
    f.field("contact_correction", &E::correctsContacts,
            {.help = "Feet that stand in the takes stand still."});
    f.unknown(&E::unknown);
}

} // namespace quadrille
