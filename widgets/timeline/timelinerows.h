// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timelinetrack.h"

#include <vector>

namespace quadrille::widgets {

/// How high the rows of tracks are, pixels: as usual for their kind, or as the user wants them.
class TimelineRows
{
public:
    static constexpr int foldedHeight = 10;
    static constexpr int tallest = 200;
    static constexpr int keyMarkHeight = 16;
    static constexpr int keyPicture = 40; ///< as usual

    /// Rows that are not as usual; also of tracks that are not there now.
    void set(std::vector<TimelineRow> rows) { m_rows = std::move(rows); }
    const std::vector<TimelineRow>& all() const { return m_rows; }
    /// Changes what the user wants of a row, and forgets it where that is as usual.
    void edit(const TimelineRow& row);
    /// As usual where nothing else is known of it.
    TimelineRow of(const QString& track) const;

    static int usualHeight(const TimelineTrack& track);
    int heightOf(const TimelineTrack& track) const;

private:
    std::vector<TimelineRow> m_rows;
};

} // namespace quadrille::widgets
