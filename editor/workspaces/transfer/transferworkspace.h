// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/workspace.h"

#include <array>

namespace quadrille {

class CurrentTransfer;
class PairTool;

/// The workspace in which a performance is brought onto another body: both side by side, with the triangles
/// of them that are paired.
class TransferWorkspace : public Workspace
{
    Q_OBJECT

public:
    explicit TransferWorkspace(EditorContext& context, QWidget* parent = nullptr);

    SceneView& view() override { return *m_view; }
    std::vector<Panel> panels() override { return m_panels; }
    std::optional<NamedFrame> shownPose() override;
    QString shownClip() const override;
    void setActive(bool active) override;
    QJsonObject look() const override;
    void setLook(const QJsonObject& look) override;
    CurrentTransfer& transfer() { return *m_transfer; }
    PairTool& tool() { return *m_tool; }

    /// What the figures of template and body are called in the view.
    static QString templateName();
    static QString targetName();

signals:
    /// The user wants the transfer's clip in files: "transfers/NAME".
    void exportRequested(const QString& clip);

private:
    ClipScene::Source source();
    const MeshSequence* clip(const QString& name);
    void makeActions();
    void makePanels();
    void follow();
    void followResult();
    void showState();
    void addSequence();
    void addProjection();

    EditorContext& m_context;
    std::array<MeshSequence, 2> m_clips; ///< that are shown
    SceneView* m_view;
    CurrentTransfer* m_transfer;
    PairTool* m_tool;
    std::vector<Panel> m_panels;
    QString m_help; ///< the action behind the message's button
    bool m_isActive = false;
};

} // namespace quadrille
