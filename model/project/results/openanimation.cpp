// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/openanimation.h"

#include "model/core/message.h"
#include "model/project/document/clipdependencies.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/steps/storedwalk.h"
#include "model/project/steps/variedrepeats.h"
#include "model/project/steps/walkrequest.h"
#include "model/project/store/clipresult.h"

#include <algorithm>
#include <chrono>

namespace quadrille {

namespace {

/// Makes what is shown of an animation.
class AnimationOpener
{
public:
    AnimationOpener(const AnimationEntry& entry, std::shared_ptr<const OpenedCharacter> character)
        : m_entry(entry), m_character(std::move(character))
    {
    }

    const CharacterGraph& graph() const { return m_character->graph; }

    /// With a clip made here and now, of the best walk so far and without variations.
    AnimationResultPointer draft(AnimationWalk walk, const Progress& progress) const
    {
        auto result = begun(std::move(walk));
        AnimationClip made =
            animationClip(m_entry, graph(), m_character->frames, planOf(*result), {}, progress);
        result->plan = std::move(made.plan);
        result->spans = std::move(made.spans);
        result->travel = made.processed.travel;
        result->framesBeforeRetime = made.processed.framesBeforeRetime;
        take(*result, std::move(made.processed.clip));
        return result;
    }

    /// With the clip that its step has made.
    AnimationResultPointer opened(AnimationWalk walk, const std::vector<std::string>& drawn,
                                  const FreshResults& results, const Progress& progress) const
    {
        auto result = begun(std::move(walk));
        if (m_entry.post.variations)
            result->variations = takeVariations(drawn, graph(), results.context());
        std::vector<std::string> names;
        std::span<const TakeVariation> variations;
        if (result->variations) {
            variations = *result->variations;
            for (const TakeVariation& variation : variations)
                names.push_back(variation.name);
        }
        PlannedClip planned =
            plannedClip(m_entry, graph(), m_character->frames, planOf(*result), variations, progress);
        result->plan = std::move(planned.plan);
        result->spans = std::move(planned.spans);
        const ResultPointer stored = results.resultOf(clipStepOf("animations/" + m_entry.name));
        auto clip = clipOf(*stored, m_character->frames.sequences(), graph().fps(), names);
        if (!clip)
            throw Error(ErrorCode::ResultReplaced, {.values = {{"stage", m_entry.name}}});
        const auto find = [&](const char* name) {
            const auto found = std::ranges::find(stored->arrays, name, &DataArray::name);
            return found == stored->arrays.end() ? nullptr : &*found;
        };
        if (const DataArray* travel = find("loop-travel"))
            result->travel = groundMotionOf(*travel);
        const std::int64_t frames = clip->frameCount();
        result->framesBeforeRetime = m_entry.post.steps.loop ? frames : std::max<std::int64_t>(frames - 1, 0);
        if (const DataArray* before = find("frames-before-retime"))
            result->framesBeforeRetime = std::get<std::vector<std::int64_t>>(before->values).front();
        take(*result, std::move(*clip));
        result->isFinal = true;
        return result;
    }

private:
    std::shared_ptr<AnimationResult> begun(AnimationWalk walk) const
    {
        auto result = std::make_shared<AnimationResult>();
        result->entry = m_entry;
        result->character = m_character;
        result->walk = std::move(walk);
        return result;
    }

    ClipPlan planOf(const AnimationResult& result) const
    {
        return animationPlan(m_entry, graph(), result.walk.solution, pathOf(m_entry, graph()));
    }

    void take(AnimationResult& result, Clip clip) const
    {
        result.origins = clip.origins;
        result.sequence = toSequence(m_entry.name, std::move(clip), m_character->frames);
    }

    const AnimationEntry& m_entry;
    std::shared_ptr<const OpenedCharacter> m_character;
};

[[noreturn]] void throwNoTakes(const std::string& name)
{
    throwInvalid("There are no takes that “animations/" + name + "” could be made from",
                 QUADRILLE_MESSAGE("Add the takes of its character under “sequences”."));
}

} // namespace

AnimationResultPointer openAnimation(WorkingProject working, const std::string& name,
                                     const Progress& progress,
                                     const std::function<void(AnimationResultPointer)>& better, double pause)
{
    constexpr double opening = 0.1;
    constexpr double searching = 0.6;
    constexpr double making = 0.95;
    const ProjectResults results(std::move(working));
    const AnimationEntry* entry = findAnimation(results.project(), name);
    if (entry == nullptr)
        throwInvalid("There is no animation “" + name + "”", QUADRILLE_MESSAGE("Correct the name."));
    const auto character = openCharacter(results, characterNameOf(results.project(), *entry),
                                         GraphOpening::Compute, progress.part(0, opening));
    if (character == nullptr)
        throwNoTakes(name);
    const AnimationOpener opener(*entry, character);
    const std::string walkStep = walkStepOf(name);
    const std::string clipStep = clipStepOf("animations/" + name);
    RebuildOptions seeking;
    std::optional<std::chrono::steady_clock::time_point> shown;
    if (better)
        seeking.improved = [&](const std::string& step, const Result& walk) {
            const auto now = std::chrono::steady_clock::now();
            if (step != walkStep || (shown && std::chrono::duration<double>(now - *shown).count() < pause))
                return;
            better(opener.draft(storedWalk(walk, *entry, opener.graph()), Progress(progress.token())));
            shown = std::chrono::steady_clock::now();
        };
    const FreshResults found = results.get({walkStep}, progress.part(opening, searching), seeking);
    AnimationWalk walk = storedWalk(*found.resultOf(walkStep), *entry, opener.graph());
    // Variations may have to be learned first.
    if (better && entry->post.variations && !results.getIfFresh({clipStep}))
        better(opener.draft(walk, Progress(progress.token())));
    const FreshResults made = results.get({clipStep}, progress.part(searching, making));
    return opener.opened(std::move(walk), clipsDrawnFrom(results.project(), *entry), made,
                         progress.part(making, 1));
}

} // namespace quadrille
