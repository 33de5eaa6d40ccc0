// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/workspace.h"

namespace quadrille {

class ContactProposal;
class FrameNotes;
class NotesPanel;
class PoseComparison;
class SequenceTimeline;

/// The workspace in which sequences are looked at, compared, trimmed and marked: viewport above timeline.
class SequencesWorkspace : public Workspace
{
    Q_OBJECT

public:
    explicit SequencesWorkspace(EditorContext& context, QWidget* parent = nullptr);

    SceneView& view() override { return *m_view; }
    std::vector<Panel> panels() override;
    std::optional<NamedFrame> shownPose() override;
    void setActive(bool active) override;
    const PoseComparison& comparison() const { return *m_comparison; }

private:
    void makeEditActions();
    void makeNotes();
    void followSelection();
    void followScene();
    void showState();

    EditorContext& m_context;
    SceneView* m_view;
    SequenceTimeline* m_sequenceTimeline;
    ContactProposal* m_contacts;
    PoseComparison* m_comparison;
    FrameNotes* m_notes = nullptr;
    NotesPanel* m_notesPanel = nullptr;
};

} // namespace quadrille
