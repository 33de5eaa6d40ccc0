// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/graphresults.h"

#include "model/project/document/madeclips.h"
#include "model/project/results/opencharacter.h"
#include "model/project/steps/charactersteps.h"

#include <utility>

namespace quadrille {

namespace {

constexpr std::chrono::milliseconds graphDelay(150);

} // namespace

GraphResults::GraphResults(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : WantedResults(document, jobs, std::nullopt, graphDelay, parent)
{
    GraphResults::update();
}

GraphResults::~GraphResults() = default;

QStringList GraphResults::characters() const
{
    const Project& project = document().project();
    QStringList names;
    for (const CharacterEntry& character : project.characters) {
        if (!sequencesOfGraph(project, character.name).empty())
            names += QString::fromStdString(character.name);
    }
    if (project.characters.empty() && !project.sequences.empty())
        names += QString();
    return names;
}

QString GraphResults::firstCharacter() const
{
    return characters().value(0);
}

void GraphResults::ask(const QString& character)
{
    if (isUpdateDue())
        updateNow();
    Item* const item = find<Item>(character);
    if (item == nullptr)
        return;
    const bool isOnlyOpening = item->phase == ResultPhase::Computing && !item->isWanted;
    item->isWanted = true;
    if (item->phase == ResultPhase::Idle || item->phase == ResultPhase::Failed || isOnlyOpening)
        open(character, *item);
}

void GraphResults::reopen()
{
    for (const auto& [character, state] : states()) {
        Item& item = static_cast<Item&>(*state);
        if (item.opened != nullptr)
            open(character, item);
    }
}

void GraphResults::follow(const ChangeEvent& event)
{
    WantedResults::follow(event);
    if (event.kind != ChangeEvent::Kind::Reset)
        return;
    forget([](const QString& /*character*/, const ResultState& /*state*/) { return true; });
    updateNow();
}

void GraphResults::update()
{
    const QStringList wanted = characters();
    forget(
        [&](const QString& character, const ResultState& /*state*/) { return !wanted.contains(character); });
    for (const QString& character : wanted) {
        Source source = sourceOf(character);
        Item& item = make<Item>(character);
        if (item.source == source)
            continue;
        item.source = std::move(source);
        open(character, item);
    }
}

GraphResults::Source GraphResults::sourceOf(const QString& character) const
{
    const Project& project = document().project();
    Source source{.graph = graphOf(project, character.toStdString()),
                  .settings = project.settings,
                  .characters = project.characters,
                  .sequences = project.sequences,
                  .animations = {},
                  .bodyParts = {},
                  .variations = {}};
    for (const SequenceEntry& sequence : project.sequences) {
        if (shownClip(project, sequence)) {
            source.animations = project.animations;
            source.bodyParts = project.bodyParts;
            source.variations = project.variations;
        }
    }
    return source;
}

void GraphResults::open(const QString& character, Item& item)
{
    item.phase = ResultPhase::Computing;
    item.overview.reset();
    const auto opening = item.isWanted ? GraphOpening::Compute : GraphOpening::IfFresh;
    start(
        character, item,
        {.text = character.isEmpty() ? tr("Graph") : tr("Graph of “%1”").arg(character),
         .background = !item.isWanted},
        [working = document().working(), character, opening](const Progress& progress, const Post& post) {
            return openCharacter(working, character.toStdString(), opening, progress,
                                 [&post](const std::shared_ptr<const CostOverview>& overview) {
                                     post([overview](const QString&, ResultState& state) {
                                         // It may come after the end of work that was stopped.
                                         if (state.phase == ResultPhase::Computing)
                                             static_cast<Item&>(state).overview = overview;
                                     });
                                 });
        },
        [this](const QString& name, std::shared_ptr<const OpenedCharacter> opened) {
            Item& done = *find<Item>(name);
            done.overview.reset();
            done.phase = opened == nullptr ? ResultPhase::Idle : ResultPhase::Ready;
            if (opened == nullptr)
                return;
            done.isWanted = true;
            done.opened = std::move(opened);
        });
}

void GraphResults::stopped(const QString& character, ResultState& state)
{
    WantedResults::stopped(character, state);
    find<Item>(character)->isWanted = false;
}

} // namespace quadrille

#include "moc_graphresults.cpp"
