// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/sequencemedia.h"
#include "widgets/timeline/timeline.h"

#include <QObject>
#include <QPointer>

class QMenu;

namespace quadrille {

class FrameNotes;

namespace widgets {
class InPlaceEdit;
}

/// Lets the timeline show and edit one sequence of the document: its trim, label spans and foot contacts.
/// The timeline counts the frames of the untrimmed source; while sequences are compared, it shows the length
/// of the longest and edits nothing.
class SequenceTimeline : public QObject
{
    Q_OBJECT

public:
    /// Refers to timeline, document and media.
    SequenceTimeline(widgets::Timeline& timeline, ProjectDocument& document, SequenceMedia& media,
                     QObject* parent = nullptr);
    ~SequenceTimeline() override;

    /// \param comparedFrames the length to show while comparing; 0: one sequence is edited.
    void show(const QString& sequence, std::int64_t comparedFrames = 0);
    /// Adds a label over some frames from the playhead on and lets it be named. Both are one edit, which
    /// Escape takes back. Nothing happens while sequences are compared, or before this one is open.
    void addLabel();
    /// Adds a contact of a foot from the playhead on.
    void addContact(const QString& foot);
    /// Makes the playhead the first or last frame. The other end comes along where the playhead is beyond it.
    void trimStartHere();
    void trimEndHere();
    /// All frames of the source are used again.
    void removeTrim();
    /// Whose row stands below the others.
    void setNotes(FrameNotes& notes) { m_notes = &notes; }
    const QString& sequence() const { return m_sequence; }
    bool isEditing() const { return entry() != nullptr && m_comparedFrames == 0; }
    /// Opens a field for the name of a label. Nothing happens for spans of other rows. \param phase  of the
    /// edit that naming makes.
    void nameSpan(const widgets::SpanRef& span, EditPhase phase = EditPhase::Final);

signals:
    /// The frames that play are others now.
    void rangeChanged();
    /// A right click: more may be added.
    void menuOpened(QMenu* menu, const QString& track, int frame);

private:
    void refresh();
    void setRange(FrameRange used, bool committed);
    void editSpan(const widgets::SpanRef& span, int first, int last, bool committed);
    void createSpan(const QString& track, int first, int last);
    void deleteSpan(const widgets::SpanRef& span);
    void showMenu(const QString& track, const std::optional<widgets::SpanRef>& span, int frame,
                  const QPoint& position);
    std::vector<widgets::TimelineTrack> makeTracks(const SequenceEntry& shown) const;
    FrameRange toSequence(int first, int last) const;
    const SequenceEntry* entry() const { return m_document.sequence(m_sequence); }

    widgets::Timeline& m_timeline;
    ProjectDocument& m_document;
    SequenceMedia& m_media;
    QString m_sequence;
    std::int64_t m_comparedFrames = 0;
    std::optional<SequenceEntry> m_dragBase;
    FrameNotes* m_notes = nullptr;
    QPointer<widgets::InPlaceEdit> m_nameField;
};

} // namespace quadrille
