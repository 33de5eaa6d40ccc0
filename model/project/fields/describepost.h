// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describeshared.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<VariedRepeats>)
{
    using E = VariedRepeats;
    f.about("varied_repeats",
            "Frames that are shown again are drawn from variations of their take, each time another one.");
    f.reference("from", &E::from, NamedKind::Variation,
                {.help = "An entry of “variations”; all that vary a take.", .loss = Loss::OfOwner});
    f.field("ease", &E::ease,
            {.help = "Seconds from captured to varied poses and back.",
             .limits = Limits::from(0, "The time of the ease is below zero", "Write seconds.")});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<LoopSettings>)
{
    using E = LoopSettings;
    f.about("loop");
    f.field("cut_start", &E::cutStart,
            {.help = "At most, seconds; a third of the clip.",
             .limits = Limits::from(0, "The cut is below zero")});
    f.field("cut_end", &E::cutEnd,
            {.help = "At most, seconds; a third of the clip.",
             .limits = Limits::from(0, "The cut is below zero")});
    f.field("in_place", &E::inPlace, {.help = "Takes the way over the ground out."});
}

template <typename Fields>
void describe(Fields& f, Type<ContactCorrectionSettings>)
{
    using E = ContactCorrectionSettings;
    f.about("contact_correction");
    f.field("strength", &E::strength,
            {.help = "Share of the slip that is taken out.",
             .limits = Limits::between(0, 1, "The strength must be from 0 to 1")});
    f.field("ease", &E::easeSeconds,
            {.help = "Seconds before and after a contact.",
             .limits = Limits::from(0, "The time of the ease is below zero")});
    f.field(
        "greatest_shift", &E::greatestShift,
        {.help = "Of a foot, body heights.", .limits = Limits::from(0, "The greatest shift is below zero")});
    f.field("greatest_turn", &E::greatestTurn,
            {.help = "Of a foot, radians.", .limits = Limits::from(0, "The greatest turn is below zero")});
    f.field(
        "greatest_lift", &E::greatestLift,
        {.help = "Of a foot, body heights.", .limits = Limits::from(0, "The greatest lift is below zero")});
}

template <typename Fields>
void describe(Fields& f, Type<RetimeSettings>)
{
    using E = RetimeSettings;
    f.about("retime", "By a factor, to a duration, or along a curve of (shown, clip) times.");
    f.field("factor", itself);
    f.field("keep_root_speed", &E::keepsRootSpeed, {.help = "Over the ground as fast as before."});
}

template <typename Fields>
void describe(Fields& f, Type<PostProcessingEntry>)
{
    using E = PostProcessingEntry;
    using S = PostProcessing;
    f.about("post", "What is done to the clip, in this order.");
    f.step("variations", &E::variations);
    f.step("loop", at(&E::steps, &S::loop), {}, &E::unknownOfLoop);
    f.step("contact_correction", at(&E::steps, &S::contacts), {}, &E::unknownOfContacts);
    f.field("mirror", at(&E::steps, &S::mirror), {.help = "Exchanges left and right."});
    f.as(Role::File, "symmetry", &E::symmetry,
         {.help = "A file with the vertex opposite to each vertex; found where it is left out."});
    f.field("repeats", at(&E::steps, &S::repeats),
            {.help = "Of the loop.",
             .limits = Limits::from(1, "A loop is shown once at least").upTo(1000, "A loop", "repeats")});
    f.object("retime", at(&E::steps, &S::retime), {}, &E::unknownOfRetime);
    f.unknown(&E::unknown);
}

} // namespace quadrille
