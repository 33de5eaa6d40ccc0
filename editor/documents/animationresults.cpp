// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/animationresults.h"

#include "model/project/document/clipdependencies.h"
#include "model/project/document/findentry.h"
#include "model/project/document/framenote.h"
#include "model/project/results/openanimation.h"

#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

constexpr std::chrono::milliseconds searchDelay(20);
/// Between the walks that are shown while a better one is sought; making a clip holds the search up.
constexpr double searchShowing = 0.7; // seconds

/// Sound and camera make no other frames.
AnimationEntry withoutSoundAndCamera(AnimationEntry entry)
{
    setNotes(entry.unknown, {});
    entry.audio.reset();
    entry.camera.clear();
    return entry;
}

/// The variations that an animation draws from, with their body parts; empty where it has no such option.
Project drawnFrom(const Project& project, const AnimationEntry& entry)
{
    Project drawn;
    if (!entry.post.variations)
        return drawn;
    Project parts = partsOfClip(project, "animations/" + entry.name);
    drawn.variations = std::move(parts.variations);
    drawn.bodyParts = std::move(parts.bodyParts);
    return drawn;
}

} // namespace

AnimationResults::AnimationResults(ProjectDocument& document, GraphResults& graphs, JobRunner& jobs,
                                   QObject* parent)
    : WantedResults(document, jobs, Section::Animations, searchDelay, parent), m_graphs(graphs)
{
    connect(&graphs, &GraphResults::changed, this, [this] { updateSoon(); });
}

AnimationResults::~AnimationResults() = default;

std::shared_ptr<const AnimationResult> AnimationResults::result(const QString& name) const
{
    const State* found = resultState(name);
    return found == nullptr ? nullptr : found->result;
}

QString AnimationResults::characterOf(const QString& name) const
{
    const AnimationEntry* entry = document().animation(name);
    return entry == nullptr ? QString()
                            : QString::fromStdString(characterNameOf(document().project(), *entry));
}

void AnimationResults::retry(const QString& name)
{
    Item* const item = find<Item>(name);
    if (item == nullptr)
        return;
    item->character.reset();
    update(name, *item);
}

void AnimationResults::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset ||
        (event.kind == ChangeEvent::Kind::Renamed && event.entry.section == Section::Animations))
        updateNow();
    else if (event.touches(Section::Animations) || event.touches(Section::Variations) ||
             event.touches(Section::BodyParts))
        updateSoon();
}

/// A clip bears the name of its animation: another search makes it under the new one.
void AnimationResults::renamed(const QString& /*before*/, const QString& name)
{
    Item* const item = find<Item>(name);
    if (item == nullptr)
        return;
    end(*item);
    item->character.reset();
}

void AnimationResults::update()
{
    forget([this](const QString& name, const ResultState& /*state*/) {
        return !wanted().contains(name) || document().animation(name) == nullptr;
    });
    for (const QString& name : wanted()) {
        if (document().animation(name) != nullptr)
            update(name, make<Item>(name));
    }
}

void AnimationResults::update(const QString& name, Item& item)
{
    const AnimationEntry entry = withoutSoundAndCamera(*document().animation(name));
    if (!entry.asksForSomething()) {
        end(item);
        item.solved = entry;
        item.result.reset();
        item.phase = ResultPhase::Idle;
        emit changed(name);
        return;
    }
    const QString character = characterOf(name);
    const GraphResults::State* graph = m_graphs.resultState(character);
    if (graph == nullptr || graph->phase != ResultPhase::Ready) {
        end(item);
        item.error = graph == nullptr ? std::nullopt : graph->error;
        item.phase = item.error ? ResultPhase::Failed : ResultPhase::Waiting;
        item.character.reset();
        if (graph != nullptr && graph->phase != ResultPhase::Failed)
            m_graphs.ask(character);
        emit changed(name);
        return;
    }
    Project drawn = drawnFrom(document().project(), entry);
    if (item.character == graph->opened && item.solved == entry && item.drawnFrom == drawn)
        return;
    item.character = graph->opened;
    item.drawnFrom = std::move(drawn);
    solve(name, item, entry);
}

void AnimationResults::solve(const QString& name, Item& item, const AnimationEntry& entry)
{
    item.solved = entry;
    item.phase = ResultPhase::Computing;
    start(
        name, item, {.text = tr("Animation “%1”").arg(name)},
        [working = document().working(), name](const Progress& progress, const Post& post) {
            const auto show = [&](AnimationResultPointer better) {
                post([better = std::move(better)](const QString& /*name*/, ResultState& state) {
                    if (state.phase != ResultPhase::Ready)
                        static_cast<Item&>(state).result = better;
                });
            };
            return openAnimation(working, name.toStdString(), progress, show, searchShowing);
        },
        [this](const QString& current, AnimationResultPointer result) {
            Item& done = *find<Item>(current);
            done.phase = ResultPhase::Ready;
            done.result = std::move(result);
        });
}

} // namespace quadrille

#include "moc_animationresults.cpp"
