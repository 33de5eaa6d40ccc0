// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinekeyboard.h"

#include <algorithm>

namespace quadrille::widgets {

namespace {

int stepOf(int key)
{
    return key == Qt::Key_Left ? -1 : key == Qt::Key_Right ? 1 : 0;
}

bool asksForMove(Qt::KeyboardModifiers modifiers)
{
    return modifiers.testAnyFlags(Qt::ControlModifier | Qt::ShiftModifier);
}

} // namespace

bool TimelineKeyboard::comesFirst(int key, Qt::KeyboardModifiers modifiers) const
{
    return m_content.selected && ((stepOf(key) != 0 && asksForMove(modifiers)) || key == Qt::Key_Delete ||
                                  key == Qt::Key_Backspace || key == Qt::Key_F2);
}

bool TimelineKeyboard::press(int key, Qt::KeyboardModifiers modifiers)
{
    if (pressForSelected(key, modifiers))
        return true;
    switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
        emit scrubRequested(m_content.current + stepOf(key));
        return true;
    case Qt::Key_Home:
        emit scrubRequested(m_layout.range().first);
        return true;
    case Qt::Key_End:
        emit scrubRequested(m_layout.range().second);
        return true;
    case Qt::Key_Up:
        selectNeighbour(-1);
        return true;
    case Qt::Key_Down:
        selectNeighbour(1);
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        emit zoomRequested(1.25);
        return true;
    case Qt::Key_Minus:
        emit zoomRequested(0.8);
        return true;
    case Qt::Key_0:
        emit fitRequested();
        return true;
    case Qt::Key_I:
    case Qt::Key_O:
        setEndHere(key == Qt::Key_I);
        return true;
    case Qt::Key_Insert:
        create();
        return true;
    case Qt::Key_Escape:
        if (!m_content.selected)
            return false;
        emit selectRequested(std::nullopt);
        return true;
    default:
        return false;
    }
}

bool TimelineKeyboard::pressForSelected(int key, Qt::KeyboardModifiers modifiers)
{
    if (!m_content.selected || !m_content.exists(*m_content.selected))
        return false;
    if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_F2) {
        emit spanActivated(*m_content.selected);
        return true;
    }
    if (!m_content.track(m_content.selected->track)->editable)
        return false;
    if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
        emit spanDeletionRequested(*m_content.selected);
        return true;
    }
    if (stepOf(key) == 0 || !asksForMove(modifiers))
        return false;
    moveSelected(stepOf(key), modifiers);
    return true;
}

void TimelineKeyboard::moveSelected(int step, Qt::KeyboardModifiers modifiers)
{
    const SpanRef selected = *m_content.selected;
    const bool isWhole = modifiers.testFlag(Qt::ControlModifier);
    const int start = m_content.startOf(selected);
    if (m_content.key(selected) != nullptr) {
        constexpr int manyFrames = 10;
        const int frames = modifiers.testFlag(Qt::ShiftModifier) ? step * manyFrames : step;
        const int frame = std::clamp(start + frames, 0, m_layout.lastFrame());
        if (isWhole && frame != start)
            emit keyMoved(selected, frame, true);
        return;
    }
    const bool isNote = m_content.track(selected.track)->kind == TimelineTrack::Kind::Notes;
    const int first = isWhole || isNote ? start + step : start;
    const int last = m_content.span(selected)->last + step;
    if (first >= 0 && last >= first && last <= m_layout.lastFrame())
        emit spanEdited(selected, first, last, true);
}

void TimelineKeyboard::selectNeighbour(int step)
{
    std::vector<SpanRef> all;
    for (const TimelineTrack& track : m_content.tracks) {
        const auto begin = static_cast<std::ptrdiff_t>(all.size());
        for (const TimelineSpan& span : track.spans)
            all.push_back({track.id, span.id});
        for (const TimelineKey& key : track.keys)
            all.push_back({track.id, key.id});
        std::ranges::stable_sort(all.begin() + begin, all.end(), {},
                                 [this](const SpanRef& ref) { return m_content.startOf(ref); });
    }
    if (all.empty())
        return;
    const auto found =
        m_content.selected ? std::find(all.begin(), all.end(), *m_content.selected) : all.end();
    const auto count = static_cast<int>(all.size());
    const int next = found == all.end() ? (step > 0 ? 0 : count - 1)
                                        : (static_cast<int>(found - all.begin()) + step + count) % count;
    const SpanRef ref = all[static_cast<std::size_t>(next)];
    emit selectRequested(ref);
    emit revealRequested(m_content.startOf(ref));
}

/// Makes the playhead the first or last frame of the range, or where that is fixed of the loop.
void TimelineKeyboard::setEndHere(bool isStart)
{
    const int here = m_content.current;
    const bool isRange = m_content.isRangeEditable;
    auto [first, last] = isRange ? m_layout.range() : m_content.loop.value_or(m_layout.range());
    if (isStart)
        last = std::max(here, last);
    else
        first = std::min(first, here);
    (isStart ? first : last) = here;
    if (isRange)
        emit rangeEdited(first, last, true);
    else
        emit loopEdited(first, last, true);
}

void TimelineKeyboard::create()
{
    const auto track = std::ranges::find_if(m_content.tracks, [this](const TimelineTrack& each) {
        return each.editable && (!m_content.selected || m_content.selected->track == each.id);
    });
    if (track == m_content.tracks.end())
        return;
    constexpr int newSpanFrames = 10;
    const int first = m_content.current;
    const int last =
        track->holdsMoments() ? first : std::min(m_layout.lastFrame(), first + newSpanFrames - 1);
    emit spanCreated(track->id, first, last);
}

} // namespace quadrille::widgets

#include "moc_timelinekeyboard.cpp"
