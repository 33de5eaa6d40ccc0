// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/motionspaceresults.h"

#include "model/project/document/clipdependencies.h"
#include "model/project/document/findentry.h"

#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

constexpr std::chrono::milliseconds motionSpaceDelay(300);

} // namespace

MotionSpaceResults::MotionSpaceResults(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : WantedResults(document, jobs, Section::MotionSpaces, motionSpaceDelay, parent)
{
}

MotionSpaceResults::~MotionSpaceResults() = default;

void MotionSpaceResults::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset) {
        forget([](const QString& /*name*/, const ResultState& /*state*/) { return true; });
    } else {
        WantedResults::follow(event);
    }
}

/// Its name is part of a space: it is read again under the new one.
void MotionSpaceResults::renamed(const QString& /*before*/, const QString& name)
{
    Item* const item = find<Item>(name);
    if (item == nullptr)
        return;
    end(*item);
    item->made.reset();
}

void MotionSpaceResults::update()
{
    const Project& project = document().project();
    forget([&](const QString& name, const ResultState& /*state*/) {
        return !wanted().contains(name) || findMotionSpace(project, name.toStdString()) == nullptr;
    });
    for (const QString& name : wanted()) {
        const MotionSpaceEntry* entry = findMotionSpace(project, name.toStdString());
        if (entry == nullptr)
            continue;
        Item& item = make<Item>(name);
        Project basis = partsOfMotionSpaces(project, {entry->name});
        if (item.made == basis)
            continue;
        item.made = std::move(basis);
        if (entry->takes.empty()) {
            end(item);
            item.phase = ResultPhase::Impossible;
            item.result.reset();
            emit changed(name);
        } else {
            compute(name, item);
        }
    }
}

void MotionSpaceResults::compute(const QString& name, Item& item)
{
    item.phase = ResultPhase::Computing;
    emit changed(name);
    start(
        name, item, {.text = tr("Motion space “%1”").arg(name)},
        [working = document().working(), name = name.toStdString()](const Progress& progress,
                                                                    const Post& /*post*/) {
            return openMotionSpaceResult(ProjectResults(working), name, progress);
        },
        [this](const QString& current, MotionSpaceResultPointer result) {
            Item& done = *find<Item>(current);
            done.phase = ResultPhase::Ready;
            done.result = std::move(result);
        });
}

} // namespace quadrille

#include "moc_motionspaceresults.cpp"
