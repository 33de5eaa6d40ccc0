// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describeshared.h"
#include "model/synthesis/walks/constraints.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<KeyEntry>)
{
    using E = KeyEntry;
    f.kind("key", "A pose that is shown at a time.");
    f.reference("sequence", &E::sequence, NamedKind::Sequence, {.need = Need::Required});
    f.field("frame", &E::frame,
            {.help = "Zero-based.",
             .need = Need::Required,
             .limits = Limits::from(0, "Frames are counted from 0")});
    f.field("time", &E::time,
            {.help = "Wanted; seconds from the start.",
             .need = Need::Required,
             .limits = limits::anHourFrom(
                 Limits::from(0, "The time of a key is below zero", "Write seconds from the start."))});
    f.field("tolerance", &E::tolerance,
            {.help = "Greatest error of the time, seconds.",
             .limits = Limits::from(0, "The tolerance is below zero")});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<PathSpanEntry>)
{
    using E = PathSpanEntry;
    f.about("path_span",
            "What is asked of a part of a path: frames of a label or a sequence, or how long it takes.");
    f.field("from", &E::from,
            {.help = "Length along the curve, in the project's unit.",
             .need = Need::Always,
             .limits = limits::length});
    f.field("to", &E::to,
            {.help = "Length along the curve, in the project's unit.",
             .need = Need::Required,
             .limits = limits::length});
    f.choice(&E::frames);
    f.field("duration", &E::duration, {.help = "Seconds.", .limits = limits::duration});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<ObstacleEntry>)
{
    f.about("obstacle", "A disc or a polygon on the ground.");
    f.field("centre", itself);
    f.unknown(&ObstacleEntry::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<PathEntry>)
{
    using E = PathEntry;
    f.kind("path", "A curve that the body's centre follows, over the ground or through space.");
    f.word("curve", &E::curve,
           words<PathCurve>({{"catmull-rom", PathCurve::CatmullRom},
                             {"polyline", PathCurve::Polyline},
                             {"bezier", PathCurve::Bezier}}),
           {.help =
                "Smoothly through all points; straight from point to point; or point, handle, handle, point, "
                "…."});
    f.field("points", itself, {.need = Need::Required});
    f.list("spans", &E::spans);
    f.list("obstacles", &E::obstacles);
    f.field("clearance", &E::clearance,
            {.help = "What the centre keeps from obstacles, in the project's unit.",
             .limits = Limits::from(0, "The clearance is below zero")});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<ActionEntry>)
{
    using E = ActionEntry;
    f.kind("action", "A movement that is performed.");
    f.choice(&E::frames, {.need = Need::Required});
    f.field("repeat", &E::repeat,
            {.help = "How often.",
             .limits =
                 Limits::from(1, "An action is performed once at least").upTo(1000, "An action", "repeats")});
    f.field("duration", &E::duration,
            {.help = "Instead of “repeat”: goes on with any of the frames; seconds.",
             .limits = limits::duration});
    f.field("least_share", &E::leastShare,
            {.help = "Of a span that must be played.",
             .limits = Limits::above(0, shareReason).upTo(1, {shareReason}),
             .fallback = Action().leastShare});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<FrameChoice>)
{
    f.about("frame_choice", "All frames with a label, or a sequence, or some frames of it.");
    f.choice(itself);
}

} // namespace quadrille
