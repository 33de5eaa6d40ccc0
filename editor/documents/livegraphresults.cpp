// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/livegraphresults.h"

#include "model/project/document/clipdependencies.h"

#include <utility>

namespace quadrille {

namespace {

constexpr std::chrono::milliseconds liveGraphDelay(300);

} // namespace

LiveGraphResults::LiveGraphResults(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : WantedResults(document, jobs, std::nullopt, liveGraphDelay, parent)
{
}

LiveGraphResults::~LiveGraphResults() = default;

void LiveGraphResults::retry(const QString& character)
{
    Item* const item = find<Item>(character);
    if (item != nullptr && wanted().contains(character))
        compute(character, *item);
}

void LiveGraphResults::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset)
        forget([](const QString& /*name*/, const ResultState& /*state*/) { return true; });
    else
        WantedResults::follow(event);
}

void LiveGraphResults::update()
{
    const Project& project = document().project();
    const auto isPlayable = [&](const QString& character) {
        return wanted().contains(character) && !playableSpaces(project, character.toStdString()).empty();
    };
    QStringList gone;
    for (const auto& [name, state] : states()) {
        if (!isPlayable(name))
            gone += name;
    }
    forget([&gone](const QString& name, const ResultState& /*state*/) { return gone.contains(name); });
    for (const QString& name : std::as_const(gone))
        emit changed(name);
    for (const QString& name : wanted()) {
        if (!isPlayable(name))
            continue;
        Item& item = make<Item>(name);
        Project basis = partsOfMotionSpaces(project, playableSpaces(project, name.toStdString()));
        if (item.made == basis)
            continue;
        item.made = std::move(basis);
        compute(name, item);
    }
}

void LiveGraphResults::compute(const QString& name, Item& item)
{
    item.phase = ResultPhase::Computing;
    emit changed(name);
    start(
        name, item, {.text = tr("Motion spaces")},
        [working = document().working(), name = name.toStdString()](const Progress& progress,
                                                                    const Post& /*post*/) {
            return openLiveGraph(ProjectResults(working), name, progress);
        },
        [this](const QString& current, OpenedLiveGraphPointer graph) {
            Item& done = *find<Item>(current);
            done.phase = ResultPhase::Ready;
            done.graph = std::move(graph);
        });
}

} // namespace quadrille

#include "moc_livegraphresults.cpp"
