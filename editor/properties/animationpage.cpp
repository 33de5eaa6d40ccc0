// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/animationpage.h"

#include "editor/commands/animationedits.h"
#include "editor/context/editorcontext.h"
#include "model/project/document/findentry.h"
#include "model/project/results/openanimation.h"

#include <QLocale>
#include <algorithm>

namespace quadrille {

namespace {

/// How many constraints of a kind an animation has.
template <typename Kind>
int countOf(const AnimationEntry& entry)
{
    return static_cast<int>(std::ranges::count_if(
        entry.constraints, [](const auto& constraint) { return std::holds_alternative<Kind>(constraint); }));
}

} // namespace

AnimationPage::AnimationPage(EditorContext& context)
    : EntryPage(context, {.section = Section::Animations,
                          .name = "animation",
                          .workspace = "workspace.animate",
                          .characterTip = [] { return tr("Whose sequences the animation is made of"); }})
{
    m_wishes = addFact("animationWishes", [] { return tr("Asked for"); });
    m_finish = addFact("animationFinish", [] { return tr("Afterwards"); });
    m_outcome = addFact("animationOutcome", [] { return tr("Result"); });
    addOpen();
    connect(&context.animations, &AnimationResults::changed, this, [this](const QString& name) {
        if (name == entryName())
            m_outcome->setText(outcome());
    });
}

void AnimationPage::show(const QString& name)
{
    EntryPage::show(name);
    const AnimationEntry& entry = *context().document.animation(name);
    m_wishes->setText(wishes(entry));
    m_finish->setText(finish(entry));
    m_outcome->setText(outcome());
}

QString AnimationPage::character() const
{
    return context().animations.characterOf(entryName());
}

void AnimationPage::setCharacter(const QString& character)
{
    AnimationEntry after = *context().document.animation(entryName());
    after.character = character.toStdString();
    setAnimation(context().document, entryName(), tr("Change the character of “%1”").arg(entryName()),
                 QStringLiteral("character"), std::move(after));
}

void AnimationPage::select()
{
    context().selection.selectAnimations({entryName()});
}

QString AnimationPage::wishes(const AnimationEntry& entry) const
{
    if (entry.walk)
        return tr("nothing: its walk was accepted");
    QStringList parts;
    if (const int paths = countOf<PathEntry>(entry); paths > 0)
        parts += tr("%n path(s)", nullptr, paths);
    if (const int keys = countOf<KeyEntry>(entry); keys > 0)
        parts += tr("%n key(s)", nullptr, keys);
    if (const int actions = countOf<ActionEntry>(entry); actions > 0)
        parts += tr("%n action(s)", nullptr, actions);
    return parts.isEmpty() ? tr("nothing yet") : parts.join(QStringLiteral(", "));
}

QString AnimationPage::finish(const AnimationEntry& entry) const
{
    const PostProcessing& steps = entry.post.steps;
    QStringList parts;
    if (entry.post.variations)
        parts += tr("repeats varied");
    if (steps.loop)
        parts += steps.repeats > 1 ? tr("looped, played %n times", nullptr, steps.repeats) : tr("looped");
    if (steps.contacts)
        parts += tr("foot contacts corrected");
    if (steps.mirror)
        parts += tr("mirrored");
    if (steps.retime)
        parts += tr("retimed");
    return parts.isEmpty() ? tr("nothing") : parts.join(QStringLiteral(", "));
}

QString AnimationPage::outcome() const
{
    const auto result = context().animations.result(entryName());
    if (result == nullptr)
        return tr("made when its workspace is open");
    const double seconds = static_cast<double>(result->sequence.frameCount()) / result->sequence.fps;
    return tr("%n frames, %1 s", nullptr, static_cast<int>(result->sequence.frameCount()))
        .arg(QLocale().toString(seconds, 'f', 2));
}

} // namespace quadrille

#include "moc_animationpage.cpp"
