// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/findentry.h"
#include "model/project/document/problemtexts.h"

#include <string>
#include <utility>
#include <vector>

namespace quadrille {

/// What the checks of entries of several sections have in common.
class SectionValidator
{
public:
    /// \param pointer  to the entry: "/variations/0".
    SectionValidator(const Project& project, std::string pointer, ProjectProblems& problems)
        : m_project(project), m_pointer(std::move(pointer)), m_problems(problems)
    {
    }

protected:
    void invalid(const std::string& key, std::string reason, std::string remedy = {})
    {
        m_problems.push_back(invalidAt(m_pointer + key, std::move(reason), std::move(remedy)));
    }
    void warn(const std::string& key, std::string reason, std::string remedy = {})
    {
        m_problems.push_back(warningAt(m_pointer + key, std::move(reason), std::move(remedy)));
    }

    const Project& project() const { return m_project; }

    /// Names of the sequences of a character.
    std::vector<std::string> sequencesOf(const std::string& character) const
    {
        std::vector<std::string> own;
        for (const SequenceEntry& sequence : m_project.sequences) {
            const CharacterEntry* of = characterOf(m_project, sequence);
            if ((of ? of->name : "") == character)
                own.push_back(sequence.name);
        }
        return own;
    }

private:
    const Project& m_project;
    std::string m_pointer;
    ProjectProblems& m_problems;
};

} // namespace quadrille
