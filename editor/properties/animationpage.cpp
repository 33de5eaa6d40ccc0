// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/animationpage.h"

#include "editor/application/editorcontext.h"
#include "editor/commands/animationedits.h"
#include "editor/commands/projectedits.h"
#include "editor/documents/animationresult.h"

#include <QComboBox>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <array>

namespace quadrille {

AnimationPage::AnimationPage(EditorContext& context)
    : m_context(context), m_nameField(new QLineEdit), m_character(new QComboBox), m_open(new QPushButton)
{
    m_character->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    addField(
        "animationName", [] { return tr("Name"); }, m_nameField, [] { return tr("Unique in the project"); });
    addField(
        "animationCharacter", [] { return tr("Character"); }, m_character,
        [] { return tr("Whose sequences the animation is made of"); });
    m_wishes = addFact("animationWishes", [] { return tr("Asked for"); });
    m_finish = addFact("animationFinish", [] { return tr("Afterwards"); });
    m_outcome = addFact("animationOutcome", [] { return tr("Result"); });
    for (QLabel* fact : {m_wishes, m_finish, m_outcome})
        fact->setWordWrap(true);
    addWide("animationOpen", m_open);
    connect(m_nameField, &QLineEdit::editingFinished, this, [this] {
        if (!renameEntry(m_context.document, {Section::Animations, m_name}, m_nameField->text()))
            m_nameField->setText(m_name);
    });
    connect(m_character, &QComboBox::textActivated, this, [this](const QString& character) {
        AnimationEntry after = *m_context.document.animation(m_name);
        after.character = character.toStdString();
        setAnimation(m_context.document, m_name, tr("Change the character of “%1”").arg(m_name),
                     QStringLiteral("character"), std::move(after));
    });
    connect(m_open, &QPushButton::clicked, this, [this] {
        m_context.selection.selectAnimations({m_name});
        m_context.actions.action(QStringLiteral("workspace.animate"))->trigger();
    });
    connect(&context.animations, &AnimationMedia::changed, this, [this](const QString& name) {
        if (name == m_name)
            m_outcome->setText(outcome());
    });
    retranslate();
}

void AnimationPage::show(const QString& name)
{
    m_name = name;
    const AnimationEntry& entry = *m_context.document.animation(name);
    if (!m_nameField->hasFocus() || !m_nameField->isModified())
        m_nameField->setText(name);
    m_character->clear();
    for (const CharacterEntry& character : m_context.document.project().characters)
        m_character->addItem(QString::fromStdString(character.name));
    m_character->setCurrentText(m_context.animations.characterOf(name));
    setFieldVisible(m_character, m_character->count() > 1);
    m_wishes->setText(wishes(entry));
    m_finish->setText(finish(entry));
    m_outcome->setText(outcome());
}

QString AnimationPage::wishes(const AnimationEntry& entry) const
{
    if (entry.walk)
        return tr("nothing: its walk was accepted");
    std::array<int, 3> counts{};
    for (const ConstraintEntry& constraint : entry.constraints)
        ++counts.at(constraint.index());
    const auto [keys, paths, actions] = counts;
    QStringList parts;
    if (paths > 0)
        parts += tr("%n path(s)", nullptr, paths);
    if (keys > 0)
        parts += tr("%n key(s)", nullptr, keys);
    if (actions > 0)
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
    const auto result = m_context.animations.result(m_name);
    if (result == nullptr)
        return tr("made when its workspace is open");
    const double seconds = static_cast<double>(result->sequence.frameCount()) / result->sequence.fps;
    return tr("%n frames, %1 s", nullptr, static_cast<int>(result->sequence.frameCount()))
        .arg(QLocale().toString(seconds, 'f', 2));
}

void AnimationPage::retranslate()
{
    m_open->setText(tr("Work on it"));
}

} // namespace quadrille
