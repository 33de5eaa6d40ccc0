// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/viewport.h"

#include <QWidget>

namespace quadrille {

class ContactProposal;
class PictureFlow;
class Player;
class PoseComparison;
class SequenceStage;
class SequenceTimeline;
class ViewTools;
struct EditorContext;

namespace widgets {
class MessageStrip;
class PlaybackBar;
class Timeline;
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
    const PoseComparison& comparison() const { return *m_comparison; }
    PictureFlow& pictures() { return *m_pictures; }
    /// Plays the next sequence that is shown as soon as it is ready.
    void playWhenReady() { m_playsWhenReady = true; }

private:
    void makeEditActions();
    void makePlaybackActions();
    void makeViewActions();
    void makeCameraActions();
    void makeComparingActions();
    void arrangeWidgets();
    void connectPlayback();
    void retranslate();
    void followDocument();
    void followSelection();
    void followStage();
    void followRange();
    void followCharacter();
    void followNames();
    void setLayout(widgets::Viewport::Layout layout);
    void showState();

    EditorContext& m_context;
    widgets::Viewport* m_viewport;
    widgets::Timeline* m_timeline;
    widgets::PlaybackBar* m_bar;
    SequenceStage* m_stage;
    Player* m_player;
    SequenceTimeline* m_sequenceTimeline;
    ContactProposal* m_contacts;
    widgets::MessageStrip* m_message;
    PictureFlow* m_pictures;
    PoseComparison* m_comparison = nullptr;
    ViewTools* m_tools = nullptr;
    bool m_playsWhenReady = false;
};

} // namespace quadrille
