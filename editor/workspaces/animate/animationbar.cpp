// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/animationbar.h"

#include "editor/commands/animationedits.h"
#include "editor/context/editorcontext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/namebox.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "model/project/results/openanimation.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QToolButton>

namespace quadrille {

namespace {

constexpr int barGap = 8;

} // namespace

AnimationBar::AnimationBar(CurrentAnimation& animation, QWidget* parent)
    : QWidget(parent), m_animation(animation), m_names(new QComboBox), m_state(new QLabel)
{
    setObjectName(QStringLiteral("animationBar"));
    m_names->setObjectName(QStringLiteral("animationNames"));
    fitToNames(*m_names);
    m_state->setObjectName(QStringLiteral("animationState"));
    m_state->setFont(widgets::Theme::tabularFont(m_state->font()));
    m_state->setMinimumWidth(1); // the window must not become wider with what a search finds
    makeActions();
    ActionRegistry& actions = animation.context().actions;
    m_stop = makeActionButton(actions.action("animate.stop"));
    m_solve = makeActionButton(actions.action("animate.solve"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(barGap, barGap / 2, barGap, barGap / 2);
    row->setSpacing(barGap / 2);
    row->addWidget(m_names);
    row->addWidget(makeActionButton(actions.action("animate.new")));
    row->addWidget(makeActionButton(actions.action("animate.duplicate")));
    row->addSpacing(barGap);
    row->addWidget(m_stop);
    row->addWidget(m_solve);
    row->addWidget(m_state, 1);
    connect(m_names, &QComboBox::activated, this,
            [this] { m_animation.context().selection.selectAnimations({m_names->currentText()}); });
    connect(&animation, &CurrentAnimation::changed, this, &AnimationBar::refreshNames);
    connect(&animation, &CurrentAnimation::resultChanged, this, &AnimationBar::refreshState);
    retranslates(this, [this] {
        m_names->setAccessibleName(tr("Animation"));
        m_names->setToolTip(tr("The animation that is worked on"));
        m_names->setPlaceholderText(tr("No animation"));
        refreshNames();
        refreshState();
    });
}

void AnimationBar::makeActions()
{
    EditorContext& context = m_animation.context();
    ActionRegistry& actions = context.actions;
    const auto group = [] { return tr("Animate"); };
    actions.add({"animate.new",
                 group,
                 [] { return tr("&New animation"); },
                 [] { return tr("Add an animation to the project"); },
                 "add",
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N)}},
                [this] {
                    m_animation.add();
                    m_animation.context().actions.action("workspace.animate")->trigger();
                });
    actions.add({"animate.duplicate",
                 group,
                 [] { return tr("&Duplicate the animation"); },
                 [] { return tr("Add a copy of the animation, to try something else with it"); },
                 "copy",
                 {}},
                [this, &context] {
                    context.selection.selectAnimations(
                        {duplicateAnimation(context.document, m_animation.name())});
                });
    actions.add({"animate.solve",
                 group,
                 [] { return tr("Seek a&gain"); },
                 [] { return tr("Seek the walk again after it was stopped or failed"); },
                 "refresh",
                 {QKeySequence(Qt::CTRL | Qt::Key_Return)}},
                [this, &context] { context.animations.retry(m_animation.name()); });
    actions.add({"animate.stop",
                 group,
                 [] { return tr("&Stop seeking"); },
                 [] { return tr("Keep the best walk that was found so far"); },
                 "stop",
                 {QKeySequence(Qt::CTRL | Qt::Key_Period)}},
                [this, &context] { context.animations.stop(m_animation.name()); });
}

void AnimationBar::refreshNames()
{
    const QSignalBlocker blocker(m_names);
    m_names->clear();
    for (const AnimationEntry& entry : m_animation.context().document.project().animations)
        m_names->addItem(QString::fromStdString(entry.name));
    m_names->setCurrentIndex(m_names->findText(m_animation.name()));
    m_names->setEnabled(m_names->count() > 0);
    m_animation.context().actions.action("animate.duplicate")->setEnabled(m_animation.entry() != nullptr);
    refreshState();
}

void AnimationBar::refreshState()
{
    const ResultPhase phase = m_animation.phase();
    ActionRegistry& actions = m_animation.context().actions;
    actions.action("animate.stop")->setEnabled(phase == ResultPhase::Computing);
    const AnimationEntry* entry = m_animation.entry();
    const bool asks = entry != nullptr && entry->asksForSomething();
    actions.action("animate.solve")
        ->setEnabled(asks && (phase == ResultPhase::Idle || phase == ResultPhase::Failed));
    m_stop->setVisible(phase == ResultPhase::Computing);
    m_solve->setVisible(!m_stop->isVisibleTo(this));
    m_state->setText(stateText());
    m_state->setToolTip(m_state->text());
}

QString AnimationBar::stateText() const
{
    if (m_animation.entry() == nullptr)
        return tr("Add an animation, then draw a path, drop poses or line up takes.");
    switch (m_animation.phase()) {
    case ResultPhase::Waiting:
        return tr("Waiting for the graph…");
    case ResultPhase::Computing:
        return m_animation.result() == nullptr ? tr("Seeking a walk…")
                                               : tr("Seeking a better walk… %1").arg(resultText());
    case ResultPhase::Failed:
        return tr("No walk was found.");
    case ResultPhase::Ready:
        return resultText();
    default:
        return m_animation.result() == nullptr ? QString() : tr("Stopped. %1").arg(resultText());
    }
}

QString AnimationBar::resultText() const
{
    const auto result = m_animation.result();
    const QLocale locale;
    const double seconds = static_cast<double>(result->sequence.frameCount()) / result->sequence.fps;
    const auto junctions = static_cast<int>(result->plan.junctions.size());
    QString text = tr("%1 s, %n transitions", nullptr, junctions).arg(locale.toString(seconds, 'f', 2));
    if (!result->entry.walk)
        text += (result->walk.constraints.path ? tr(", cost %1 m²") : tr(", cost %1"))
                    .arg(locale.toString(result->walk.solution.totalCost, 'g', 4));
    if (result->walk.solution.optimal)
        text += result->walk.solution.eachLeg ? tr(", proven best from key to key") : tr(", proven best");
    return text;
}

} // namespace quadrille

#include "moc_animationbar.cpp"
