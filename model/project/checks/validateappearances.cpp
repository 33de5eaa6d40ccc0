// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validateappearances.h"

#include "model/core/contains.h"
#include "model/project/checks/sectionvalidator.h"

#include <algorithm>

namespace quadrille {

namespace {

class AppearanceValidator : SectionValidator
{
public:
    using SectionValidator::SectionValidator;

    void run(const AppearanceEntry& entry)
    {
        m_own = sequencesOf(characterNameOf(project(), entry));
        for (std::size_t i = 0; i < entry.sequences.size(); ++i) {
            const std::string key = "/sequences/" + std::to_string(i);
            checkSequence(entry.sequences[i], key);
            if (std::count(entry.sequences.begin(), entry.sequences.end(), entry.sequences[i]) > 1 && i > 0)
                warn(key, "The sequence " + quoted(entry.sequences[i]) + " is here twice",
                     "Leave one of them out.");
        }
        if (entry.reference)
            checkFrame(*entry.reference, "/reference");
        for (std::size_t i = 0; i < entry.completions.size(); ++i)
            checkCompletion(entry.completions[i], "/completions/" + std::to_string(i));
    }

private:
    void checkSequence(const std::string& name, const std::string& key)
    {
        if (!contains(m_own, name))
            invalid(key, "There is no sequence " + quoted(name) + " of the character",
                    meantOr(name, m_own, "Correct the name."));
    }

    /// That there is such a sequence is checked with the fields.
    void checkFrame(const NamedFrame& frame, const std::string& key)
    {
        if (findSequence(project(), frame.sequence) != nullptr)
            checkSequence(frame.sequence, key + "/sequence");
    }

    void checkCompletion(const CompletionEntry& completion, const std::string& key)
    {
        checkFrame(completion.frame, key + "/frame");
        for (std::size_t i = 0; i < completion.strokes.size(); ++i) {
            const std::vector<double>& points = completion.strokes[i].points;
            if (points.empty() || points.size() % 2 != 0)
                invalid(key + "/strokes/" + std::to_string(i) + "/points",
                        "A stroke has u and v of at least one point", "Write [u, v, u, v, …].");
        }
    }

    std::vector<std::string> m_own;
};

} // namespace

void validateAppearances(const Project& project, ProjectProblems& problems)
{
    for (std::size_t i = 0; i < project.appearances.size(); ++i)
        AppearanceValidator(project, "/appearance/" + std::to_string(i), problems)
            .run(project.appearances[i]);
}

} // namespace quadrille
