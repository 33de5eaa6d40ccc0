// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

class QLocale;
class QPointF;

namespace quadrille::widgets {

class TimelineLayout;

/// What is to be said of what lies at a place of a timeline; empty for nothing.
QString timelineTip(const TimelineLayout& layout, const QPointF& position, const QLocale& locale);

} // namespace quadrille::widgets
