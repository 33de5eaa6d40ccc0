// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The ruler goes on while something is held at its end.
#include "widgets/timeline/timelineprivate.h"

#include <algorithm>

namespace quadrille::widgets {

namespace {

constexpr double reach = 28; ///< pixels before the end from which on it goes on

} // namespace

void Timeline::setGrowing(bool growing)
{
    d->grows = growing;
    if (!growing)
        stopGrowing();
}

/// Goes on as long as it is called with a place at the end, for the last time at about an hour.
void Timeline::growUnder(const QPointF& position)
{
    const bool isAtEnd = d->scale.firstVisible() + d->scale.visibleFrames() > d->scale.frameCount() - 1;
    const int mostFrames = static_cast<int>(3600 * d->fps);
    d->held = position;
    if (!d->grows || !isAtEnd || position.x() < width() - reach || d->scale.frameCount() >= mostFrames) {
        d->growing.stop();
        return;
    }
    if (!d->growing.isActive()) {
        d->growing.start();
        return;
    }
    if (d->framesBeforeGrowing == 0)
        d->framesBeforeGrowing = d->scale.frameCount();
    d->scale.setFrameCount(d->scale.frameCount() + std::max(1, d->scale.frameCount() / 100));
    d->scale.scrollTo(d->scale.frameCount());
    if (d->drag.kind == TimelineDrag::Kind::MoveKey) {
        if (d->dragTo(position, false))
            emit keyMoved(d->drag.span, d->drag.first, false);
    } else if (d->dropFrame) {
        d->dropFrame = d->frameForKey(position, false, std::nullopt);
    }
    scaleChanged();
}

/// What was held is gone: the frames that came for it go, too.
void Timeline::stopGrowing()
{
    d->growing.stop();
    if (d->framesBeforeGrowing == 0)
        return;
    d->scale.setFrameCount(std::exchange(d->framesBeforeGrowing, 0));
    d->current = std::min(d->current, d->scale.frameCount() - 1);
    scaleChanged();
}

} // namespace quadrille::widgets
