// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QImage>
#include <QString>
#include <optional>
#include <vector>

namespace quadrille::widgets {

/// Frames first … last, both included, with a name.
struct TimelineSpan
{
    int id = 0; ///< the caller's, unique in its track
    int first = 0;
    int last = 0;
    QString text;
    QColor color;
    bool hatched = false; ///< for synthetic frames, so that colour is not the only sign
    bool dotted = false;  ///< for frames that were drawn as variations, likewise
    bool operator==(const TimelineSpan&) const = default;
};

/// A picture that is to be shown at a time. A frame is drawn in its middle, as the playhead is.
struct TimelineKey
{
    int id = 0;                      ///< the caller's, unique in its track
    double frame = 0;                ///< wanted
    std::optional<double> obtained;  ///< where the pose is really shown, once that is known
    std::optional<double> tolerance; ///< greatest error of the time, frames; any when empty
    QString text;                    ///< e.g. the pose's sequence and frame
    QImage picture;                  ///< square; may be null
    bool operator==(const TimelineKey&) const = default;
};

/// A row of spans, or of keys.
struct TimelineTrack
{
    enum class Kind
    {
        Labels,   ///< names of spans
        Contacts, ///< slim, one row per foot
        Clips,    ///< what a result is put together from
        Keys,     ///< pictures at moments
        Notes     ///< words at moments: spans of one frame
    };
    QString id; ///< the caller's, unique in the timeline
    QString title;
    Kind kind = Kind::Labels;
    bool editable = false;
    std::vector<TimelineSpan> spans;
    std::vector<TimelineKey> keys; ///< of tracks of this kind
    QString hint;                  ///< what belongs there, while it is empty
    /// Whether what is made there has one frame.
    bool holdsMoments() const { return kind == Kind::Keys || kind == Kind::Notes; }
    bool operator==(const TimelineTrack&) const = default;
};

/// How the user wants a row to be.
struct TimelineRow
{
    QString track;
    int height = 0; ///< pixels; 0: as usual
    bool isFolded = false;
    bool operator==(const TimelineRow&) const = default;
};

/// Names a span or a key by its track and its id.
struct SpanRef
{
    QString track;
    int span = 0;
    bool operator==(const SpanRef&) const = default;
};

} // namespace quadrille::widgets
