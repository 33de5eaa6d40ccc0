// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/animationtimeline.h"

#include "editor/context/editorcontext.h"
#include "editor/pictures/framepictures.h"
#include "editor/workspaces/animate/animationtracks.h"
#include "editor/workspaces/animate/constraintedits.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/view/framenotes.h"
#include "editor/workspaces/view/sceneview.h"
#include "editor/workspaces/view/timelineactions.h"
#include "widgets/theme/theme.h"

#include <QMenu>
#include <QScopedValueRollback>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace quadrille {

using widgets::SpanRef;
using widgets::Theme;
using widgets::Timeline;

namespace {

constexpr double leastSeconds = 10; ///< shown at least
constexpr double roomSeconds = 1;   ///< between the last key and one that is added behind it

/// How long the ruler is: keys are placed behind what is there, too.
double withRoom(double seconds)
{
    constexpr double leastRoom = 2;
    constexpr double share = 0.15;
    return std::max(leastSeconds, seconds + std::max(leastRoom, share * seconds));
}

int frameOf(double seconds, double fps)
{
    return static_cast<int>(std::lround(seconds * fps));
}

} // namespace

AnimationTimeline::AnimationTimeline(CurrentAnimation& animation, FramePictures& pictures, QObject* parent)
    : QObject(parent), m_animation(animation), m_pictures(pictures), m_timeline(animation.view().timeline())
{
    animation.view().setUsualUnit(Timeline::Unit::Seconds);
    // All of the clip is there; what plays of it is the loop.
    m_timeline.setRangeEditable(false);
    m_timeline.setGrowing(true);
    connect(&animation, &CurrentAnimation::changed, this, &AnimationTimeline::refresh);
    connect(&animation, &CurrentAnimation::resultChanged, this, &AnimationTimeline::followResult);
    connect(&animation.view(), &SceneView::sceneChanged, this, &AnimationTimeline::followResult);
    connect(&pictures, &FramePictures::drawn, this, &AnimationTimeline::refreshTracks);
    connect(&Theme::instance(), &Theme::changed, this, &AnimationTimeline::refreshTracks);
    connect(&animation.context().languages, &LanguageManager::changed, this,
            &AnimationTimeline::refreshTracks);
    connect(&m_timeline, &Timeline::frameScrubbed, this, &AnimationTimeline::keepPlayhead);
    connect(&m_timeline, &Timeline::keyMoved, this, [this](const SpanRef& key, int frame, bool committed) {
        moveKey(key.span, frame, committed ? EditPhase::Final : EditPhase::Dragging);
    });
    connect(&m_timeline, &Timeline::framesDropped, this,
            [this](const QString&, int frame, const widgets::DraggedFrames& frames) {
                addKey({frames.sequence.toStdString(), FrameIndex(frames.frame)}, frame / fps());
            });
    connect(&m_timeline, &Timeline::spanCreated, this, [this](const QString& track, int frame, int) {
        if (track == keyTrackId)
            createKeyHere(frame);
    });
    connect(&m_timeline, &Timeline::spanDeletionRequested, this, [this](const SpanRef& span) {
        if (const auto key = keyOf(span))
            removeKey(*key);
    });
    connect(&m_timeline, &Timeline::spanActivated, this, [this](const SpanRef& span) {
        if (const auto key = keyOf(span))
            emit keyActivated(*key);
        else if (const int junction = junctionOf(span); junction >= 0)
            emit junctionActivated(junction);
    });
    connect(&m_timeline, &Timeline::selectionChanged, this, &AnimationTimeline::take);
    connect(&m_timeline, &Timeline::spanHovered, this,
            [this](const std::optional<SpanRef>& span) { emit junctionHovered(junctionOf(span)); });
    connect(&m_timeline, &Timeline::contextMenuRequested, this,
            [this](const QString& track, const std::optional<SpanRef>& span, int frame,
                   const QPoint& position) { showMenu(track, span, frame, position); });
    refresh();
}

double AnimationTimeline::fps() const
{
    return m_animation.context().document.project().settings.fps;
}

int AnimationTimeline::shownFrames() const
{
    return static_cast<int>(m_planned.size());
}

void AnimationTimeline::followResult()
{
    const auto result = m_animation.result();
    if (result != m_result) {
        m_result = result;
        m_planned = result == nullptr ? std::vector<std::int64_t>() : plannedFrames(*result);
        m_parts = result == nullptr ? std::vector<ClipPart>() : clipParts(*result, m_planned);
    }
    refresh();
}

void AnimationTimeline::refresh()
{
    const AnimationEntry* entry = m_animation.entry();
    const bool isOther = m_shown != m_animation.name();
    if (isOther) {
        m_shown = m_animation.name();
        m_keyIds.clear();
        m_dragBase.reset();
    }
    double last = shownFrames() / fps();
    const std::vector<KeyEntry> keys = entry == nullptr ? std::vector<KeyEntry>() : keysOf(*entry);
    for (const KeyEntry& key : keys)
        last = std::max(last, key.time);
    // A length that changes under a drag would move the frames away from the pointer.
    if (!m_dragBase)
        m_timeline.setFrameCount(entry == nullptr ? 0 : frameOf(withRoom(last), fps()));
    else if (frameOf(last, fps()) >= m_timeline.frameCount())
        m_timeline.setFrameCount(frameOf(last, fps()) + 1);
    m_timeline.setRange(shownFrames() > 0 ? std::optional(std::pair(0, shownFrames() - 1)) : std::nullopt);
    if (m_keyIds.size() != keys.size()) {
        m_keyIds.resize(keys.size());
        std::iota(m_keyIds.begin(), m_keyIds.end(), 0);
    }
    refreshTracks();
    if (!isOther)
        return;
    // The playhead may have stood behind the end of the animation before.
    m_animation.view().setPlayhead(static_cast<int>(m_animation.view().player().frame().value));
    m_timeline.zoomToFit();
}

void AnimationTimeline::refreshTracks()
{
    // Without an animation the rows keep their room: the view must not shrink under the pen that begins one.
    const AnimationEntry none;
    const AnimationEntry* entry = m_animation.entry();
    const AnimationTracks tracks{entry == nullptr ? none : *entry, m_result.get(), m_planned, m_parts, fps()};
    std::vector<widgets::TimelineTrack> all{tracks.keys(m_keyIds, m_pictures), tracks.clip()};
    for (widgets::TimelineTrack& track : std::vector{tracks.actions(), tracks.demands()})
        if (!track.spans.empty())
            all.push_back(std::move(track));
    if (m_notes != nullptr)
        all.push_back(m_notes->track());
    for (widgets::TimelineTrack& track : all)
        track.editable = track.editable && entry != nullptr;
    if (all != m_timeline.tracks())
        m_timeline.setTracks(std::move(all));
    m_timeline.setDropTrack(entry == nullptr ? QString() : QString(keyTrackId));
}

void AnimationTimeline::setNotes(FrameNotes& notes)
{
    m_notes = &notes;
    refreshTracks();
}

void AnimationTimeline::keepPlayhead(int frame)
{
    // The player stops at the clip's end; keys may be placed behind it.
    if (frame >= shownFrames())
        m_animation.view().setPlayhead(frame);
}

void AnimationTimeline::addKey(const NamedFrame& pose)
{
    const AnimationEntry* entry = m_animation.entry();
    const std::vector<KeyEntry> keys = entry == nullptr ? std::vector<KeyEntry>() : keysOf(*entry);
    const double here = m_timeline.currentFrame() / fps();
    const bool isFree = freeKeyTime(keys, here, fps()) == here;
    addKey(pose, isFree ? here : keys.back().time + roomSeconds);
}

void AnimationTimeline::addKey(const NamedFrame& pose, double time)
{
    int added = 0;
    m_animation.edit(tr("Add key"), QStringLiteral("keys"), [&](AnimationEntry& entry) {
        std::vector<KeyEntry> keys = keysOf(entry);
        KeyEntry key{.sequence = pose.sequence, .frame = pose.frame};
        key.time = freeKeyTime(keys, time, fps());
        added = static_cast<int>(
            std::ranges::count_if(keys, [&](const KeyEntry& other) { return other.time < key.time; }));
        keys.push_back(std::move(key));
        setKeys(entry, std::move(keys));
    });
    selectKey(added);
    emit keySelected(added);
}

void AnimationTimeline::removeKey(int key)
{
    const AnimationEntry* entry = m_animation.entry();
    if (entry == nullptr || key < 0 || key >= static_cast<int>(keysOf(*entry).size()))
        return;
    m_animation.edit(tr("Remove key"), QStringLiteral("keys"), [&](AnimationEntry& edited) {
        std::vector<KeyEntry> keys = keysOf(edited);
        keys.erase(keys.begin() + key);
        setKeys(edited, std::move(keys));
    });
}

void AnimationTimeline::moveKey(int id, int frame, EditPhase phase)
{
    if (m_animation.entry() == nullptr)
        return;
    if (!m_dragBase) {
        const auto place = std::ranges::find(m_keyIds, id);
        if (place == m_keyIds.end())
            return;
        m_dragBase = *m_animation.entry();
        m_dragged = static_cast<int>(place - m_keyIds.begin());
    }
    std::vector<KeyEntry> others = keysOf(*m_dragBase);
    if (m_dragged >= static_cast<int>(others.size()))
        return;
    KeyEntry moved = others[static_cast<std::size_t>(m_dragged)];
    others.erase(others.begin() + m_dragged);
    // A drag that comes back leaves a time that is not of a frame as it was.
    if (frame != frameOf(moved.time, fps()))
        moved.time = freeKeyTime(others, frame / fps(), fps());
    const auto at =
        std::ranges::count_if(others, [&](const KeyEntry& other) { return other.time < moved.time; });
    std::vector<int> ids = m_keyIds;
    std::erase(ids, id);
    ids.insert(ids.begin() + at, id);
    others.insert(others.begin() + at, std::move(moved));
    m_keyIds = std::move(ids);
    m_animation.edit(
        tr("Move key"), QStringLiteral("keys.time"),
        [&](AnimationEntry& edited) { setKeys(edited, std::move(others)); }, phase);
    if (phase == EditPhase::Final) {
        m_dragBase.reset();
        refresh();
    }
}

int AnimationTimeline::frameOfKey(int key) const
{
    const std::vector<KeyEntry> keys = keysOf(*m_animation.entry());
    const auto index = static_cast<std::size_t>(key);
    if (const auto obtained = obtainedFrames(keys, m_result.get())[index])
        if (const auto shown = shownRange(m_planned, {FrameIndex(*obtained), FrameIndex(*obtained)}))
            return static_cast<int>(shown->first.value);
    return frameOf(keys[index].time, fps());
}

void AnimationTimeline::goToKey(int key)
{
    const AnimationEntry* entry = m_animation.entry();
    if (entry != nullptr && key >= 0 && key < static_cast<int>(keysOf(*entry).size()))
        goTo(frameOfKey(key));
}

void AnimationTimeline::goToPlanned(const FrameRange& frames)
{
    if (const auto shown = shownRange(m_planned, frames))
        goTo(static_cast<int>(shown->first.value));
}

void AnimationTimeline::goTo(int frame)
{
    m_animation.view().player().goTo(frame);
    m_animation.view().setPlayhead(frame);
}

void AnimationTimeline::selectKey(int key)
{
    const QScopedValueRollback taking(m_isTaking, true);
    if (key >= 0 && key < static_cast<int>(m_keyIds.size()))
        m_timeline.setSelectedSpan(SpanRef{keyTrackId, m_keyIds[static_cast<std::size_t>(key)]});
    else if (m_timeline.selectedSpan() && m_timeline.selectedSpan()->track == keyTrackId)
        m_timeline.setSelectedSpan(std::nullopt);
}

void AnimationTimeline::selectJunction(int junction)
{
    const QScopedValueRollback taking(m_isTaking, true);
    const auto part = std::ranges::find_if(
        m_parts, [&](const ClipPart& each) { return each.isJunction && each.index == junction; });
    if (junction >= 0 && part != m_parts.end())
        m_timeline.setSelectedSpan(SpanRef{clipTrackId, static_cast<int>(part - m_parts.begin())});
    else if (junctionOf(m_timeline.selectedSpan()) >= 0)
        m_timeline.setSelectedSpan(std::nullopt);
}

std::optional<int> AnimationTimeline::keyOf(const SpanRef& span) const
{
    const auto place = std::ranges::find(m_keyIds, span.span);
    if (span.track != keyTrackId || place == m_keyIds.end())
        return std::nullopt;
    return static_cast<int>(place - m_keyIds.begin());
}

int AnimationTimeline::junctionOf(const std::optional<SpanRef>& span) const
{
    if (!span || span->track != clipTrackId || span->span >= static_cast<int>(m_parts.size()))
        return -1;
    const ClipPart& part = m_parts[static_cast<std::size_t>(span->span)];
    return part.isJunction ? part.index : -1;
}

void AnimationTimeline::take(const std::optional<SpanRef>& selected)
{
    if (m_isTaking)
        return;
    emit keySelected(selected ? keyOf(*selected).value_or(-1) : -1);
    emit junctionSelected(junctionOf(selected));
}

/// Insert and double clicks: the pose that is shown now.
void AnimationTimeline::createKeyHere(int frame)
{
    m_animation.view().setPlayhead(frame);
    m_animation.context().actions.action(QStringLiteral("animate.addKey"))->trigger();
}

void AnimationTimeline::showMenu(const QString& track, const std::optional<SpanRef>& span, int frame,
                                 const QPoint& position)
{
    if (m_animation.entry() == nullptr)
        return;
    QMenu menu(&m_timeline);
    menu.setObjectName(QStringLiteral("animationTimelineMenu"));
    const auto key = span ? keyOf(*span) : std::nullopt;
    const int junction = junctionOf(span);
    if (key) {
        menu.addAction(tr("Go to key"), this, [&] { goToKey(*key); });
        menu.addAction(tr("Edit key"), this, [&] { emit keyActivated(*key); });
        menu.addAction(tr("Remove key"), this, [&] { removeKey(*key); });
    } else if (junction >= 0) {
        menu.addAction(tr("Inspect transition"), this, [&] { emit junctionActivated(junction); });
    } else if (span && span->track == FrameNotes::trackId) {
        menu.addAction(tr("Edit note"), this, [&] { m_notes->edit(span->span); });
        menu.addAction(tr("Remove note"), this, [&] { m_notes->remove(span->span); });
    } else {
        menu.addAction(tr("Add the shown pose as key here"), this, [&] { createKeyHere(frame); });
    }
    addTimelineMenu(menu, m_animation.view(), m_animation.context(), track, frame);
    menu.exec(position);
}

} // namespace quadrille

#include "moc_animationtimeline.cpp"
