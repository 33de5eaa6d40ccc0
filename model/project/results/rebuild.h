// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/writeguard.h"
#include "model/project/json/json.h"
#include "model/project/steps/buildstep.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

struct RebuildOptions
{
    /// Sections ("sequences"), entries ("exports/walk") or steps; everything when empty.
    std::vector<std::string> targets;
    int jobs = 0;       ///< threads; 0 for all
    bool force = false; ///< compute what is fresh, too
    /// Only say what would be computed. What the session has is stored all the same.
    bool dryRun = false;
    WritePermissions permissions;
    /// What is shared with others who work with the project; null: nothing.
    std::shared_ptr<ResultSession> session = nullptr;
    /// Results are kept by the session alone, as far as it has room: stored by a rebuild that comes to the
    /// same key. \pre There is a session.
    bool onlyInMemory = false;
    /// Receives what a step gives before it is through, see StepContext; from any thread.
    std::function<void(const std::string& step, const Result& result)> improved = {};
};

enum class StepState
{
    Fresh,    ///< was there already
    Stale,    ///< would be computed (dry run, status)
    Computed, ///< was computed
    Failed,
    Skipped, ///< an input of it failed
};

struct StepReport
{
    std::string step;
    StepState state = StepState::Fresh;
    std::string reason; ///< why it is not fresh, English
    std::string key;
    double seconds = 0;
    std::vector<std::filesystem::path> files; ///< written outside of the store
    std::vector<Issue> issues;
    std::optional<Error> error; ///< of a failed step
};

struct RebuildReport
{
    std::vector<StepReport> steps; ///< each after its inputs

    bool hasFailures() const;
    std::size_t count(StepState state) const;
};

/// Called when a step is done, one call at a time, from any thread.
using StepListener = std::function<void(const StepReport&)>;

/// Brings results and exports up to date: what is stale by the hash of its inputs, and nothing else.
/// Independent steps run in parallel. A step that fails stops those that need it, no others. The shared
/// media cache takes the size that the project's settings name. \throws Error ProjectUnknownTarget,
/// BadArgument (the results would lie elsewhere, by a link), Cancelled
/// (results finished by then stay; nothing is half-written).
RebuildReport rebuild(const Project& project, const std::filesystem::path& projectFile,
                      const RebuildOptions& options = {}, const Progress& progress = {},
                      const StepListener& listener = {});
/// \overload with other steps than those of the project.
RebuildReport rebuild(const std::vector<BuildStep>& steps, const std::filesystem::path& projectFile,
                      const RebuildOptions& options, const Progress& progress, const StepListener& listener);

std::string toString(StepState state);
/// {"stages": [{"stage", "state", "reason", "key", "seconds", "files", "issues", "error"}, …], "computed": n,
/// "fresh": n, "stale": n, "failed": n, "skipped": n}
Json toJson(const RebuildReport& report);

} // namespace quadrille
