// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/workspace.h"

namespace quadrille {

class CurrentVariation;
class PartCurveTool;

/// The workspace in which movements are learned and natural variations of them are drawn.
class VariationsWorkspace : public Workspace
{
    Q_OBJECT

public:
    explicit VariationsWorkspace(EditorContext& context, QWidget* parent = nullptr);

    StageView& view() override { return *m_view; }
    std::vector<Panel> panels() override { return m_panels; }
    void setActive(bool active) override;
    CurrentVariation& variation() { return *m_variation; }
    PartCurveTool& parts() { return *m_parts; }

private:
    void follow();
    void showState();

    EditorContext& m_context;
    StageView* m_view;
    CurrentVariation* m_variation;
    PartCurveTool* m_parts;
    std::vector<Panel> m_panels;
    bool m_isActive = false;
};

} // namespace quadrille
