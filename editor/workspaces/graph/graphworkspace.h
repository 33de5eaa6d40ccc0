// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/workspace.h"

namespace quadrille {

/// The workspace in which transitions between all frames of a character are looked at.
class GraphWorkspace : public Workspace
{
    Q_OBJECT

public:
    explicit GraphWorkspace(EditorContext& context, QWidget* parent = nullptr);

    StageView& view() override { return *m_view; }

private:
    StageView* m_view;
};

} // namespace quadrille
