// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/currentanimation.h"

#include "editor/commands/animationedits.h"
#include "editor/context/editorcontext.h"
#include "model/project/document/findentry.h"

namespace quadrille {

CurrentAnimation::CurrentAnimation(EditorContext& context, SceneView& view, QObject* parent)
    : QObject(parent), m_context(context), m_view(view)
{
    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.touches(Section::Animations) || event.touches(Section::Sequences))
            emit changed();
    });
    connect(&context.selection, &Selection::changed, this, [this] {
        emit changed();
        emit resultChanged();
    });
    connect(&context.animations, &AnimationResults::changed, this, [this](const QString& name) {
        if (name == this->name())
            emit resultChanged();
    });
    connect(&context.graphs, &GraphResults::changed, this, &CurrentAnimation::resultChanged);
}

const QString& CurrentAnimation::name() const
{
    return m_context.selection.shownAnimation();
}

const AnimationEntry* CurrentAnimation::entry() const
{
    return m_context.document.animation(name());
}

ResultPhase CurrentAnimation::phase() const
{
    const auto* resultState = m_context.animations.resultState(name());
    return resultState == nullptr ? ResultPhase::Idle : resultState->phase;
}

std::shared_ptr<const AnimationResult> CurrentAnimation::result() const
{
    return m_context.animations.result(name());
}

std::shared_ptr<const OpenedCharacter> CurrentAnimation::character() const
{
    const QString character =
        entry() == nullptr ? m_context.graphs.firstCharacter() : m_context.animations.characterOf(name());
    const auto* resultState = m_context.graphs.resultState(character);
    return resultState == nullptr ? nullptr : resultState->opened;
}

void CurrentAnimation::edit(const QString& text, const QString& property, const Edit& edit, EditPhase phase)
{
    const QString edited = entry() == nullptr ? add() : name();
    const AnimationEntry* before = m_context.document.animation(edited);
    if (before == nullptr)
        return;
    AnimationEntry after = *before;
    edit(after);
    setAnimation(m_context.document, edited, text, property, std::move(after), phase);
}

QString CurrentAnimation::add()
{
    AnimationEntry animation;
    animation.name = tr("animation").toStdString();
    if (m_context.document.project().characters.size() > 1)
        animation.character = m_context.graphs.firstCharacter().toStdString();
    QString added = addAnimation(m_context.document, std::move(animation));
    m_context.selection.selectAnimations({added});
    return added;
}

} // namespace quadrille

#include "moc_currentanimation.cpp"
