// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timeline.h"

namespace quadrille {

// How the user wants timelines to be, on this computer, in every project. Each timeline goes by the object
// name of its widget.

/// \param usual  what counts as long as the user has not chosen.
widgets::Timeline::Unit timelineUnit(const QString& timeline, widgets::Timeline::Unit usual);
void setTimelineUnit(const QString& timeline, widgets::Timeline::Unit unit);
/// Rows that are sized or folded.
std::vector<widgets::TimelineRow> timelineRows(const QString& timeline);
void setTimelineRows(const QString& timeline, const std::vector<widgets::TimelineRow>& rows);
/// Whether what loops turns round at its ends.
bool playsBackAndForth();
void setPlaysBackAndForth(bool backAndForth);

} // namespace quadrille
