// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/workspace.h"

namespace quadrille {

class CurrentAppearance;
class ShownTexture;
class TextureComparison;

/// The workspace in which the textures of a character are modelled, looked at and completed.
class AppearanceWorkspace : public Workspace
{
    Q_OBJECT

public:
    explicit AppearanceWorkspace(EditorContext& context, QWidget* parent = nullptr);

    SceneView& view() override { return *m_view; }
    std::vector<Panel> panels() override { return m_panels; }
    std::optional<NamedFrame> shownPose() override;
    void setActive(bool active) override;
    QJsonObject look() const override;
    void setLook(const QJsonObject& look) override;
    CurrentAppearance& appearance() { return *m_appearance; }
    ShownTexture& shown() { return *m_shown; }
    TextureComparison& comparison() { return *m_comparison; }

private:
    ClipScene::Source source();
    void makePanels();
    void follow();
    void followTake();
    void showState();

    EditorContext& m_context;
    MeshSequence m_dressed; ///< the take that is shown, in textures of the model
    SceneView* m_view;
    CurrentAppearance* m_appearance;
    ShownTexture* m_shown;
    TextureComparison* m_comparison;
    std::vector<Panel> m_panels;
    const char* m_help = nullptr; ///< the action behind the message's button
    bool m_isActive = false;
};

} // namespace quadrille
