// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/sequences/sequencetimeline.h"

#include "editor/commands/projectedits.h"
#include "editor/documents/labelcolors.h"
#include "editor/workspaces/sequences/knownlabels.h"
#include "editor/workspaces/sequences/labeltakes.h"
#include "editor/workspaces/view/framenotes.h"
#include "widgets/controls/inplaceedit.h"
#include "widgets/theme/theme.h"

#include <QCompleter>
#include <QMenu>

namespace quadrille {

namespace {

using widgets::SpanRef;
using widgets::Theme;
using widgets::Timeline;
using widgets::TimelineTrack;

constexpr auto labelTrack = QLatin1String("labels");
constexpr auto contactPrefix = QLatin1String("contacts/");
constexpr int newSpanFrames = 10;

EditPhase phaseOf(bool committed)
{
    return committed ? EditPhase::Final : EditPhase::Dragging;
}

std::vector<std::string> feetOf(const SequenceEntry& entry)
{
    std::vector<std::string> feet{"left", "right"};
    for (const ContactSpan& contact : entry.contacts) {
        if (std::ranges::find(feet, contact.foot) == feet.end())
            feet.push_back(contact.foot);
    }
    return feet;
}

} // namespace

SequenceTimeline::SequenceTimeline(Timeline& timeline, ProjectDocument& document, SequenceMedia& media,
                                   QObject* parent)
    : QObject(parent), m_timeline(timeline), m_document(document), m_media(media)
{
    timeline.setRangeEditable(true);
    connect(&document, &ProjectDocument::renamed, this, [this](const ChangeEvent& event) {
        if (event.entry.section == Section::Sequences && event.before == m_sequence)
            m_sequence = event.entry.name;
    });
    connect(&document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.touches(Section::Sequences) || event.touches(Section::Project))
            refresh();
    });
    connect(&media, &SequenceMedia::changed, this, [this](const QString& name) {
        if (name == m_sequence)
            refresh();
    });
    connect(&LabelColors::of(document), &LabelColors::changed, this, &SequenceTimeline::refresh);
    connect(&Theme::instance(), &Theme::changed, this, &SequenceTimeline::refresh);
    connect(&timeline, &Timeline::rangeEdited, this, [this](int first, int last, bool committed) {
        setRange({FrameIndex(first), FrameIndex(last)}, committed);
    });
    connect(&timeline, &Timeline::spanCreated, this, &SequenceTimeline::createSpan);
    connect(&timeline, &Timeline::spanEdited, this, &SequenceTimeline::editSpan);
    connect(&timeline, &Timeline::spanActivated, this, [this](const SpanRef& span) { nameSpan(span); });
    connect(&timeline, &Timeline::spanDeletionRequested, this, &SequenceTimeline::deleteSpan);
    connect(&timeline, &Timeline::contextMenuRequested, this, &SequenceTimeline::showMenu);
}

SequenceTimeline::~SequenceTimeline() = default;

void SequenceTimeline::show(const QString& sequence, std::int64_t comparedFrames)
{
    const bool isOther = sequence != m_sequence || comparedFrames != m_comparedFrames;
    if (isOther)
        delete m_nameField;
    m_sequence = sequence;
    m_comparedFrames = comparedFrames;
    refresh();
    if (isOther)
        m_timeline.zoomToFit();
}

void SequenceTimeline::refresh()
{
    const MeshSequence* untrimmed = m_media.untrimmed(m_sequence);
    const SequenceEntry* shown = entry();
    m_timeline.setFps(m_document.project().settings.fps);
    if (m_comparedFrames > 0) {
        m_timeline.setFrameCount(static_cast<int>(m_comparedFrames));
        m_timeline.setRange(std::nullopt);
        m_timeline.setTracks({});
    } else if (untrimmed == nullptr || shown == nullptr) {
        m_timeline.setFrameCount(0);
        m_timeline.setTracks({});
    } else {
        const bool isOtherLength = m_timeline.frameCount() != untrimmed->frameCount();
        m_timeline.setFrameCount(static_cast<int>(untrimmed->frameCount()));
        const FrameRange used = m_media.usedFrames(m_sequence);
        m_timeline.setRange(std::pair{static_cast<int>(used.first.value), static_cast<int>(used.last.value)});
        m_timeline.setTracks(makeTracks(*shown));
        if (isOtherLength)
            m_timeline.zoomToFit();
    }
    emit rangeChanged();
}

std::vector<TimelineTrack> SequenceTimeline::makeTracks(const SequenceEntry& shown) const
{
    const auto offset = static_cast<int>(m_media.usedFrames(m_sequence).first.value);
    const auto makeSpan = [&](int id, FrameRange frames, const QString& text, const QColor& color) {
        return widgets::TimelineSpan{id, static_cast<int>(frames.first.value) + offset,
                                     static_cast<int>(frames.last.value) + offset, text, color};
    };
    std::vector<TimelineTrack> tracks;
    TimelineTrack track{labelTrack, tr("Labels"), TimelineTrack::Kind::Labels, true, {}};
    for (int i = 0; i < static_cast<int>(shown.labels.size()); ++i) {
        const LabelSpan& span = shown.labels[static_cast<std::size_t>(i)];
        const QString text = QString::fromStdString(span.label);
        track.spans.push_back(makeSpan(i, span.frames, text, LabelColors::of(m_document).color(text)));
    }
    tracks.push_back(std::move(track));
    for (const std::string& foot : feetOf(shown)) {
        const QString name = QString::fromStdString(foot);
        const QString title = foot == "left" ? tr("Left foot") : foot == "right" ? tr("Right foot") : name;
        TimelineTrack contacts{contactPrefix + name, title, TimelineTrack::Kind::Contacts, true, {}};
        for (int i = 0; i < static_cast<int>(shown.contacts.size()); ++i) {
            const ContactSpan& span = shown.contacts[static_cast<std::size_t>(i)];
            if (span.foot == foot)
                contacts.spans.push_back(makeSpan(i, span.frames, {}, LabelColors::contact(foot)));
        }
        tracks.push_back(std::move(contacts));
    }
    if (m_notes != nullptr)
        tracks.push_back(m_notes->track());
    return tracks;
}

FrameRange SequenceTimeline::toSequence(int first, int last) const
{
    const FrameRange used = m_media.usedFrames(m_sequence);
    const auto place = [&](int frame) {
        return FrameIndex(std::clamp<std::int64_t>(frame - used.first.value, 0, used.count() - 1));
    };
    return {place(first), place(last)};
}

void SequenceTimeline::setRange(FrameRange used, bool committed)
{
    if (entry() == nullptr || m_comparedFrames > 0)
        return;
    if (!m_dragBase)
        m_dragBase = *entry();
    const SequenceEntry base = *m_dragBase;
    if (committed)
        m_dragBase.reset();
    setSequenceRange(m_document, m_sequence, m_media.sourceRange(m_sequence, used), phaseOf(committed),
                     &base);
}

void SequenceTimeline::trimStartHere()
{
    const FrameRange used = m_media.usedFrames(m_sequence);
    const FrameIndex here(m_timeline.currentFrame());
    if (used.count() > 0)
        setRange({here, std::max(here, used.last)}, true);
}

void SequenceTimeline::trimEndHere()
{
    const FrameRange used = m_media.usedFrames(m_sequence);
    const FrameIndex here(m_timeline.currentFrame());
    if (used.count() > 0)
        setRange({std::min(here, used.first), here}, true);
}

void SequenceTimeline::removeTrim()
{
    if (const MeshSequence* untrimmed = m_media.untrimmed(m_sequence))
        setRange(FrameRange::all(untrimmed->frameCount()), true);
}

void SequenceTimeline::createSpan(const QString& track, int first, int last)
{
    const SequenceEntry* shown = entry();
    if (shown == nullptr || m_comparedFrames > 0 || m_media.usedFrames(m_sequence).count() == 0)
        return;
    if (track == labelTrack) {
        auto labels = shown->labels;
        labels.push_back({proposedLabel(m_sequence).toStdString(), toSequence(first, last)});
        const SpanRef span{labelTrack, static_cast<int>(labels.size()) - 1};
        // Making and naming it is one edit, which Escape takes back.
        setSequenceLabels(m_document, m_sequence, std::move(labels), EditPhase::Dragging);
        m_timeline.setSelectedSpan(span);
        nameSpan(span, EditPhase::Dragging);
        connect(m_nameField, &widgets::InPlaceEdit::ended, this,
                [this, frames = toSequence(first, last), sequence = m_sequence](bool leaves) {
                    const SequenceEntry* named = m_document.sequence(sequence);
                    if (named == nullptr || named->labels.empty() || named->labels.back().frames != frames)
                        return;
                    auto all = named->labels;
                    if (leaves)
                        all.pop_back();
                    setSequenceLabels(m_document, sequence, std::move(all));
                });
    } else if (track.startsWith(contactPrefix)) {
        auto contacts = shown->contacts;
        contacts.push_back({track.mid(contactPrefix.size()).toStdString(), toSequence(first, last)});
        const SpanRef span{track, static_cast<int>(contacts.size()) - 1};
        setSequenceContacts(m_document, m_sequence, std::move(contacts));
        m_timeline.setSelectedSpan(span);
    }
}

void SequenceTimeline::addLabel()
{
    const int first = m_timeline.currentFrame();
    createSpan(labelTrack, first, std::min(first + newSpanFrames - 1, m_timeline.frameCount() - 1));
}

void SequenceTimeline::addContact(const QString& foot)
{
    const int first = m_timeline.currentFrame();
    createSpan(contactPrefix + foot, first, std::min(first + newSpanFrames - 1, m_timeline.frameCount() - 1));
}

void SequenceTimeline::editSpan(const SpanRef& span, int first, int last, bool committed)
{
    const SequenceEntry* shown = entry();
    const auto index = static_cast<std::size_t>(span.span);
    if (shown == nullptr)
        return;
    if (span.track == labelTrack && index < shown->labels.size()) {
        auto labels = shown->labels;
        labels[index].frames = toSequence(first, last);
        setSequenceLabels(m_document, m_sequence, std::move(labels), phaseOf(committed));
    } else if (span.track.startsWith(contactPrefix) && index < shown->contacts.size()) {
        auto contacts = shown->contacts;
        contacts[index].frames = toSequence(first, last);
        setSequenceContacts(m_document, m_sequence, std::move(contacts), phaseOf(committed));
    }
}

void SequenceTimeline::deleteSpan(const SpanRef& span)
{
    const SequenceEntry* shown = entry();
    const auto index = static_cast<std::size_t>(span.span);
    if (shown == nullptr)
        return;
    if (span.track == labelTrack && index < shown->labels.size()) {
        auto labels = shown->labels;
        labels.erase(labels.begin() + span.span);
        setSequenceLabels(m_document, m_sequence, std::move(labels));
    } else if (span.track.startsWith(contactPrefix) && index < shown->contacts.size()) {
        auto contacts = shown->contacts;
        contacts.erase(contacts.begin() + span.span);
        setSequenceContacts(m_document, m_sequence, std::move(contacts));
    }
}

void SequenceTimeline::nameSpan(const SpanRef& span, EditPhase phase)
{
    const SequenceEntry* shown = entry();
    const auto index = static_cast<std::size_t>(span.span);
    if (span.track != labelTrack || shown == nullptr || index >= shown->labels.size())
        return;
    delete m_nameField;
    const LabelSpan label = shown->labels[index];
    m_nameField = new widgets::InPlaceEdit(QString::fromStdString(label.label), m_timeline);
    m_nameField->setObjectName(QStringLiteral("labelName"));
    m_nameField->setAccessibleName(tr("Name of the label"));
    m_nameField->setCompleter(new QCompleter(knownLabels(m_document.project()), m_nameField));
    connect(m_nameField, &widgets::InPlaceEdit::accepted, this,
            [this, label, index, phase, sequence = m_sequence](const QString& text) {
                // Meanwhile it may have gone, or have another number.
                const SequenceEntry* named = m_document.sequence(sequence);
                if (named == nullptr)
                    return;
                auto labels = named->labels;
                const bool isThere = index < labels.size() && labels[index] == label;
                const auto place = isThere ? labels.begin() + static_cast<std::ptrdiff_t>(index)
                                           : std::ranges::find(labels, label);
                if (place == labels.end())
                    return;
                place->label = text.toStdString();
                setSequenceLabels(m_document, sequence, std::move(labels), phase);
            });
    m_nameField->begin(m_timeline.spanRect(span));
}

void SequenceTimeline::showMenu(const QString& track, const std::optional<SpanRef>& span, int frame,
                                const QPoint& position)
{
    if (entry() == nullptr || m_comparedFrames > 0)
        return;
    QMenu menu(&m_timeline);
    if (span) {
        const bool isLabel = span->track == labelTrack;
        if (isLabel || span->track == FrameNotes::trackId)
            menu.addAction(isLabel ? tr("Rename label") : tr("Edit note"), this,
                           [&] { emit m_timeline.spanActivated(*span); });
        menu.addAction(tr("Remove"), this, [&] { emit m_timeline.spanDeletionRequested(*span); });
        menu.addSeparator();
    } else if (!track.isEmpty() && track != FrameNotes::trackId) {
        const int last = std::min(frame + newSpanFrames - 1, m_timeline.frameCount() - 1);
        menu.addAction(track == labelTrack ? tr("Add label here") : tr("Add contact here"), this,
                       [&] { createSpan(track, frame, last); });
        menu.addSeparator();
    }
    const FrameRange used = m_media.usedFrames(m_sequence);
    menu.addAction(tr("Trim start to frame %1").arg(frame), this, [&] {
        setRange({FrameIndex(frame), std::max(FrameIndex(frame), used.last)}, true);
    });
    menu.addAction(tr("Trim end to frame %1").arg(frame), this, [&] {
        setRange({std::min(FrameIndex(frame), used.first), FrameIndex(frame)}, true);
    });
    menu.addAction(tr("Use all frames"), this, &SequenceTimeline::removeTrim);
    emit menuOpened(&menu, track, frame);
    menu.exec(position);
}

} // namespace quadrille

#include "moc_sequencetimeline.cpp"
