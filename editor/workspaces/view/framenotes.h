// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "model/project/document/framenote.h"
#include "widgets/timeline/timeline.h"

#include <QObject>
#include <QPointer>
#include <functional>

namespace quadrille {

class SceneView;

namespace widgets {
class InPlaceEdit;
}

/// The notes on the frames that a view shows: a row of its timeline where they are written, moved and taken
/// away. Whoever knows what is shown says where the notes are kept.
class FrameNotes : public QObject
{
    Q_OBJECT

public:
    struct Keeper
    {
        /// Nothing where there is nothing to write notes on.
        std::function<std::optional<std::vector<FrameNote>>()> notes;
        std::function<void(std::vector<FrameNote>, EditPhase)> keep;
        std::function<int()> firstFrame; ///< the frame of the timeline at which the notes' frame 0 is
    };

    /// \param view  outlives it, as does what the keeper refers to.
    FrameNotes(SceneView& view, Keeper keeper, QObject* parent = nullptr);

    static constexpr auto trackId = QLatin1String("notes");
    /// The row of the timeline; \pre there is something to write notes on.
    widgets::TimelineTrack track() const;
    std::vector<FrameNote> notes() const { return m_keeper.notes().value_or(std::vector<FrameNote>()); }
    bool isThere() const { return m_keeper.notes().has_value(); }
    /// Lets a note be written at a frame of the timeline; one that is there is edited. Nothing happens where
    /// there is nothing to write notes on, or before frame 0 of the notes.
    void write(int frame);
    /// \param note  its place among notes(), from 0; so for the next two. \pre There is one.
    void edit(int note);
    void remove(int note);
    void goTo(int note);
    /// To the next note behind the playhead, or before it. Nothing happens where there is none. \param step
    /// 1 or −1.
    void goToNeighbour(int step);
    /// The frame of the timeline at which a note is.
    int frameOf(const FrameNote& note) const
    {
        return static_cast<int>(note.frame.value) + m_keeper.firstFrame();
    }

private:
    void openField(const QString& text, const QRect& place, const std::function<void(const QString&)>& take);

    SceneView& m_view;
    Keeper m_keeper;
    QPointer<widgets::InPlaceEdit> m_field;
};

} // namespace quadrille
