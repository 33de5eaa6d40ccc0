// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/variationsworkspace.h"

#include "editor/application/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/bodypartspanel.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/movementpanel.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/variations/variationbar.h"

#include <QVBoxLayout>

namespace quadrille {

namespace {

SequenceStage::Source sourceOf(const EditorContext& context)
{
    return {.clip = [&context](const QString& name, bool) { return context.media.sequence(name); },
            .upAxis = [&context] { return context.media.upAxis(); }};
}

} // namespace

VariationsWorkspace::VariationsWorkspace(EditorContext& context, QWidget* parent)
    : Workspace(parent)
    , m_context(context)
    , m_view(new StageView(context, sourceOf(context), QStringLiteral("variations")))
    , m_variation(new CurrentVariation(context, *m_view, this))
    , m_parts(new PartCurveTool(*m_variation, this))
{
    setObjectName(QStringLiteral("variationsWorkspace"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(new VariationBar(*m_variation));
    column->addWidget(m_view, 1);
    m_panels.push_back({"movementDock", [] { return tr("Movement"); }, new MovementPanel(*m_variation)});
    m_panels.push_back({"bodyPartsDock", [] { return tr("Body parts"); }, new BodyPartsPanel(*m_parts)});
    connect(m_variation, &CurrentVariation::changed, this, &VariationsWorkspace::follow);
    connect(&context.media, &SequenceMedia::changed, this,
            [this](const QString& name) { stage().update(name); });
    retranslates(this, [this] { showState(); });
}

void VariationsWorkspace::setActive(bool active)
{
    m_isActive = active;
    follow();
}

void VariationsWorkspace::follow()
{
    if (!m_isActive)
        return;
    const QString& shown = m_context.selection.shownSequence();
    m_view->show(shown.isEmpty() ? QStringList() : QStringList{shown});
    showState();
}

void VariationsWorkspace::showState()
{
    QString notice;
    if (m_context.document.project().sequences.empty())
        notice = tr("Import sequences first: variations are learned from them.");
    viewport().setNotice(notice);
}

} // namespace quadrille
