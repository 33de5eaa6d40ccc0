// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/writeguard.h"
#include "model/project/document/project.h"

#include <filesystem>
#include <memory>

namespace quadrille {

/// What guards the files that are written for a project. All that the project reads stays as it is: its file
/// and backup, its results, and its media with what they name themselves, whether they are there yet or not.
/// Nothing leaves the project's folder; what earlier runs wrote may be replaced.
/// \param projectFile need not be there.
std::shared_ptr<WriteGuard> projectGuard(const Project& project, const std::filesystem::path& projectFile,
                                         WritePermissions permissions = {});

/// Remembers at its end with the results what a guard put, by path from the project and content, so that it
/// is known again: after a restart, and in a project that moved. A project that loses its results loses this,
/// too; then a file is known by being written with the same content once more. Failing is no failure: the
/// file is asked about another time.
class WrittenNote
{
public:
    WrittenNote(const WriteGuard& guard, std::filesystem::path projectFile)
        : m_guard(guard), m_projectFile(std::move(projectFile))
    {
    }
    ~WrittenNote();
    WrittenNote(const WrittenNote&) = delete;
    WrittenNote& operator=(const WrittenNote&) = delete;

private:
    const WriteGuard& m_guard;
    std::filesystem::path m_projectFile;
};

/// Refuses results that would be written elsewhere than into the project's folder because a symbolic link
/// leads out of it. \throws Error BadArgument.
void checkResultsPlace(const std::filesystem::path& projectFile, WritePermissions permissions);

} // namespace quadrille
