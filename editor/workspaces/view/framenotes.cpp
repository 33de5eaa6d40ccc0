// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/view/framenotes.h"

#include "editor/workspaces/view/sceneview.h"
#include "widgets/controls/inplaceedit.h"

#include <algorithm>

namespace quadrille {

using widgets::SpanRef;
using widgets::Timeline;
using widgets::TimelineTrack;

FrameNotes::FrameNotes(SceneView& view, Keeper keeper, QObject* parent)
    : QObject(parent), m_view(view), m_keeper(std::move(keeper))
{
    const Timeline& timeline = view.timeline();
    const auto isOurs = [this](const SpanRef& span) {
        return span.track == trackId && span.span < static_cast<int>(notes().size());
    };
    connect(&timeline, &Timeline::spanCreated, this, [this](const QString& track, int frame, int) {
        if (track == trackId && isThere())
            write(frame);
    });
    connect(&timeline, &Timeline::spanEdited, this,
            [this, isOurs](const SpanRef& span, int first, int, bool committed) {
                if (!isOurs(span))
                    return;
                std::vector<FrameNote> all = notes();
                all[static_cast<std::size_t>(span.span)].frame =
                    FrameIndex(std::max(0, first - m_keeper.firstFrame()));
                // The order is that of the frames once the note has arrived: until then it keeps its number.
                if (committed)
                    m_keeper.keep(std::move(all), EditPhase::Final);
            });
    connect(&timeline, &Timeline::spanActivated, this, [this, isOurs](const SpanRef& span) {
        if (isOurs(span))
            edit(span.span);
    });
    connect(&timeline, &Timeline::spanDeletionRequested, this, [this, isOurs](const SpanRef& span) {
        if (isOurs(span))
            remove(span.span);
    });
    connect(&timeline, &Timeline::selectionChanged, this, [this, isOurs](const std::optional<SpanRef>& span) {
        if (span && isOurs(*span))
            goTo(span->span);
    });
}

TimelineTrack FrameNotes::track() const
{
    TimelineTrack track{trackId, tr("Notes"), TimelineTrack::Kind::Notes, true, {}};
    track.hint = tr("Double-click to write something about a frame");
    const std::vector<FrameNote> all = notes();
    for (std::size_t i = 0; i < all.size(); ++i)
        track.spans.push_back({.id = static_cast<int>(i),
                               .first = frameOf(all[i]),
                               .last = frameOf(all[i]),
                               .text = QString::fromStdString(all[i].text),
                               .color = {}});
    return track;
}

void FrameNotes::openField(const QString& text, const QRect& place,
                           const std::function<void(const QString&)>& take)
{
    delete m_field;
    m_field = new widgets::InPlaceEdit(text, m_view.timeline());
    m_field->setObjectName(QStringLiteral("noteText"));
    m_field->setAccessibleName(tr("Note"));
    m_field->setPlaceholderText(tr("Note on this frame"));
    connect(m_field, &widgets::InPlaceEdit::accepted, this, take);
    constexpr int width = 260; // a note is a sentence
    m_field->begin(QRect(place.topLeft(), QSize(width, place.height())));
}

void FrameNotes::write(int frame)
{
    const std::vector<FrameNote> all = notes();
    const auto there =
        std::ranges::find_if(all, [&](const FrameNote& note) { return frameOf(note) == frame; });
    if (there != all.end()) {
        edit(static_cast<int>(there - all.begin()));
        return;
    }
    if (!isThere() || frame < m_keeper.firstFrame())
        return;
    m_view.timeline().setFolded(trackId, false);
    const QRect row = m_view.timeline().trackRect(trackId);
    const QRect place(m_view.timeline().xOfFrame(frame), row.top(), row.width(), row.height());
    openField({}, place, [this, frame](const QString& text) {
        std::vector<FrameNote> edited = notes();
        edited.push_back(
            {.frame = FrameIndex(frame - m_keeper.firstFrame()), .text = text.toStdString(), .unknown = {}});
        m_keeper.keep(std::move(edited), EditPhase::Final);
    });
}

void FrameNotes::edit(int note)
{
    const FrameNote before = notes().at(static_cast<std::size_t>(note));
    const QRect place = m_view.timeline().spanRect({trackId, note});
    openField(QString::fromStdString(before.text), place, [this, before](const QString& text) {
        std::vector<FrameNote> edited = notes();
        const auto there = std::ranges::find(edited, before);
        if (there == edited.end())
            return;
        there->text = text.toStdString();
        m_keeper.keep(std::move(edited), EditPhase::Final);
    });
}

void FrameNotes::remove(int note)
{
    std::vector<FrameNote> edited = notes();
    edited.erase(edited.begin() + note);
    m_keeper.keep(std::move(edited), EditPhase::Final);
}

void FrameNotes::goTo(int note)
{
    const int frame = frameOf(notes().at(static_cast<std::size_t>(note)));
    m_view.player().goTo(frame);
    m_view.setPlayhead(frame);
}

void FrameNotes::goToNeighbour(int step)
{
    const std::vector<FrameNote> all = notes();
    const int here = m_view.timeline().currentFrame();
    const auto before =
        std::ranges::count_if(all, [&](const FrameNote& note) { return frameOf(note) < here; });
    const auto upTo =
        std::ranges::count_if(all, [&](const FrameNote& note) { return frameOf(note) <= here; });
    const auto next = step > 0 ? upTo : before - 1;
    if (next >= 0 && next < static_cast<std::ptrdiff_t>(all.size()))
        goTo(static_cast<int>(next));
}

} // namespace quadrille

#include "moc_framenotes.cpp"
