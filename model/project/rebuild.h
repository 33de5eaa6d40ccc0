// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/writeguard.h"
#include "model/project/jsontext.h"
#include "model/project/stage.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

struct RebuildOptions
{
    /// Sections ("sequences"), entries ("exports/walk") or stages; everything when empty.
    std::vector<std::string> targets;
    int jobs = 0;        ///< threads; 0 for all
    bool force = false;  ///< compute what is fresh, too
    bool dryRun = false; ///< only say what would be computed
    WritePermissions permissions;
};

enum class StageState
{
    Fresh,    ///< was there already
    Stale,    ///< would be computed (dry run, status)
    Computed, ///< was computed
    Failed,
    Skipped, ///< an input of it failed
};

struct StageReport
{
    std::string stage;
    StageState state = StageState::Fresh;
    std::string reason; ///< why it is not fresh, English
    std::string key;
    double seconds = 0;
    std::vector<std::filesystem::path> files; ///< written outside of the store
    std::vector<Issue> issues;
    std::optional<Error> error; ///< of a failed stage
};

struct RebuildReport
{
    std::vector<StageReport> stages; ///< each after its inputs

    bool hasFailures() const;
    std::size_t count(StageState state) const;
};

/// Called when a stage is done, one call at a time, from any thread.
using StageListener = std::function<void(const StageReport&)>;

/// Brings results and exports up to date: what is stale by the hash of its inputs, and nothing else.
/// Independent stages run in parallel. A stage that fails stops those that need it, no others. The shared
/// media cache takes the size that the project's settings name. \throws Error ProjectUnknownTarget,
/// BadArgument (the results would lie elsewhere, by a link), Cancelled
/// (results finished by then stay; nothing is half-written).
RebuildReport rebuild(const Project& project, const std::filesystem::path& projectFile,
                      const RebuildOptions& options = {}, const Progress& progress = {},
                      const StageListener& listener = {});
/// \overload with other stages than those of the project.
RebuildReport rebuild(const std::vector<ResultStage>& stages, const std::filesystem::path& projectFile,
                      const RebuildOptions& options, const Progress& progress, const StageListener& listener);

std::string toString(StageState state);
/// {"stages": [{"stage", "state", "reason", "key", "seconds", "files", "issues", "error"}, …], "computed": n,
/// "fresh": n, "stale": n, "failed": n, "skipped": n}
Json toJson(const RebuildReport& report);

} // namespace quadrille
