// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/media/opensequence.h"
#include "model/project/steps/resultsession.h"
#include "model/project/store/result.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// What a computing step may use.
struct StepContext
{
    /// The result of a step that this one lists as its input.
    std::function<ResultPointer(const std::string& step)> resultOf;
    /// The key of such a step: results of the same key are the same.
    std::function<std::string(const std::string& step)> keyOf;
    /// Something worth telling the user.
    std::function<void(Issue)> tell;
    /// Takes what may be shown until the result is there: a first part of it, or the best so far. Empty where
    /// nobody waits for such.
    std::function<void(const Result&)> improved = {};
    /// Whether a step that this one names as `along` is to be computed, too, and takes its result by `give`.
    /// Empty where nobody takes any.
    std::function<bool(const std::string& step)> isWanted = {};
    std::function<void(const std::string& step, Result result)> give = {};
    /// May be null.
    std::shared_ptr<ResultSession> session = nullptr;

    /// What is made of results of some steps, shared with other steps that want the same. \param settings
    /// all else that it depends on, as text.
    template <typename Value, typename Make>
    std::shared_ptr<Value> shared(const std::vector<std::string>& steps, const std::string& settings,
                                  const Make& make) const
    {
        return session == nullptr ? make() : session->shared<Value>(sharedName(steps, settings), make);
    }
    /// What was made so and is still there; null otherwise.
    template <typename Value>
    std::shared_ptr<Value> existing(const std::vector<std::string>& steps, const std::string& settings) const
    {
        return session == nullptr ? nullptr : session->existing<Value>(sharedName(steps, settings));
    }

    /// Lets go of what was made so and nobody uses, where memory is short.
    void forgetUnused() const
    {
        if (session != nullptr)
            session->forgetUnused();
    }

private:
    std::string sharedName(const std::vector<std::string>& steps, const std::string& settings) const
    {
        std::string name = settings + '\n';
        for (const std::string& step : steps)
            name += keyOf(step) + '\n';
        return name;
    }
};

/// One step of the rebuild: makes one result out of files, settings and results of other steps. The same
/// inputs give the same result, for any number of threads.
struct BuildStep
{
    /// Unique; its beginnings are targets: "sequences/walk/statistics" is rebuilt by `sequences`,
    /// `sequences/walk` and its full name.
    std::string name;
    /// Steps of one kind and key have the same result, whatever they are called; the name where empty.
    std::string kind;
    /// What stands before the names of its data: "sequences/walk" + "/bounds"; may be empty.
    std::string dataPrefix;
    /// The character that its data are about, where a name alone would not say.
    std::string character;
    /// Counts up whenever the algorithm gives another result.
    int version = 1;
    /// All else that the result depends on, as text.
    std::string settings;
    /// The files that it reads, in a fixed order; called once, may throw what opening them throws.
    std::function<std::vector<std::filesystem::path>(const Progress&)> files;
    /// About how many bytes its result takes; unset where that is little, or not known before.
    std::function<std::uint64_t(const Progress&)> bytes;
    /// Names of the steps whose results it uses.
    std::vector<std::string> inputs;
    /// Steps with the same inputs whose results this one can make with its own for less: they wait for it.
    std::vector<std::string> along;
    std::function<Result(const StepContext&, const Progress&)> compute;
};

/// What the steps of one rebuild share.
struct StepMaking
{
    std::shared_ptr<SequenceOpener> opener;
    std::filesystem::path projectFile;
    std::shared_ptr<ResultSession> session = nullptr; ///< may be null
};

std::vector<BuildStep> makeSequenceSteps(const StepMaking& making);
/// Pose distances, transitions and graphs of the characters that the section “graph” names, or that others
/// need them for.
std::vector<BuildStep> makeGraphSteps(const StepMaking& making);
/// Walks and clips of the section “animations”.
std::vector<BuildStep> makeAnimationSteps(const StepMaking& making);
/// Models, variations and their clips of the section “variations”.
std::vector<BuildStep> makeVariationSteps(const StepMaking& making);
/// Motion spaces of the section “motion_spaces”, how good they are, and what leads from one to another.
std::vector<BuildStep> makeMotionSpaceSteps(const StepMaking& making);
/// Clips of the section “live”.
std::vector<BuildStep> makeLiveSteps(const StepMaking& making);
/// Models of the section “appearance”, and the textures that they complete.
std::vector<BuildStep> makeAppearanceSteps(const StepMaking& making);
/// Clips of the section “transfers”.
std::vector<BuildStep> makeTransferSteps(const StepMaking& making);
/// Textures of the section “projections”.
std::vector<BuildStep> makeProjectionSteps(const StepMaking& making);
/// One picture of the project's sequences, contact-sheet.png among the results.
std::vector<BuildStep> makeSheetSteps(const StepMaking& making);

} // namespace quadrille
