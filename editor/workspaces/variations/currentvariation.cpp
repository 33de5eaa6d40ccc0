// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/currentvariation.h"

#include "editor/commands/variationedits.h"
#include "editor/context/editorcontext.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/core/error.h"
#include "model/project/document/findentry.h"
#include "model/variation/subject.h"
#include "widgets/theme/theme.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

CurrentVariation::CurrentVariation(EditorContext& context, SceneView& view, QObject* parent)
    : QObject(parent), m_context(context), m_view(view)
{
    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.touches(Section::Variations) || event.touches(Section::Sequences))
            emit changed();
        if (event.touches(Section::BodyParts) || event.touches(Section::Variations) ||
            event.touches(Section::Characters))
            emit bodyChanged();
    });
    connect(&context.selection, &Selection::changed, this, [this] {
        emit changed();
        emit bodyChanged();
        emit resultChanged();
    });
    connect(&context.variations, &VariationResults::changed, this, [this](const QString& name) {
        if (name == this->name())
            emit resultChanged();
    });
}

const QString& CurrentVariation::name() const
{
    return m_context.selection.shownVariation();
}

const VariationEntry* CurrentVariation::entry() const
{
    return m_context.document.variation(name());
}

QString CurrentVariation::character() const
{
    const Project& project = m_context.document.project();
    if (const VariationEntry* own = entry(); own != nullptr && !own->character.empty())
        return QString::fromStdString(own->character);
    const SequenceEntry* sequence = m_context.document.sequence(m_context.selection.shownSequence());
    const CharacterEntry* shown = sequence == nullptr ? nullptr : m_context.document.characterOf(*sequence);
    if (shown != nullptr && entry() == nullptr)
        return QString::fromStdString(shown->name);
    return project.characters.empty() ? QString() : QString::fromStdString(project.characters.front().name);
}

BodyPartsEntry CurrentVariation::body() const
{
    return bodyPartsEntry(m_context.document.project(), character());
}

const VariationResults::State* CurrentVariation::resultState() const
{
    return m_context.variations.resultState(name());
}

std::shared_ptr<const Movement> CurrentVariation::movement() const
{
    return resultState() == nullptr ? nullptr : resultState()->movement;
}

const std::vector<PartProgress>& CurrentVariation::parts() const
{
    static const std::vector<PartProgress> none;
    return resultState() == nullptr ? none : resultState()->parts;
}

QString CurrentVariation::stateText() const
{
    using Work = VariationResults::Work;
    if (entry() == nullptr)
        return tr("Add variations, then choose the takes to learn from.");
    if (entry()->training.empty())
        return tr("Check the takes to learn from in the panel Movement.");
    if (resultState() == nullptr)
        return {};
    switch (resultState()->phase) {
    case ResultPhase::Computing:
        switch (resultState()->work) {
        case Work::Opening:
            return tr("Aligning the takes…");
        case Work::Learning:
            return tr("Learning…");
        case Work::Drawing:
            return tr("Drawing variations…");
        }
        return {};
    case ResultPhase::Ready:
        return resultState()->isStopped ? tr("Learning was stopped.") : QString();
    case ResultPhase::Failed:
        return tr("It did not work.");
    default:
        return resultState()->isNotLearned() ? tr("The takes are aligned: learn to draw variations of them.")
                                             : tr("Aligning the takes was stopped.");
    }
}

int CurrentVariation::set() const
{
    const auto count = entry() == nullptr ? 0 : static_cast<int>(entry()->samples.size());
    return std::clamp(m_set, std::min(0, count - 1), count - 1);
}

void CurrentVariation::setSet(int set)
{
    if (set == m_set)
        return;
    m_set = set;
    m_hidden.clear();
    emit changed();
    emit resultChanged();
}

const SamplesEntry* CurrentVariation::samples() const
{
    return set() < 0 ? nullptr : &entry()->samples[static_cast<std::size_t>(set())];
}

std::vector<DrawnVariation> CurrentVariation::drawn() const
{
    const DrawnSet* own = drawnSet();
    if (own == nullptr)
        return {};
    std::vector<DrawnVariation> drawn = own->variations;
    for (DrawnVariation& each : drawn)
        each.isDiscarded = std::ranges::count(samples()->discarded, each.inSet) > 0;
    return drawn;
}

const DrawnSet* CurrentVariation::drawnSet() const
{
    if (samples() == nullptr || resultState() == nullptr || resultState()->drawn == nullptr)
        return nullptr;
    const auto& sets = *resultState()->drawn;
    const auto place = static_cast<std::size_t>(set());
    return place < sets.size() ? &sets[place] : nullptr;
}

std::optional<FrameRange> CurrentVariation::framesUsed() const
{
    const auto warp = shownWarp();
    if (!warp || !samples()->to.empty())
        return std::nullopt;
    return warp->frames;
}

void CurrentVariation::setHidden(int inSet, bool hidden)
{
    if (hidden == isHidden(inSet))
        return;
    if (hidden)
        m_hidden.insert(inSet);
    else
        m_hidden.remove(inSet);
    emit resultChanged();
}

void CurrentVariation::setOriginalShown(bool shown)
{
    m_isOriginalShown = shown;
    emit resultChanged();
}

QColor CurrentVariation::colorOf(int inSet)
{
    return widgets::Theme::categorical(inSet - 1);
}

std::optional<TakeWarp> CurrentVariation::shownWarp() const
{
    const auto own = movement();
    const SamplesEntry* set = samples();
    if (own == nullptr || set == nullptr)
        return std::nullopt;
    const auto indexOf = [&](const std::string& take) {
        std::size_t index = 0;
        while (index < own->capturedCount() && own->take(index).name != take)
            ++index;
        return index;
    };
    VariationSubject subject{.take = indexOf(set->of), .to = {}, .weight = set->weight, .across = {}};
    if (!set->to.empty())
        subject.to = indexOf(set->to);
    if (set->across)
        subject.across = {indexOf(set->across->of), indexOf(set->across->to), set->across->weight};
    try {
        std::vector<WarpShare> warps;
        for (const BlendShare& each : capturedShares(*own, subject))
            warps.push_back({&own->take(each.take).warp, each.share});
        return blendedWarp(warps);
    } catch (const Error&) {
        // Its takes are others by now.
        return std::nullopt;
    }
}

std::optional<double> CurrentVariation::referenceFrame() const
{
    const auto warp = shownWarp();
    if (!warp || warp->playback.empty())
        return std::nullopt;
    const std::int64_t last = static_cast<std::int64_t>(warp->playback.size()) - 1;
    const std::int64_t frame = std::clamp<std::int64_t>(m_view.player().frame().value, 0, last);
    return warp->playback[static_cast<std::size_t>(frame)];
}

void CurrentVariation::goToReference(double frame)
{
    const auto warp = shownWarp();
    if (!warp || warp->playback.empty())
        return;
    const auto nearest = std::ranges::min_element(
        warp->playback, {}, [frame](double position) { return std::abs(position - frame); });
    m_view.player().pause();
    m_view.player().goTo(nearest - warp->playback.begin());
}

void CurrentVariation::edit(const QString& text, const QString& property, const Edit& edit, EditPhase phase)
{
    const QString edited = entry() == nullptr ? add() : name();
    const VariationEntry* before = m_context.document.variation(edited);
    if (before == nullptr)
        return;
    VariationEntry after = *before;
    edit(after);
    setVariation(m_context.document, edited, text, property, std::move(after), phase);
}

void CurrentVariation::editSet(const QString& text, const char* property, const SetEdit& edit,
                               EditPhase phase)
{
    if (samples() == nullptr)
        return;
    const int edited = set();
    this->edit(
        text, QLatin1String(property) + QString::number(edited),
        [&](VariationEntry& entry) { edit(entry.samples[static_cast<std::size_t>(edited)]); }, phase);
}

void CurrentVariation::editBody(const QString& text, const QString& property, const BodyEdit& edit,
                                EditPhase phase)
{
    BodyPartsEntry after = body();
    edit(after);
    setBodyParts(m_context.document, text, property, after, phase);
}

QString CurrentVariation::add()
{
    VariationEntry variation;
    variation.name = tr("variations").toStdString();
    if (m_context.document.project().characters.size() > 1)
        variation.character = character().toStdString();
    QString added = addVariation(m_context.document, std::move(variation));
    m_context.selection.select({Section::Variations, added});
    return added;
}

} // namespace quadrille

#include "moc_currentvariation.cpp"
