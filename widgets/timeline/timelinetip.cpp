// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinetip.h"

#include "widgets/timeline/timeline.h"
#include "widgets/timeline/timelinelayout.h"

#include <QLocale>

namespace quadrille::widgets {

namespace {

QString tipOf(const TimelineContent& content, const SpanRef& ref, const QLocale& locale)
{
    const auto seconds = [&](double frames) { return locale.toString(frames / content.fps, 'f', 2); };
    if (const TimelineKey* key = content.key(ref)) {
        QString tip = Timeline::tr("%1 at %2 s").arg(key->text, seconds(key->frame));
        if (key->obtained)
            tip +=
                QLatin1Char('\n') + Timeline::tr("Obtained at %1 s, %2 s off")
                                        .arg(seconds(*key->obtained), seconds(*key->obtained - key->frame));
        if (key->tolerance)
            tip += QLatin1Char('\n') + Timeline::tr("May be off by %1 s").arg(seconds(*key->tolerance));
        return tip;
    }
    const TimelineSpan& span = *content.span(ref);
    const TimelineTrack& track = *content.track(ref.track);
    if (track.kind == TimelineTrack::Kind::Notes)
        return Timeline::tr("%1\nFrame %2, %3 s").arg(span.text).arg(span.first).arg(seconds(span.first));
    return Timeline::tr("%1: frames %2 to %3 (%4 s)")
        .arg(span.text.isEmpty() ? track.title : span.text)
        .arg(span.first)
        .arg(span.last)
        .arg(seconds(span.last - span.first + 1));
}

} // namespace

QString timelineTip(const TimelineLayout& layout, const QPointF& position, const QLocale& locale)
{
    const TimelineContent& content = layout.content();
    if (const auto ref = layout.spanAt(position))
        return tipOf(content, *ref, locale);
    const TimelineGrip grip = layout.gripAt(position);
    if (grip.kind == TimelineGrip::Kind::RowEdge)
        return Timeline::tr("Drag to size the row; a double click makes it as usual");
    if (grip.kind == TimelineGrip::Kind::Title)
        return Timeline::tr("%1: a click folds the row, another unfolds it")
            .arg(content.track(grip.span.track)->title);
    return {};
}

} // namespace quadrille::widgets
