// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/stepstate.h"

#include "model/core/caughterror.h"
#include "model/core/contenthash.h"
#include "model/project/document/paths.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <set>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// Changes when results of all steps are to be computed again.
constexpr std::int64_t storeVersion = 1;

bool isMeant(const std::string& step, const std::string& target)
{
    return step == target || step.starts_with(target + "/");
}

/// What can be named: sections, entries and steps.
std::string knownTargets(const std::vector<BuildStep>& steps)
{
    std::set<std::string> known;
    for (const BuildStep& step : steps) {
        const auto section = step.name.find('/');
        known.insert(step.name.substr(0, section));
        if (section != std::string::npos)
            known.insert(step.name.substr(0, step.name.find('/', section + 1)));
    }
    std::string list;
    for (const std::string& target : known)
        list.append(list.empty() ? "" : ", ").append(target);
    return list;
}

std::string hashInputs(const BuildStep& step, FileHashes& hashes, const Progress& progress)
{
    ContentHasher hasher;
    const auto files = step.files ? step.files(progress.part(0, 0.5)) : std::vector<fs::path>{};
    hasher.add(static_cast<std::int64_t>(files.size()));
    for (std::size_t i = 0; i < files.size(); ++i) {
        progress.report(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(files.size()));
        hasher.add(hashes.of(files[i], progress));
    }
    return hasher.hex();
}

/// The first of a result's files that is not as it was written; empty when all are.
std::string changedFile(const std::vector<WrittenFile>& files, const fs::path& folder, FileHashes& hashes)
{
    for (const WrittenFile& file : files) {
        const fs::path path = resolvePath(file.path, folder);
        std::error_code error;
        if (!fs::exists(path, error) || hashes.of(path) != file.hash)
            return file.path;
    }
    return {};
}

void compareWithStore(StepStatus& status, const BuildStep& step, const ResultStore& store,
                      const fs::path& folder, FileHashes& hashes)
{
    auto standing = store.standing(step.name, status.key);
    switch (standing.state) {
    case ResultStore::State::Missing:
        status.reason = "there is no result yet";
        return;
    case ResultStore::State::OtherKey:
        status.reason = "its inputs or settings changed";
        return;
    case ResultStore::State::Damaged:
        status.isDamaged = true;
        status.reason = "the stored result is damaged";
        return;
    case ResultStore::State::Fresh:
        break;
    }
    const std::string changed = changedFile(standing.files, folder, hashes);
    status.isFresh = changed.empty();
    if (!status.isFresh)
        status.reason = changed + " is missing or was changed";
    status.files = std::move(standing.files);
}

} // namespace

std::vector<StepStatus> stepKeys(const std::vector<BuildStep>& steps, FileHashes& hashes,
                                 const Progress& progress)
{
    std::vector<StepStatus> all(steps.size());
    std::vector<std::string> inputHashes(steps.size());
    std::atomic<std::int64_t> done{0};
    const auto total = static_cast<std::int64_t>(steps.size());
    tbb::parallel_for(std::size_t{0}, steps.size(), [&](std::size_t i) {
        progress.report(done++, total);
        try {
            inputHashes[i] = hashInputs(steps[i], hashes, Progress(progress.token()));
        } catch (...) {
            all[i].error = caughtError();
            if (all[i].error->code() == ErrorCode::Cancelled)
                throw;
        }
    });
    std::map<std::string, std::size_t> byName;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        byName[steps[i].name] = i;
        ContentHasher hasher;
        hasher.add(storeVersion);
        hasher.add(static_cast<std::int64_t>(steps[i].version));
        hasher.add(steps[i].settings);
        hasher.add(inputHashes[i]);
        for (const std::string& input : steps[i].inputs)
            hasher.add(all[byName.at(input)].key);
        all[i].key = hasher.hex();
    }
    return all;
}

std::vector<StepStatus> stepStatus(const std::vector<BuildStep>& steps, const ResultStore& store,
                                   const fs::path& projectFolder, FileHashes& hashes,
                                   const Progress& progress)
{
    std::vector<StepStatus> all = stepKeys(steps, hashes, progress);
    tbb::parallel_for(std::size_t{0}, steps.size(), [&](std::size_t i) {
        progress.report(1);
        if (!all[i].error)
            compareWithStore(all[i], steps[i], store, projectFolder, hashes);
    });
    return all;
}

std::vector<BuildStep> selectSteps(const std::vector<BuildStep>& steps,
                                   const std::vector<std::string>& targets)
{
    std::set<std::string> wanted;
    for (const std::string& target : targets) {
        bool found = false;
        for (const BuildStep& step : steps) {
            if (isMeant(step.name, target)) {
                wanted.insert(step.name);
                found = true;
            }
        }
        if (!found)
            throw Error(ErrorCode::ProjectUnknownTarget,
                        {{}, {}, {{"what", target}, {"known", knownTargets(steps)}}});
    }
    std::vector<BuildStep> selected;
    for (std::size_t i = steps.size(); i-- > 0;) {
        if (!targets.empty() && wanted.count(steps[i].name) == 0)
            continue;
        wanted.insert(steps[i].inputs.begin(), steps[i].inputs.end());
        selected.push_back(steps[i]);
    }
    std::reverse(selected.begin(), selected.end());
    return selected;
}

} // namespace quadrille
