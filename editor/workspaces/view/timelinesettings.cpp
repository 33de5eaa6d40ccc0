// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/view/timelinesettings.h"

#include <QSettings>

namespace quadrille {

namespace {

using widgets::Timeline;
using widgets::TimelineRow;

constexpr auto backAndForthKey = "loopBackAndForth";

QString unitKey(const QString& timeline)
{
    return QStringLiteral("timelines/%1/seconds").arg(timeline);
}

QString rowsKey(const QString& timeline)
{
    return QStringLiteral("timelines/%1/rows").arg(timeline);
}

} // namespace

Timeline::Unit timelineUnit(const QString& timeline, Timeline::Unit usual)
{
    const QVariant seconds = QSettings().value(unitKey(timeline), usual == Timeline::Unit::Seconds);
    return seconds.toBool() ? Timeline::Unit::Seconds : Timeline::Unit::Frames;
}

void setTimelineUnit(const QString& timeline, Timeline::Unit unit)
{
    QSettings().setValue(unitKey(timeline), unit == Timeline::Unit::Seconds);
}

std::vector<TimelineRow> timelineRows(const QString& timeline)
{
    QSettings settings;
    std::vector<TimelineRow> rows;
    const int count = settings.beginReadArray(rowsKey(timeline));
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        rows.push_back({.track = settings.value("track").toString(),
                        .height = settings.value("height").toInt(),
                        .isFolded = settings.value("folded").toBool()});
    }
    return rows;
}

void setTimelineRows(const QString& timeline, const std::vector<TimelineRow>& rows)
{
    QSettings settings;
    settings.remove(rowsKey(timeline));
    settings.beginWriteArray(rowsKey(timeline), static_cast<int>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        settings.setArrayIndex(static_cast<int>(i));
        settings.setValue("track", rows[i].track);
        settings.setValue("height", rows[i].height);
        settings.setValue("folded", rows[i].isFolded);
    }
    settings.endArray();
}

bool playsBackAndForth()
{
    return QSettings().value(backAndForthKey).toBool();
}

void setPlaysBackAndForth(bool backAndForth)
{
    QSettings().setValue(backAndForthKey, backAndForth);
}

} // namespace quadrille
