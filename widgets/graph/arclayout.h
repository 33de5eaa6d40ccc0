// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QRectF>
#include <vector>

namespace quadrille::widgets {

/// An edge from one frame to another.
struct Arc
{
    int from = 0;
    int to = 0;
    float weight = 0; ///< of several that look the same the one of the least is shown
    bool operator==(const Arc&) const = default;
};

/// Arcs that look the same on the screen.
struct ArcBundle
{
    Arc lightest;
    int count = 1;
};

/// Joins arcs of which both ends fall into the same `framesEach` frames. Of the bundles the lightest are
/// kept, for every pair of sequences as many, until there are `most` in all.
/// \param starts  the first frame of each sequence, and the end of the last.
/// \return sorted by source, then destination.
std::vector<ArcBundle> bundleArcs(const std::vector<Arc>& arcs, const std::vector<int>& starts,
                                  int framesEach, int most);

/// Half an ellipse on a line between two points.
struct ArcCurve
{
    double from = 0; ///< x of the ends
    double to = 0;
    double base = 0;   ///< y of the ends
    double height = 0; ///< of the top above the base; below where negative

    QRectF ellipse() const;
    /// About how far a point is from the curve, in pixels.
    double distance(const QPointF& point) const;
};

} // namespace quadrille::widgets
