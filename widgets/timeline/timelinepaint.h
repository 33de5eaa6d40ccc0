// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

class QPainter;
class QPalette;
class QRect;

namespace quadrille::widgets {

class TimelineLayout;
struct TimelineDrag;
struct TimelineTrack;

// Timelines are painted with what is dragged where it would be, in colours of the theme.

/// Paints all of it. \param exposed  what has to be painted, at least.
void paintTimeline(QPainter& painter, const QRect& exposed, const TimelineLayout& layout,
                   const TimelineDrag& drag, const QPalette& palette, bool hasFocus);

/// Paints the row of a track with its title, spans and notes, but not the keys, which lie above what is
/// shaded. \param track  one of the layout's.
void paintTimelineRow(QPainter& painter, const TimelineLayout& layout, const TimelineDrag& drag,
                      const TimelineTrack& track, const QPalette& palette);

/// Paints marks and pictures of all keys, and their stems at the ruler.
void paintTimelineKeys(QPainter& painter, const TimelineLayout& layout, const TimelineDrag& drag);

/// Paints where what is held over the timeline would become a key.
void paintTimelineDrop(QPainter& painter, const TimelineLayout& layout);

} // namespace quadrille::widgets
