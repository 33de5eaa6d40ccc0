// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/workspace.h"

#include <QPointer>
#include <map>

namespace quadrille {

class CurrentVariation;
class LatentPanel;
class PanelFront;
class PartCurveTool;

/// The workspace in which movements are learned and natural variations of them are drawn.
class VariationsWorkspace : public Workspace
{
    Q_OBJECT

public:
    explicit VariationsWorkspace(EditorContext& context, QWidget* parent = nullptr);

    SceneView& view() override { return *m_view; }
    std::vector<Panel> panels() override { return m_panels; }
    std::optional<NamedFrame> shownPose() override;
    void setActive(bool active) override;
    CurrentVariation& variation() { return *m_variation; }
    PartCurveTool& parts() { return *m_parts; }
    LatentPanel& latent() { return *m_latent; }

signals:
    /// The user wants the variations "variations/NAME" as a data set.
    void exportRequested(const QString& clip);

private:
    ClipScene::Source source();
    void makePanels();
    void makeActions();
    /// A variation by the name that the view gives it, a take, or its used frames; null until it is there.
    const MeshSequence* clip(const QString& name);
    /// Takes stand beside variations with the frames that are learned from; alone they are whole.
    bool showsWholeTakes() const;
    void follow();
    void followPanels();
    void setCutting(bool cutting);
    void showParts();
    void followResult();
    void showState();

    EditorContext& m_context;
    SceneView* m_view;
    CurrentVariation* m_variation;
    PartCurveTool* m_parts;
    QPointer<PanelFront> m_bodyPartsFront;
    QPointer<PanelFront> m_samplesFront;
    LatentPanel* m_latent = nullptr;
    std::vector<Panel> m_panels;
    std::map<QString, MeshSequence> m_originals; ///< the frames used of takes that are varied
    bool m_isActive = false;
    /// Curves are drawn on a take: it is what is shown with their panel. Where samples are to be seen beside
    /// it, the panel counts that was used last.
    bool m_isCutting = false;
};

} // namespace quadrille
