// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What the view shows, and the strip below it: two frames, or the clip of a transition.
#include "editor/context/editorcontext.h"
#include "editor/workspaces/graph/framenames.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "editor/workspaces/graph/graphworkspace.h"
#include "editor/workspaces/graph/pairpreview.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/theme.h"

#include <utility>

namespace quadrille {

namespace {

/// Captured, blended, captured, as the timeline shows them.
std::vector<widgets::TimelineSpan> spansOf(const TransitionClip& clip, const GraphExplorer& explorer)
{
    using widgets::ColorRole;
    using widgets::Theme;
    const auto last = static_cast<int>(clip.sequence.frameCount()) - 1;
    const auto first = static_cast<int>(clip.first);
    const auto arrival = static_cast<int>(clip.last);
    std::vector<widgets::TimelineSpan> spans{
        {0, 0, first, frameName(explorer, clip.frames.source), Theme::color(ColorRole::Original), false}};
    if (arrival > first + 1)
        spans.push_back({1, first + 1, arrival - 1, GraphWorkspace::tr("blended"),
                         Theme::color(ColorRole::Synthetic), true});
    if (arrival > first)
        spans.push_back({2, arrival, last, frameName(explorer, clip.frames.destination),
                         Theme::color(ColorRole::Original), false});
    return spans;
}

} // namespace

void GraphWorkspace::hover(const std::optional<FramePair>& pair)
{
    m_hovered = pair;
    showReadOut();
    const bool isClip = scene().shown() == QStringList{PairPreview::clipName()};
    if (!pair) {
        m_dwell.stop();
        if (m_preview->clip() != nullptr && !isClip && m_preview->clip()->frames == m_chosen)
            showClip();
    } else if (!isClip) {
        showFrames(*pair);
    } else if (pair != m_chosen) {
        m_dwell.start();
    }
}

void GraphWorkspace::showFrames(const FramePair& pair)
{
    player().pause();
    m_view->message().clear();
    m_preview->showFrames(pair);
    showStrip({});
    m_view->show({PairPreview::sourceName(), PairPreview::destinationName()});
    showState();
}

/// The strip keeps its place while there is no clip, so that nothing moves when one comes.
void GraphWorkspace::showStrip(std::vector<widgets::TimelineSpan> spans)
{
    widgets::TimelineTrack track;
    track.id = QStringLiteral("transition");
    track.title = tr("Transition");
    track.kind = widgets::TimelineTrack::Kind::Clips;
    track.spans = std::move(spans);
    track.hint = tr("Of what the transition is made");
    m_view->timeline().setTracks({std::move(track)});
}

void GraphWorkspace::showClip()
{
    const TransitionClip* clip = m_preview->clip();
    if (clip == nullptr)
        return;
    const QString name = PairPreview::clipName();
    showStrip(spansOf(*clip, *m_explorer));
    m_view->show({name});
    scene().update(name);
    player().goToStart();
    player().play();
    showState();
}

} // namespace quadrille
