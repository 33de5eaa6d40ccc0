// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/livegraphresults.h"

#include "model/project/document/clipdependencies.h"

#include <utility>

namespace quadrille {

namespace {

constexpr std::chrono::milliseconds liveGraphDelay(300);

/// All that the spaces depend on.
Project basisOf(const Project& project, const std::vector<std::string>& spaces)
{
    Project asked = project;
    LiveEntry all;
    all.name = "all";
    all.spaces = spaces;
    asked.lives = {all};
    return partsOfClip(asked, "live/all");
}

} // namespace

LiveGraphResults::LiveGraphResults(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : WantedResults(document, jobs, std::nullopt, liveGraphDelay, parent)
{
}

LiveGraphResults::~LiveGraphResults() = default;

void LiveGraphResults::want(const QString& character)
{
    if (m_wanted == character && m_wanted.isNull() == character.isNull())
        return;
    m_wanted = character;
    updateNow();
}

void LiveGraphResults::retry(const QString& character)
{
    Item* const item = find<Item>(character);
    if (item != nullptr && m_wanted == character)
        compute(character, *item);
}

void LiveGraphResults::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset) {
        m_wanted = QString();
        forget([](const QString& /*name*/, const ResultState& /*state*/) { return true; });
    } else {
        WantedResults::follow(event);
    }
}

void LiveGraphResults::update()
{
    const Project& project = document().project();
    const std::vector<std::string> spaces = playableSpaces(project, m_wanted.toStdString());
    const bool isPlayable = !m_wanted.isNull() && !spaces.empty();
    QStringList gone;
    for (const auto& [name, state] : states()) {
        if (!isPlayable || name != m_wanted)
            gone += name;
    }
    forget([&gone](const QString& name, const ResultState& /*state*/) { return gone.contains(name); });
    for (const QString& name : std::as_const(gone))
        emit changed(name);
    if (!isPlayable)
        return;
    Item& item = make<Item>(m_wanted);
    Project basis = basisOf(project, spaces);
    if (item.made == basis)
        return;
    item.made = std::move(basis);
    compute(m_wanted, item);
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
