// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validatemotionspaces.h"

#include "model/core/contains.h"
#include "model/project/checks/sectionvalidator.h"

namespace quadrille {

namespace {

class MotionSpaceValidator : SectionValidator
{
public:
    using SectionValidator::SectionValidator;

    void run(const MotionSpaceEntry& entry)
    {
        checkTakes(entry);
        checkParameters(entry);
        if (!entry.reference.empty() && !contains(m_takes, entry.reference))
            invalid("/reference", quoted(entry.reference) + " is none of the takes of the motion space",
                    meantOr(entry.reference, m_takes, "Name it under “takes”, too."));
    }

private:
    void checkTakes(const MotionSpaceEntry& entry)
    {
        const std::vector<std::string> own = sequencesOf(characterNameOf(project(), entry));
        if (entry.takes.empty())
            warn("", "The motion space " + quoted(entry.name) + " has no takes", "Name them under “takes”.");
        if (entry.takes.size() > WeightSpace::mostTakes)
            invalid("/takes", "A motion space has at most 8 takes", "Leave some of them out.");
        for (std::size_t i = 0; i < entry.takes.size(); ++i) {
            const SpaceTakeEntry& take = entry.takes[i];
            const std::string key = "/takes/" + std::to_string(i);
            if (!contains(own, take.sequence))
                invalid(key, "There is no sequence " + quoted(take.sequence) + " of the character",
                        meantOr(take.sequence, own, "Correct the name."));
            if (!take.place.empty() && take.place.size() != entry.parameters.size())
                warn(key + "/place",
                     "The place of " + quoted(take.sequence) +
                         " has another number of values than the "
                         "motion space has parameters",
                     "Write one for each parameter, or leave it out.");
            m_takes.push_back(take.sequence);
        }
    }

    void checkParameters(const MotionSpaceEntry& entry)
    {
        const std::size_t count = entry.parameters.size();
        if (count > MotionSpaceEntry::mostParameters)
            invalid("/parameters", "A motion space has at most 3 parameters", "Leave some of them out.");
        else if (count == 0 && entry.takes.size() > 1)
            warn("/parameters",
                 "Nothing is said of what the takes of the motion space " + quoted(entry.name) + " differ in",
                 "Name a parameter, such as their speed.");
        else if (count > 0 && entry.takes.size() <= count)
            warn("/takes",
                 "A motion space of so many parameters needs " + std::to_string(count + 1) + " takes or more",
                 "Add takes, or leave a parameter out.");
        for (std::size_t i = 0; i < count; ++i)
            checkParameter(entry, i, "/parameters/" + std::to_string(i));
    }

    void checkParameter(const MotionSpaceEntry& entry, std::size_t index, const std::string& key)
    {
        const SpaceParameterEntry& parameter = entry.parameters[index];
        if (isOfVertex(parameter.measure) != parameter.vertex.has_value())
            warn(key,
                 isOfVertex(parameter.measure)
                     ? "Nothing is said of which vertex the parameter " + quoted(parameter.name) + " measures"
                     : "The parameter " + quoted(parameter.name) + " measures no vertex",
                 isOfVertex(parameter.measure) ? "Write its number as “vertex”." : "Leave “vertex” out.");
        if (parameter.measure != SpaceMeasure::ByHand)
            return;
        for (const SpaceTakeEntry& take : entry.takes) {
            if (take.place.empty())
                warn(key,
                     quoted(take.sequence) + " has no place on the axis " + quoted(parameter.name) +
                         ", which is not measured",
                     "Write its “place”.");
        }
    }

    std::vector<std::string> m_takes;
};

} // namespace

void validateMotionSpaces(const Project& project, ProjectProblems& problems)
{
    for (std::size_t i = 0; i < project.motionSpaces.size(); ++i)
        MotionSpaceValidator(project, "/motion_spaces/" + std::to_string(i), problems)
            .run(project.motionSpaces[i]);
}

} // namespace quadrille
