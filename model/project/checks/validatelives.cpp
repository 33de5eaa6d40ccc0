// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validatelives.h"

#include "model/core/contains.h"
#include "model/project/checks/sectionvalidator.h"

#include <string>
#include <vector>

namespace quadrille {

namespace {

class LiveValidator : SectionValidator
{
public:
    using SectionValidator::SectionValidator;

    void run(const LiveEntry& entry)
    {
        checkSpaces(entry);
        if (entry.inputs.empty())
            warn("/inputs", "Nothing is wanted in the performance " + quoted(entry.name),
                 "Record it in the editor.");
        if (entry.from > entry.ticks)
            invalid("/from", "The clip begins after the end of the performance", "Write a smaller tick.");
        std::int64_t next = 0;
        for (std::size_t i = 0; i < entry.inputs.size(); ++i) {
            const LiveChange& change = entry.inputs[i];
            const std::string key = "/inputs/" + std::to_string(i);
            if (change.input.space >= entry.spaces.size())
                invalid(key, "There is no space " + std::to_string(change.input.space),
                        "Write a number below " + std::to_string(entry.spaces.size()) + ".");
            if ((i == 0) != (change.tick == 0) || change.tick < next) {
                invalid(key, "Ticks of inputs must ascend from 0", "Sort them, and begin with 0.");
                break;
            }
            next = change.tick + 1;
        }
    }

private:
    void checkSpaces(const LiveEntry& entry)
    {
        const std::vector<std::string> known = namesOf(project().motionSpaces);
        std::vector<std::string> seen;
        for (std::size_t s = 0; s < entry.spaces.size(); ++s) {
            const std::string& name = entry.spaces[s];
            const std::string key = "/spaces/" + std::to_string(s);
            const MotionSpaceEntry* space = findMotionSpace(project(), name);
            if (space == nullptr)
                invalid(key, "There is no motion space " + quoted(name),
                        meantOr(name, known, "Correct the name."));
            else if (contains(seen, name))
                invalid(key, "The motion space " + quoted(name) + " is here twice", "Leave one of them out.");
            else if (characterNameOf(project(), *space) != characterNameOf(project(), entry))
                invalid(key, "The motion space " + quoted(name) + " is of another character",
                        "Name spaces of one character.");
            seen.push_back(name);
        }
    }
};

} // namespace

void validateLives(const Project& project, ProjectProblems& problems)
{
    for (std::size_t i = 0; i < project.lives.size(); ++i)
        LiveValidator(project, "/live/" + std::to_string(i), problems).run(project.lives[i]);
}

} // namespace quadrille
