// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/animationtracks.h"

#include "editor/pictures/framepictures.h"
#include "editor/workspaces/animate/constraintedits.h"
#include "widgets/controls/elidedpair.h"
#include "widgets/theme/theme.h"
#include "widgets/timeline/framekind.h"

#include <QLocale>

namespace quadrille {

using widgets::ColorRole;
using widgets::Theme;
using widgets::TimelineSpan;
using widgets::TimelineTrack;

QString poseText(const std::string& sequence, FrameIndex frame)
{
    return QStringLiteral("%1 %2").arg(QString::fromStdString(sequence)).arg(frame.value);
}

QString choiceText(const FrameChoice& frames)
{
    if (!frames.label.empty())
        return QString::fromStdString(frames.label);
    const QString name = QString::fromStdString(frames.sequence);
    return frames.range ? QStringLiteral("%1 %2–%3")
                              .arg(name)
                              .arg(frames.range->first.value)
                              .arg(frames.range->last.value)
                        : name;
}

TimelineTrack AnimationTracks::keys(const std::vector<int>& ids, FramePictures& pictures) const
{
    TimelineTrack track;
    track.id = keyTrackId;
    track.title = tr("Keys");
    track.kind = TimelineTrack::Kind::Keys;
    track.editable = true;
    track.hint = tr("Drag the picture of a card here to ask for its pose at a time");
    const std::vector<KeyEntry> all = keysOf(entry);
    const auto obtained = obtainedFrames(all, result);
    for (std::size_t i = 0; i < all.size() && i < ids.size(); ++i) {
        widgets::TimelineKey key;
        key.id = ids[i];
        key.frame = all[i].time * fps;
        if (all[i].tolerance)
            key.tolerance = *all[i].tolerance * fps;
        if (obtained[i])
            if (const auto shown = shownRange(planned, {FrameIndex(*obtained[i]), FrameIndex(*obtained[i])}))
                key.obtained = static_cast<double>(shown->first.value);
        key.text = poseText(all[i].sequence, all[i].frame);
        key.picture = pictures.picture(QString::fromStdString(all[i].sequence), all[i].frame);
        track.keys.push_back(std::move(key));
    }
    return track;
}

QString AnimationTracks::variationText(const ClipPart& part) const
{
    for (FrameIndex f = part.frames.first; f <= part.frames.last; ++f.value) {
        const FrameProvenance& origin = result->origins[static_cast<std::size_t>(f.value)];
        if (!part.isJunction && origin.destinationVariation != 0)
            return QString::fromStdString(result->variationName(origin.destinationVariation));
    }
    return {};
}

QString AnimationTracks::partText(const ClipPart& part) const
{
    if (part.index < 0)
        return tr("Made afterwards");
    const CharacterGraph& graph = result->character->graph;
    const auto poseOf = [&](NodeIndex node) {
        const NamedFrame named = graph.nameOf(node);
        return poseText(named.sequence, named.frame);
    };
    if (part.isJunction) {
        const ClipPlan::Junction& junction = result->plan.junctions[static_cast<std::size_t>(part.index)];
        return tr("%1, cost %2", "a transition")
            .arg(widgets::pairText(poseOf(junction.frames.source), poseOf(junction.frames.destination)),
                 QLocale().toString(static_cast<double>(junction.cost), 'g', 3));
    }
    const auto originOf = [&](FrameIndex frame) {
        return graph.nameOf(result->origins[static_cast<std::size_t>(frame.value)].nearest());
    };
    const NamedFrame first = originOf(part.frames.first);
    const QString text = QStringLiteral("%1–%2")
                             .arg(poseText(first.sequence, first.frame))
                             .arg(originOf(part.frames.last).frame.value);
    const QString variation = variationText(part);
    return variation.isEmpty() ? text : tr("%1, drawn from %2", "frames, a variation").arg(text, variation);
}

TimelineTrack AnimationTracks::clip() const
{
    TimelineTrack track;
    track.id = clipTrackId;
    track.title = tr("Clip");
    track.kind = TimelineTrack::Kind::Clips;
    track.hint = tr("What is found is shown here");
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const ClipPart& part = parts[i];
        const widgets::FrameKind kind = part.isJunction                 ? widgets::FrameKind::Transition
                                        : variationText(part).isEmpty() ? widgets::FrameKind::Captured
                                                                        : widgets::FrameKind::Varied;
        track.spans.push_back({.id = static_cast<int>(i),
                               .first = static_cast<int>(part.frames.first.value),
                               .last = static_cast<int>(part.frames.last.value),
                               .text = partText(part),
                               .color = widgets::frameKindColor(kind),
                               .hatched = kind == widgets::FrameKind::Transition,
                               .dotted = kind == widgets::FrameKind::Varied});
    }
    // Short transitions lie above the captured frames beside them.
    std::stable_partition(track.spans.begin(), track.spans.end(),
                          [](const TimelineSpan& span) { return !span.hatched; });
    return track;
}

TimelineTrack AnimationTracks::actions() const
{
    TimelineTrack track;
    track.id = QStringLiteral("actions");
    track.title = tr("Actions");
    const std::vector<ActionEntry> all = actionsOf(entry);
    const auto obtained = obtainedRanges(all, result);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto shown = obtained[i] ? shownRange(planned, *obtained[i]) : std::nullopt;
        if (shown)
            track.spans.push_back({.id = static_cast<int>(i),
                                   .first = static_cast<int>(shown->first.value),
                                   .last = static_cast<int>(shown->last.value),
                                   .text = choiceText(all[i].frames),
                                   .color = Theme::color(ColorRole::Demanded)});
    }
    return track;
}

TimelineTrack AnimationTracks::demands() const
{
    TimelineTrack track;
    track.id = QStringLiteral("demands");
    track.title = tr("Path asks");
    if (result == nullptr)
        return track;
    std::vector<PathSpanEntry> asked;
    for (const ConstraintEntry& constraint : result->entry.constraints)
        if (const auto* path = std::get_if<PathEntry>(&constraint))
            asked.insert(asked.end(), path->spans.begin(), path->spans.end());
    const std::vector<FrameRange>& met = result->walk.solution.spans;
    for (std::size_t i = 0; i < std::min(asked.size(), met.size()); ++i) {
        const auto shown = shownRange(planned, met[i]);
        if (!shown)
            continue;
        const QString text = asked[i].frames     ? choiceText(*asked[i].frames)
                             : asked[i].duration ? tr("%1 s").arg(QLocale().toString(*asked[i].duration))
                                                 : QString();
        track.spans.push_back({.id = static_cast<int>(i),
                               .first = static_cast<int>(shown->first.value),
                               .last = static_cast<int>(shown->last.value),
                               .text = text,
                               .color = Theme::color(ColorRole::Demanded)});
    }
    return track;
}

} // namespace quadrille
