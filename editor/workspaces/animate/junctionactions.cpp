// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What can be done with the transitions of a clip.
#include "editor/commands/animationedits.h"
#include "editor/context/editorcontext.h"
#include "editor/fields/actionbutton.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/junctionpanel.h"
#include "editor/workspaces/animate/transitionpreview.h"
#include "editor/workspaces/view/sceneview.h"
#include "widgets/controls/messagestrip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QShortcut>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {

namespace {

constexpr double aroundSeconds = 0.5; ///< that play before and behind a transition

QString group()
{
    return JunctionPanel::tr("Animate");
}

} // namespace

void JunctionPanel::makeActions()
{
    ActionRegistry& actions = m_animation.context().actions;
    actions.add({"junction.previous",
                 group,
                 [] { return tr("Previous &transition"); },
                 {},
                 "stepback",
                 {Qt::Key_Comma}},
                [this] { step(-1); });
    actions.add({"junction.next", group, [] { return tr("Ne&xt transition"); }, {}, "step", {Qt::Key_Period}},
                [this] { step(1); });
    actions.add({"junction.play",
                 group,
                 [] { return tr("&Play around the transition"); },
                 [] { return tr("Plays the selected transition with half a second before and behind"); },
                 "play",
                 {Qt::SHIFT | Qt::Key_Return}},
                [this] { playAround(current()); });
    makeDecidingActions();
    makeWalkActions();
}

void JunctionPanel::makeDecidingActions()
{
    ActionRegistry& actions = m_animation.context().actions;
    actions.add({"junction.ban",
                 group,
                 [] { return tr("&Ban the transition"); },
                 [] { return tr("Never uses the selected transition, and seeks another way"); },
                 "ban",
                 {Qt::SHIFT | Qt::Key_B}},
                [this] { banCurrent(); });
    actions.add({"junction.banNeighbours",
                 group,
                 [] { return tr("Ban it and its nei&ghbours"); },
                 [] { return tr("Never uses the selected transition, nor those within two frames of it"); },
                 "ban",
                 {Qt::CTRL | Qt::SHIFT | Qt::Key_B}},
                [this] { banNeighbours(); });
    actions.addToggle({"junction.choose",
                       group,
                       [] { return tr("Choose an&other"); },
                       [] { return tr("Lists the next best transitions nearby, to be seen and taken"); },
                       "exchange",
                       {Qt::SHIFT | Qt::Key_E}},
                      false, [this](bool on) { setChoosing(on); });
    actions.addToggle({"junction.lock",
                       group,
                       [] { return tr("&Lock the transition"); },
                       [] { return tr("Keeps the selected transition whatever else is asked for"); },
                       "lock",
                       {Qt::SHIFT | Qt::Key_L}},
                      false, [](bool) {});
    // Triggered by the user alone: its state follows the selection.
    connect(actions.action("junction.lock"), &QAction::triggered, this, &JunctionPanel::toggleLock);
    actions.add(
        {"junction.lockSegment",
         group,
         [] { return tr("Lock the se&gment"); },
         [] { return tr("Keeps the transitions at both ends of the captured frames that are shown"); },
         "locksegment",
         {Qt::CTRL | Qt::SHIFT | Qt::Key_L}},
        [this] { lockSegment(); });
    actions.add({"junction.forget",
                 group,
                 [] { return tr("&Take the decision back"); },
                 [] { return tr("Forgets what was decided about the transition in the list of decisions"); },
                 "delete",
                 {}},
                [this] { removeDecision(); });
}

void JunctionPanel::makeWalkActions()
{
    ActionRegistry& actions = m_animation.context().actions;
    actions.add({"animate.acceptWalk",
                 group,
                 [] { return tr("&Accept the walk"); },
                 [] { return tr("Keeps the walk that is shown: nothing is sought any more"); },
                 "success",
                 {}},
                [this] { acceptWalk(); });
    actions.add({"animate.releaseWalk",
                 group,
                 [] { return tr("Seek the whole &walk again"); },
                 [] {
                     return tr("Forgets the walk that was accepted, or that decisions keep to, and seeks "
                               "what is asked for");
                 },
                 "refresh",
                 {}},
                [this] { releaseWalk(); });
}

void JunctionPanel::arrangeWidgets()
{
    for (QWidget* place : {static_cast<QWidget*>(this), static_cast<QWidget*>(&m_animation.view())}) {
        auto* escape = new QShortcut(
            Qt::Key_Escape, place, this, [this] { setChoosing(false); }, Qt::WidgetWithChildrenShortcut);
        escape->setEnabled(false);
        m_escapes.push_back(escape);
    }
    m_message->setObjectName(QStringLiteral("junctionMessage"));
    m_details->setObjectName(QStringLiteral("junctionDetails"));
    m_empty->setObjectName(QStringLiteral("junctionEmpty"));
    m_quality->setObjectName(QStringLiteral("junctionQuality"));
    for (QLabel* label : {m_details, m_quality}) {
        label->setWordWrap(true);
        label->setContentsMargins(12, 4, 12, 4);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    m_quality->setForegroundRole(QPalette::PlaceholderText);
    m_quality->hide();
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setMargin(16);
    for (QLabel* title : {m_alternativesTitle, m_decisionsTitle}) {
        QFont font = title->font();
        font.setWeight(QFont::DemiBold);
        title->setFont(font);
        title->setContentsMargins(12, 8, 12, 4);
    }
    auto* row = new QHBoxLayout(m_buttons);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(4);
    for (const char* id : {"junction.play", "junction.ban", "junction.choose", "junction.lock",
                           "junction.lockSegment", "junction.forget", "animate.acceptWalk"})
        row->addWidget(makeActionButton(m_animation.context().actions.action(id)));
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_message);
    column->addWidget(m_buttons);
    column->addWidget(m_list, 3);
    column->addWidget(m_empty, 3);
    column->addWidget(m_details);
    column->addWidget(m_quality);
    column->addWidget(m_alternativesTitle);
    column->addWidget(m_alternativesList, 2);
    column->addWidget(m_decisionsTitle);
    column->addWidget(m_decisionsList, 1);
}

void JunctionPanel::updateActions()
{
    ActionRegistry& actions = m_animation.context().actions;
    const auto enable = [&](const char* id, bool enabled) { actions.action(id)->setEnabled(enabled); };
    const AnimationEntry* entry = m_animation.entry();
    const ClipJunction* junction = currentJunction();
    const bool isSought = entry != nullptr && !entry->walk;
    enable("junction.previous", !m_junctions.empty());
    enable("junction.next", !m_junctions.empty());
    enable("junction.play", junction != nullptr && junction->shown.has_value());
    for (const char* id : {"junction.ban", "junction.banNeighbours", "junction.choose", "junction.lock"})
        enable(id, isSought && junction != nullptr);
    enable("junction.lockSegment", isSought && !m_junctions.empty());
    enable("junction.forget", m_decisionsList->currentItem() != nullptr);
    enable("animate.acceptWalk", isSought && m_result != nullptr);
    enable("animate.releaseWalk",
           entry != nullptr && (entry->walk.has_value() || !entry->junctions.walk.empty()));
    actions.action("junction.lock")
        ->setChecked(entry != nullptr && junction != nullptr &&
                     contains(entry->junctions.locked, junction->transition.names));
}

void JunctionPanel::step(int direction)
{
    const auto last = static_cast<int>(m_junctions.size()) - 1;
    if (last >= 0)
        select(std::clamp(current() + direction, 0, last));
}

void JunctionPanel::goTo(int junction)
{
    if (junction < 0 || !m_junctions[static_cast<std::size_t>(junction)].shown)
        return;
    Player& player = m_animation.view().player();
    player.pause();
    player.goTo(m_junctions[static_cast<std::size_t>(junction)].shown->first);
}

void JunctionPanel::playAround(int junction)
{
    if (junction < 0 || !m_junctions[static_cast<std::size_t>(junction)].shown)
        return;
    setChoosing(false);
    const ClipFrames frames = *m_junctions[static_cast<std::size_t>(junction)].shown;
    const double fps = m_animation.context().document.project().settings.fps;
    const auto around = static_cast<std::int64_t>(std::lround(aroundSeconds * fps));
    const std::int64_t end = m_animation.view().scene().frameCount() - 1;
    Player& player = m_animation.view().player();
    player.pause();
    const std::int64_t first = std::max<std::int64_t>(frames.first - around, 0);
    player.setRange(FrameIndex(first), FrameIndex(std::min(frames.last + around, end)));
    player.setLooping(true);
    player.goTo(first);
    m_playsAround = true;
    player.play();
}

int JunctionPanel::previewStart() const
{
    const ClipJunction* junction = currentJunction();
    if (junction == nullptr || !junction->shown || m_preview->clip() == nullptr)
        return 0;
    return std::max(0, static_cast<int>(junction->shown->first) - m_preview->lead());
}

void JunctionPanel::setChoosing(bool choosing)
{
    if (std::exchange(m_isChoosing, choosing) == choosing)
        return;
    for (QShortcut* escape : m_escapes)
        escape->setEnabled(choosing);
    m_animation.context().actions.action("junction.choose")->setChecked(choosing);
    refreshAlternatives();
    if (choosing && !m_alternatives.empty())
        m_alternativesList->setFocus();
}

void JunctionPanel::chooseCurrent()
{
    const int place = m_alternativesList->indexOfTopLevelItem(m_alternativesList->currentItem());
    const ClipJunction* junction = currentJunction();
    if (place < 0 || junction == nullptr)
        return;
    const JunctionEntry chosen = m_alternatives[static_cast<std::size_t>(place)].names;
    const JunctionEntry instead = junction->transition.names;
    setChoosing(false);
    decide(tr("Choose another transition"),
           [&](JunctionsEntry& junctions) { choose(junctions, chosen, instead); });
}

void JunctionPanel::decide(const QString& text, const std::function<void(JunctionsEntry&)>& edit)
{
    m_animation.edit(text, QStringLiteral("junctions"), [&](AnimationEntry& entry) {
        JunctionsEntry& junctions = entry.junctions;
        edit(junctions);
        // What is not decided stays as it is shown, until something else is asked for.
        if (junctions.isEmpty())
            junctions.walk.clear();
        else if (junctions.walk.empty() && m_result != nullptr && asksTheSame(m_result->entry, entry))
            junctions.walk = walkSpansOf(*m_result);
    });
}

void JunctionPanel::banCurrent()
{
    if (const ClipJunction* junction = currentJunction())
        decide(tr("Ban a transition"),
               [names = junction->transition.names](JunctionsEntry& junctions) { ban(junctions, names); });
}

void JunctionPanel::banNeighbours()
{
    const ClipJunction* junction = currentJunction();
    if (junction == nullptr)
        return;
    const auto neighbours = neighboursOf(m_result->character->graph, junction->transition.frames);
    decide(tr("Ban a transition and its neighbours"), [&](JunctionsEntry& junctions) {
        for (const JunctionEntry& neighbour : neighbours)
            ban(junctions, neighbour);
    });
}

void JunctionPanel::toggleLock()
{
    const ClipJunction* junction = currentJunction();
    if (junction == nullptr)
        return;
    const JunctionEntry names = junction->transition.names;
    const bool isLocked = contains(m_animation.entry()->junctions.locked, names);
    decide(isLocked ? tr("Unlock a transition") : tr("Lock a transition"), [&](JunctionsEntry& junctions) {
        if (isLocked)
            forget(junctions, names);
        else
            lock(junctions, names);
    });
}

void JunctionPanel::lockSegment()
{
    const std::int64_t now = m_animation.view().player().frame().value;
    std::vector<JunctionEntry> ends;
    for (const ClipJunction& junction : m_junctions) {
        if (!junction.shown)
            continue;
        // The last transition that ended by now, and the first that ends later.
        const bool isBefore = junction.shown->last <= now;
        if (isBefore)
            ends.clear();
        ends.push_back(junction.transition.names);
        if (!isBefore)
            break;
    }
    decide(tr("Lock a segment"), [&](JunctionsEntry& junctions) {
        for (const JunctionEntry& end : ends)
            lock(junctions, end);
    });
}

void JunctionPanel::removeDecision()
{
    const int place = m_decisionsList->indexOfTopLevelItem(m_decisionsList->currentItem());
    if (place >= 0)
        decide(tr("Take a decision back"), [names = m_decisions[static_cast<std::size_t>(place)]](
                                               JunctionsEntry& junctions) { forget(junctions, names); });
}

void JunctionPanel::acceptWalk()
{
    if (m_result == nullptr || m_animation.entry() == nullptr)
        return;
    m_animation.edit(tr("Accept the walk"), QStringLiteral("walk"),
                     [this](AnimationEntry& entry) { entry.walk = walkEntryOf(*m_result); });
}

void JunctionPanel::releaseWalk()
{
    if (m_animation.entry() != nullptr)
        m_animation.edit(tr("Seek again"), QStringLiteral("walk"), [](AnimationEntry& entry) {
            entry.walk.reset();
            entry.junctions.walk.clear();
        });
}

} // namespace quadrille
