// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/appearanceresults.h"

#include "model/project/store/appearanceresult.h"

#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

constexpr std::chrono::milliseconds appearanceDelay(200);

bool isComputed(const AppearanceResults::State& state)
{
    return state.phase == ResultPhase::Computing && state.work != AppearanceResults::Work::Looking;
}

} // namespace

AppearanceResults::AppearanceResults(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : WantedResults(document, jobs, Section::Appearances, appearanceDelay, parent)
{
}

AppearanceResults::~AppearanceResults() = default;

void AppearanceResults::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset) {
        forget([](const QString& /*name*/, const ResultState& /*state*/) { return true; });
    } else if (event.kind == ChangeEvent::Kind::Renamed && event.entry.section == Section::Appearances) {
        updateNow();
    } else {
        WantedResults::follow(event);
    }
    if (event.touches(Section::Appearances))
        followVaried(event.kind != ChangeEvent::Kind::Reset);
}

void AppearanceResults::followVaried(bool tells)
{
    const QHash<QString, VariedTextures> before = std::exchange(m_varied, {});
    QStringList changed;
    for (const AppearanceEntry& entry : document().project().appearances) {
        const QString name = QString::fromStdString(entry.name);
        m_varied.insert(name, entry.varied);
        if (before.value(name, entry.varied) != entry.varied)
            changed += name;
    }
    for (const QString& name : std::as_const(changed)) {
        if (tells)
            emit texturesMade(name);
    }
}

/// Results bear the name of their entry.
void AppearanceResults::renamed(const QString& /*before*/, const QString& name)
{
    Item* const item = find<Item>(name);
    if (item == nullptr)
        return;
    end(*item);
    item->phase = ResultPhase::Idle;
    item->opened.reset();
    item->looked.reset();
}

/// Whatever a model and its completions depend on.
Project AppearanceResults::basisOf(const QString& name) const
{
    const Project& project = document().project();
    Project basis;
    basis.settings = project.settings;
    basis.settings.cacheMegabytes = 0;
    basis.characters = project.characters;
    basis.sequences = project.sequences;
    for (SequenceEntry& sequence : basis.sequences) {
        sequence.labels.clear();
        sequence.contacts.clear();
    }
    basis.appearances = {*findAppearance(project, name.toStdString())};
    if (learnsPoses(project, basis.appearances.front()))
        basis.variations.emplace_back(); // that there are some is all that counts
    return basis;
}

void AppearanceResults::update()
{
    const Project& project = document().project();
    forget([&](const QString& name, const ResultState& state) {
        const bool isThere = findAppearance(project, name.toStdString()) != nullptr;
        return !isThere || (!wanted().contains(name) && !isComputed(static_cast<const Item&>(state)));
    });
    for (const QString& name : wanted()) {
        if (findAppearance(project, name.toStdString()) == nullptr)
            continue;
        Item& item = make<Item>(name);
        if (!isComputed(item) && item.looked != basisOf(name))
            look(name, item);
    }
}

AppearanceJob AppearanceResults::jobOf(const QString& name, const Item& item) const
{
    return {document().working(), name.toStdString(), item.opened};
}

void AppearanceResults::look(const QString& name, Item& item)
{
    item.looked = basisOf(name);
    item.phase = ResultPhase::Computing;
    item.work = Work::Looking;
    start(
        name, item, {.text = tr("Looking for the textures of “%1”").arg(name), .background = true},
        [job = jobOf(name, item)](const Progress& progress, const Post& /*post*/) {
            return openAppearance(job, progress);
        },
        [this](const QString& current, OpenedAppearancePointer opened) {
            take(*find<Item>(current), std::move(opened));
        });
}

void AppearanceResults::build(const QString& name)
{
    compute(name, Work::Building);
}

void AppearanceResults::complete(const QString& name)
{
    const AppearanceEntry* entry = findAppearance(document().project(), name.toStdString());
    if (entry != nullptr && !entry->completions.empty())
        compute(name, Work::Completing);
}

void AppearanceResults::compute(const QString& name, Work work)
{
    if (isUpdateDue())
        updateNow();
    Item* const item = find<Item>(name);
    if (item == nullptr || isComputed(*item))
        return;
    item->looked = basisOf(name);
    item->phase = ResultPhase::Computing;
    item->work = work;
    const bool completes = work == Work::Completing;
    start(
        name, *item,
        {.text = (completes ? tr("Completing textures by “%1”") : tr("Textures of “%1”")).arg(name)},
        [job = jobOf(name, *item), completes](const Progress& progress, const Post& /*post*/) {
            return completes ? completeAppearance(job, progress) : buildAppearanceModel(job, progress);
        },
        [this](const QString& current, OpenedAppearancePointer opened) {
            take(*find<Item>(current), std::move(opened));
            emit texturesMade(current);
            updateSoon(); // the project may be another by now
        });
}

void AppearanceResults::take(Item& item, OpenedAppearancePointer opened)
{
    item.opened = std::move(opened);
    item.phase = item.opened->isFresh ? ResultPhase::Ready : ResultPhase::Stale;
}

/// What was there before counts again.
void AppearanceResults::stopped(const QString& /*name*/, ResultState& state)
{
    Item& item = static_cast<Item&>(state);
    item.phase = ResultPhase::Stale;
    item.looked.reset();
    updateSoon();
}

} // namespace quadrille

#include "moc_appearanceresults.cpp"
