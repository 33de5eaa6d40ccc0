// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describeconstraint.h"
#include "model/project/fields/describepost.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<SearchEntry>)
{
    using E = SearchEntry;
    static const SearchSettings usual = searchSettings({}, 1);
    f.about("search", "How a walk is sought.");
    f.field("budget", &E::budget,
            {.help = "Expansions; of style “paper” 100,000 where it is left out.",
             .limits = Limits::from(1, "The budget must be one expansion at least")
                           .upTo(1e9, "The budget of the search", "expansions"),
             .fallback = usual.budget});
    f.field("beta", &E::beta,
            {.help = "Cost of a frame of timing error; ten times the graph's alpha.",
             .limits = Limits::from(0, "Beta is below zero")});
    f.field("mu", &E::mu,
            {.help = "Weight of the edges against squared metres of deviation.",
             .limits = Limits::from(0, "Mu is below zero"),
             .fallback = usual.mu});
    f.field("global", &E::globalKeys, {.help = "All keys in one search, not from key to key."});
    f.word("style", &E::isPaper, words<bool>({{"calm", false}, {"paper", true}}),
           {.help =
                "“calm”: takes are played for a while, deviation from a path counts by the metre, and takes "
                "of locomotion are preferred; “paper”: costs as published."});
    f.field("dwell", &E::dwell,
            {.help = "Least time between two transitions of a calm walk along a path or through actions, "
                     "seconds.",
             .limits = Limits::from(0, "The least time in a take is below zero")
                           .upTo(60, "The time in a take", "seconds"),
             .fallback = usualDwell});
    f.field("dead_zone", &E::deadZone,
            {.help = "Metres off a path that cost a calm walk nothing.",
             .limits = Limits::from(0, "The dead zone is below zero").upTo(100, "The dead zone", "metres"),
             .fallback = usual.charging.deadZone});
    f.field(
        "steering", &E::steering,
        {.help = "How far the way of a calm walk turns towards its path at most, beyond what was captured, "
                 "degrees a metre, and one and a half times as much in a second; 0: not at all.",
         .limits = Limits::from(0, "The steering is below zero").upTo(360, "The steering", "degrees a metre"),
         .fallback = usualSteering});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<WalkSpanEntry>)
{
    using E = WalkSpanEntry;
    f.about("walk_span", "Frames of a walk that are played as captured.");
    f.reference("sequence", &E::sequence, NamedKind::Sequence, {.need = Need::Required});
    f.field("frames", &E::frames, {.need = Need::Required});
}

template <typename Fields>
void describe(Fields& f, Type<JunctionsEntry>)
{
    using E = JunctionsEntry;
    f.about("junctions");
    f.field("banned", &E::banned, {.help = "Never used."});
    f.field("locked", &E::locked, {.help = "Kept from an accepted walk."});
    f.field("chosen", &E::chosen, {.help = "Chosen by hand; used."});
    f.list("walk", &E::walk,
           {.help =
                "The walk that these were decided on: each decision changes a transition of it, and the next "
                "one before or behind it where it must; everything else stays. Left out: a walk is sought "
                "anew with all decisions.",
            .loss = Loss::OfWhole});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<WalkEntry>)
{
    using E = WalkEntry;
    f.about("walk", "An accepted or hand-written walk; used as it is.");
    f.list("spans", &E::spans, {.need = Need::Always, .loss = Loss::OfWhole, .leastItems = 1});
    f.field("turn", &E::turn, {.help = "Of the first frame about the up axis, degrees."});
    f.field("at", &E::at);
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<AudioEntry>)
{
    using E = AudioEntry;
    f.about("audio", "A sound that is heard with the animation, and written into its videos.");
    f.as(Role::File, "file", &E::file, {.help = "WAV, FLAC, AIFF, Ogg or MP3.", .need = Need::Required});
    f.field("offset", &E::offset,
            {.help = "When it begins, seconds from the start; below zero: its beginning is not heard."});
    f.field("gain", &E::gain,
            {.help = "Decibels.",
             .limits = Limits::between(-100, 40, "The gain must be from -100 to 40 decibels")});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<CameraKeyEntry>)
{
    using E = CameraKeyEntry;
    f.about("camera_key", "Where the camera stands at a time.");
    f.field("time", at(&E::key, &CameraKey::time),
            {.help = "Seconds from the start.",
             .need = Need::Required,
             .limits = limits::anHourFrom(Limits::from(0, "The time of a camera key is below zero",
                                                       "Write seconds from the start."))});
    f.field("target", at(&E::key, &CameraKey::target), {.need = Need::Required});
    f.field("distance", at(&E::key, &CameraKey::distance),
            {.help = "From the target.",
             .need = Need::Required,
             .limits = Limits::above(0, "The distance of a camera must be above zero")});
    f.field("azimuth", at(&E::key, &CameraKey::azimuth),
            {.help = "Degrees around the target; 0 is in front of a figure that faces the viewer, 90 on the "
                     "right.",
             .need = Need::Always});
    f.field("elevation", at(&E::key, &CameraKey::elevation),
            {.help = "Degrees above the horizon.",
             .need = Need::Always,
             .limits = Limits::between(-90, 90, "The elevation must be from -90 to 90 degrees")});
    f.field("fov", at(&E::key, &CameraKey::fieldOfView),
            {.help = "Vertical, degrees.",
             .need = Need::Always,
             .limits = Limits::between(1, 170, "The field of view must be from 1 to 170 degrees")});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<AnimationEntry>)
{
    using E = AnimationEntry;
    f.about("animation");
    f.name("name", &E::name);
    f.as(Role::Character, "character", &E::character, {.help = ownCharacterHelp});
    f.object("start", &E::start);
    f.variants("constraints", &E::constraints);
    f.object("search", &E::search);
    f.object("junctions", &E::junctions);
    f.object("walk", &E::walk);
    f.word("interpolation", &E::interpolation,
           words<InterpolationMethod>({{"poisson", InterpolationMethod::Poisson},
                                       {"slerp", InterpolationMethod::Slerp},
                                       {"linear", InterpolationMethod::Linear}}),
           {.help = "How poses are blended."});
    f.word("blend", &E::gentleBlend, words<bool>({{"paper", false}, {"gentle", true}}),
           {.help = "How transitions are timed and placed: “gentle”, where the speed of both takes changes "
                    "smoothly and standing feet stay, or “paper”."});
    f.object("post", &E::post);
    f.object("audio", &E::audio);
    f.list("camera", &E::camera,
           {.help = "Where the camera of pictures and videos stands, in the order of the times."});
    f.field("notes", &E::unknown);
    f.unknown(&E::unknown);
}

} // namespace quadrille
