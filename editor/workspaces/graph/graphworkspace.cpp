// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphworkspace.h"

#include "editor/application/editorcontext.h"

#include <QVBoxLayout>

namespace quadrille {

GraphWorkspace::GraphWorkspace(EditorContext& context, QWidget* parent)
    : Workspace(parent)
    , m_view(new StageView(context,
                           {.clip = [](const QString&, bool) -> const MeshSequence* { return nullptr; },
                            .upAxis = [&context] { return context.media.upAxis(); }},
                           QStringLiteral("graph")))
{
    setObjectName(QStringLiteral("graphWorkspace"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view);
}

} // namespace quadrille
