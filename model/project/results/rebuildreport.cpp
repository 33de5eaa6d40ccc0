// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/json/jsontext.h"
#include "model/project/results/rebuild.h"

#include <algorithm>

namespace quadrille {

namespace fs = std::filesystem;

bool RebuildReport::hasFailures() const
{
    return count(StepState::Failed) > 0;
}

std::size_t RebuildReport::count(StepState state) const
{
    return static_cast<std::size_t>(std::count_if(
        steps.begin(), steps.end(), [state](const StepReport& step) { return step.state == state; }));
}

std::string toString(StepState state)
{
    switch (state) {
    case StepState::Fresh:
        return "fresh";
    case StepState::Stale:
        return "stale";
    case StepState::Computed:
        return "computed";
    case StepState::Failed:
        return "failed";
    case StepState::Skipped:
        return "skipped";
    }
    return {};
}

Json toJson(const RebuildReport& report)
{
    Json json = Json::object();
    json["stages"] = Json::array();
    for (const StepReport& step : report.steps) {
        Json item = Json::object();
        item["stage"] = step.step;
        item["state"] = toString(step.state);
        item["reason"] = step.reason;
        item["key"] = step.key;
        item["seconds"] = step.seconds;
        item["files"] = Json::array();
        for (const fs::path& file : step.files)
            item["files"].push_back(file.generic_string());
        item["issues"] = Json::array();
        for (const Issue& issue : step.issues)
            item["issues"].push_back(issue.toString());
        item["error"] = step.error ? Json(step.error->what()) : Json(nullptr);
        json["stages"].push_back(std::move(item));
    }
    for (const StepState state :
         {StepState::Computed, StepState::Fresh, StepState::Stale, StepState::Failed, StepState::Skipped})
        json[toString(state)] = report.count(state);
    return json;
}

} // namespace quadrille
