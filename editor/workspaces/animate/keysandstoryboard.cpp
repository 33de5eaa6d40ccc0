// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/keysandstoryboard.h"

#include "editor/context/editorcontext.h"
#include "editor/pictures/framepictures.h"
#include "editor/workspaces/animate/animationtimeline.h"
#include "editor/workspaces/animate/animationtracks.h"
#include "editor/workspaces/animate/constraintedits.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/keyspanel.h"
#include "editor/workspaces/animate/storyboardpanel.h"
#include "editor/workspaces/view/framenotes.h"
#include "editor/workspaces/view/notespanel.h"
#include "editor/workspaces/workspace.h"

#include <QDockWidget>
#include <QLayout>
#include <QMainWindow>
#include <QStatusBar>
#include <algorithm>
#include <cmath>

namespace quadrille {

KeysAndStoryboard::KeysAndStoryboard(CurrentAnimation& animation, QObject* parent)
    : QObject(parent)
    , m_animation(animation)
    , m_pictures(new FramePictures(animation.context().document, animation.context().media,
                                   animation.context().jobs, this))
    , m_timeline(new AnimationTimeline(animation, *m_pictures, this))
{
    makeActions();
    makeNotes();
    m_keys = new KeysPanel(animation, *m_pictures);
    m_storyboard = new StoryboardPanel(animation, *m_pictures);
    connect(m_timeline, &AnimationTimeline::keySelected, this, &KeysAndStoryboard::selectKey);
    connect(m_timeline, &AnimationTimeline::keyActivated, m_keys, [this](int key) {
        Workspace::showPanel(m_keys);
        m_keys->editKey(key);
    });
    connect(m_keys, &KeysPanel::keySelected, this, &KeysAndStoryboard::selectKey);
    connect(m_keys, &KeysPanel::keyChosen, m_timeline, &AnimationTimeline::goToKey);
    connect(m_keys, &KeysPanel::removalRequested, m_timeline, &AnimationTimeline::removeKey);
    connect(m_storyboard, &StoryboardPanel::actionChosen, m_timeline, &AnimationTimeline::goToPlanned);
    connect(&animation, &CurrentAnimation::changed, this, &KeysAndStoryboard::updateActions);
    connect(
        &animation, &CurrentAnimation::changed, this,
        [this] {
            if (m_animation.view().isVisible())
                fitDocks();
        },
        Qt::QueuedConnection);
    connect(&animation.context().selection, &Selection::changed, this, &KeysAndStoryboard::updateActions);
    connect(&animation.context().document, &ProjectDocument::changed, this,
            &KeysAndStoryboard::updateActions);
    updateActions();
}

void KeysAndStoryboard::makeNotes()
{
    m_notes = new FrameNotes(
        m_animation.view(),
        {.notes = [this]() -> std::optional<std::vector<FrameNote>> {
             const AnimationEntry* entry = m_animation.entry();
             return entry == nullptr ? std::nullopt : std::optional(notesOf(entry->unknown));
         },
         .keep =
             [this](std::vector<FrameNote> notes, EditPhase phase) {
                 m_animation.edit(
                     tr("Change the notes of “%1”").arg(m_animation.name()), QStringLiteral("notes"),
                     [&](AnimationEntry& entry) { quadrille::setNotes(entry.unknown, std::move(notes)); },
                     phase);
             },
         .firstFrame = [] { return 0; }},
        this);
    m_timeline->setNotes(*m_notes);
    m_animation.view().setNotes(m_notes);
    m_notesPanel = new NotesPanel(*m_notes);
    connect(&m_animation, &CurrentAnimation::changed, m_notesPanel,
            [this] { m_notesPanel->refresh(m_animation.context().document.project().settings.fps); });
}

std::vector<Workspace::Panel> KeysAndStoryboard::panels()
{
    return {{"storyboardDock", [] { return tr("Storyboard"); }, m_storyboard, Qt::BottomDockWidgetArea},
            {"keysDock", [] { return tr("Keys"); }, m_keys, Qt::BottomDockWidgetArea},
            {"notesDock", [] { return tr("Notes"); }, m_notesPanel, Qt::BottomDockWidgetArea, false}};
}

void KeysAndStoryboard::makeActions()
{
    ActionRegistry& actions = m_animation.context().actions;
    const auto group = [] { return tr("Animate"); };
    actions.add(
        {"animate.addKey",
         group,
         [] { return tr("Add as &key"); },
         [] { return tr("Ask for the pose that is shown now, at the animation's playhead"); },
         "key",
         {QKeySequence(Qt::SHIFT | Qt::Key_K)}},
        [this] {
            const auto pose = m_shownPose ? m_shownPose() : std::nullopt;
            if (!pose) {
                showStatus(tr("There is no pose to add: select a take, or show a clip."));
                return;
            }
            m_timeline->addKey(*pose);
            showStatus(
                tr("Key “%1” added to “%2”").arg(poseText(pose->sequence, pose->frame), m_animation.name()));
        });
    actions.add({"animate.removeKey",
                 group,
                 [] { return tr("R&emove the key"); },
                 [] { return tr("Remove the key that is selected on the timeline"); },
                 "delete",
                 {QKeySequence(Qt::SHIFT | Qt::Key_Delete)}},
                [this] { m_timeline->removeKey(m_selectedKey); });
    actions.add({"animate.previousKey",
                 group,
                 [] { return tr("Pre&vious key"); },
                 [] { return tr("Go to the key before the playhead"); },
                 "stepback",
                 {QKeySequence(Qt::CTRL | Qt::Key_PageUp)}},
                [this] { goToNeighbour(-1); });
    actions.add({"animate.nextKey",
                 group,
                 [] { return tr("Ne&xt key"); },
                 [] { return tr("Go to the key behind the playhead"); },
                 "step",
                 {QKeySequence(Qt::CTRL | Qt::Key_PageDown)}},
                [this] { goToNeighbour(1); });
    actions.add(
        {"animate.addAction",
         group,
         [] { return tr("Add to the s&toryboard"); },
         [] { return tr("Let the selected takes be performed in the animation, one after the other"); },
         "storyboard",
         {QKeySequence(Qt::SHIFT | Qt::Key_A)}},
        [this] { addTakes(); });
}

void KeysAndStoryboard::updateActions()
{
    const AnimationEntry* entry = m_animation.entry();
    const int keys = entry == nullptr ? 0 : static_cast<int>(keysOf(*entry).size());
    ActionRegistry& actions = m_animation.context().actions;
    if (m_selectedKey >= keys)
        selectKey(-1);
    actions.action(QStringLiteral("animate.removeKey"))->setEnabled(m_selectedKey >= 0);
    actions.action(QStringLiteral("animate.previousKey"))->setEnabled(keys > 0);
    actions.action(QStringLiteral("animate.nextKey"))->setEnabled(keys > 0);
    const bool hasTakes = !m_animation.context().document.project().sequences.empty();
    actions.action(QStringLiteral("animate.addKey"))->setEnabled(hasTakes);
    actions.action(QStringLiteral("animate.addAction"))
        ->setEnabled(!m_animation.context().selection.sequences().isEmpty());
}

void KeysAndStoryboard::fitDocks()
{
    constexpr int usualHeight = 150;
    const AnimationEntry* entry = m_animation.entry();
    const bool isEmpty = entry == nullptr || (keysOf(*entry).empty() && actionsOf(*entry).empty());
    auto* dock = qobject_cast<QDockWidget*>(m_storyboard->parentWidget());
    auto* window = qobject_cast<QMainWindow*>(m_animation.view().window());
    const bool hasCards = entry != nullptr && !actionsOf(*entry).empty();
    if (dock != nullptr && hasCards && m_animation.view().isVisible() &&
        dock->property(waitsForNeed).toBool()) {
        dock->setProperty(waitsForNeed, false); // who closes it again wants the room
        dock->show();
        dock->raise();
    }
    if (dock == nullptr || window == nullptr || dock->isFloating() || isEmpty == m_areDocksLow)
        return;
    m_areDocksLow = isEmpty;
    if (!isEmpty && dock->height() >= usualHeight)
        return;
    window->resizeDocks({dock}, {isEmpty ? dock->minimumSizeHint().height() : usualHeight}, Qt::Vertical);
    // At once: otherwise the next layout would do it, under the pen of who draws by then.
    window->layout()->invalidate();
    window->layout()->activate();
}

void KeysAndStoryboard::selectKey(int key)
{
    if (key == m_selectedKey)
        return;
    m_selectedKey = key;
    m_keys->selectKey(key);
    m_timeline->selectKey(key);
    updateActions();
}

void KeysAndStoryboard::goToNeighbour(int step)
{
    const AnimationEntry* entry = m_animation.entry();
    if (entry == nullptr)
        return;
    const std::vector<KeyEntry> keys = keysOf(*entry);
    const double fps = m_animation.context().document.project().settings.fps;
    const int here = m_animation.view().timeline().currentFrame();
    const int selected = m_selectedKey;
    // From the selected key on where it is the one that is shown, so that several near each other are all
    // reached.
    int next = -1;
    if (selected >= 0 && m_timeline->frameOfKey(selected) == here)
        next = selected + step;
    else if (step > 0)
        next = static_cast<int>(
            std::ranges::find_if(keys,
                                 [&](const KeyEntry& key) { return std::lround(key.time * fps) > here; }) -
            keys.begin());
    else
        next = static_cast<int>(std::ranges::count_if(
                   keys, [&](const KeyEntry& key) { return std::lround(key.time * fps) < here; })) -
               1;
    if (next < 0 || next >= static_cast<int>(keys.size()))
        return;
    selectKey(next);
    m_timeline->goToKey(next);
}

void KeysAndStoryboard::addTakes()
{
    std::vector<widgets::DraggedFrames> frames;
    for (const QString& name : m_animation.context().selection.sequences())
        frames.push_back({.sequence = name});
    m_storyboard->add(frames);
    if (m_animation.view().isVisible())
        Workspace::showPanel(m_storyboard);
    showStatus(tr("%n takes added to the storyboard of “%1”", nullptr, static_cast<int>(frames.size()))
                   .arg(m_animation.name()));
}

void KeysAndStoryboard::showStatus(const QString& text)
{
    constexpr int shownMilliseconds = 5000;
    if (auto* window = qobject_cast<QMainWindow*>(m_animation.view().window()))
        window->statusBar()->showMessage(text, shownMilliseconds);
}

} // namespace quadrille

#include "moc_keysandstoryboard.cpp"
