// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

namespace quadrille {

class Player;
class SequenceStage;
class SequenceTimeline;
struct EditorContext;

namespace widgets {
class PlaybackBar;
class Timeline;
class Viewport;
} // namespace widgets

/// The workspace in which sequences are looked at, compared, trimmed and marked: viewport above timeline.
class SequencesWorkspace : public QWidget
{
    Q_OBJECT

public:
    explicit SequencesWorkspace(EditorContext& context, QWidget* parent = nullptr);

    Player& player() { return *m_player; }
    SequenceStage& stage() { return *m_stage; }
    widgets::Viewport& viewport() { return *m_viewport; }
    /// Plays the next sequence that is shown as soon as it is ready.
    void playWhenReady() { m_playsWhenReady = true; }

private:
    void makeEditActions();
    void makePlaybackActions();
    void makeViewActions();
    void connectPlayback();
    void retranslate();
    void followDocument();
    void followSelection();
    void followStage();
    void followRange();

    EditorContext& m_context;
    widgets::Viewport* m_viewport;
    widgets::Timeline* m_timeline;
    widgets::PlaybackBar* m_bar;
    SequenceStage* m_stage;
    Player* m_player;
    SequenceTimeline* m_sequenceTimeline;
    bool m_playsWhenReady = false;
};

} // namespace quadrille
