// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/editcheck.h"

#include "editor/documents/projectcommand.h"
#include "model/project/file/usableproject.h"

#include <algorithm>
#include <charconv>

namespace quadrille {

namespace {

bool areAlike(const ProjectProblem& a, const ProjectProblem& b)
{
    return a.code == b.code && a.context.values == b.context.values;
}

/// The entry that a JSON pointer leads into where the edit left it as it was: a bystander, as "waltz".
template <typename Entry>
std::optional<std::string> bystander(const std::vector<Entry>& before, const std::vector<Entry>& after,
                                     const std::string& section, const std::string& pointer)
{
    const std::string head = "/" + section + "/";
    std::size_t place = 0;
    const char* end = pointer.c_str() + pointer.size();
    if (!pointer.starts_with(head) ||
        std::from_chars(pointer.c_str() + head.size(), end, place).ec != std::errc() || place >= after.size())
        return std::nullopt;
    const bool wasThere = std::ranges::find(before, after[place]) != before.end();
    return wasThere ? std::optional(after[place].name) : std::nullopt;
}

} // namespace

std::optional<Error> refusalOf(const Project& before, const Project& after)
{
    ProjectProblems problems = problemsWhenSaved(after);
    if (problems.empty())
        return std::nullopt;
    const ProjectProblems known = problemsWhenSaved(before);
    const auto isNew = [&](const ProjectProblem& problem) {
        return std::ranges::none_of(known, [&](const ProjectProblem& old) { return areAlike(problem, old); });
    };
    const auto found = std::ranges::find_if(problems, isNew);
    if (found == problems.end())
        return std::nullopt;
    sectionlists::forEachNamed(after, [&]<typename Entry>(Section section, const std::vector<Entry>& is) {
        if (const auto other =
                bystander(entriesOf<Entry>(before), is, findSection(section)->key, found->pointer))
            found->context.file = *other;
    });
    return Error(found->code, found->context);
}

EditRefusals& EditRefusals::of(ProjectDocument& document)
{
    auto* refusals = document.findChild<EditRefusals*>(QString(), Qt::FindDirectChildrenOnly);
    return refusals != nullptr ? *refusals : *new EditRefusals(&document);
}

void EditRefusals::refuse(const Error& error)
{
    ++m_count;
    emit refused(error);
}

bool wasTaken(ProjectDocument& document, std::unique_ptr<ProjectCommand> command)
{
    const EditRefusals& refusals = EditRefusals::of(document);
    const int before = refusals.count();
    document.push(std::move(command));
    return refusals.count() == before;
}

} // namespace quadrille

#include "moc_editcheck.cpp"
