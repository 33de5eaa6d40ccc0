// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/problem.h"

#include <algorithm>

namespace quadrille {

ProjectProblem invalidAt(std::string pointer, std::string reason, std::string remedy)
{
    ProjectProblem problem;
    problem.context.values = {{"reason", std::move(reason)}, {"remedy", std::move(remedy)}};
    problem.pointer = std::move(pointer);
    return problem;
}

ProjectProblem warningAt(std::string pointer, std::string reason, std::string remedy)
{
    auto problem = invalidAt(std::move(pointer), std::move(reason), std::move(remedy));
    problem.severity = ProjectProblem::Severity::Warning;
    return problem;
}

bool hasErrors(const ProjectProblems& problems)
{
    return std::any_of(problems.begin(), problems.end(), [](const ProjectProblem& problem) {
        return problem.severity == ProjectProblem::Severity::Error;
    });
}

} // namespace quadrille
