// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timelinetrack.h"

#include <QObject>
#include <QPointF>

namespace quadrille::widgets {

/// What the user wants of a timeline, said by whatever understands mouse or keys. Those that have the name of
/// a signal of Timeline mean the same.
class TimelineIntents : public QObject
{
    Q_OBJECT
signals:
    void scrubRequested(int frame);
    void scrubbingChanged(bool scrubbing);
    void selectRequested(const std::optional<quadrille::widgets::SpanRef>& span);
    void spanHovered(const std::optional<quadrille::widgets::SpanRef>& span);
    void rangeEdited(int first, int last, bool committed);
    void loopEdited(int first, int last, bool committed);
    void loopRemovalRequested();
    void spanCreated(const QString& track, int first, int last);
    void spanEdited(const quadrille::widgets::SpanRef& span, int first, int last, bool committed);
    void keyMoved(const quadrille::widgets::SpanRef& key, int frame, bool committed);
    void spanActivated(const quadrille::widgets::SpanRef& span);
    void spanDeletionRequested(const quadrille::widgets::SpanRef& span);
    /// To be folded, or unfolded.
    void foldRequested(const QString& track);
    void rowEdited(const quadrille::widgets::TimelineRow& row, bool committed);
    /// The first frame that is to show.
    void scrollRequested(double first);
    void revealRequested(int frame);
    void zoomRequested(double factor);
    void fitRequested();
    /// A key is held at a place.
    void keyHeld(const QPointF& position);
    /// What is dragged would be elsewhere.
    void dragChanged();
    void dragEnded(bool committed);
};

} // namespace quadrille::widgets
