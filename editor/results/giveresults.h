// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

class QWidget;

namespace quadrille {

class IssueLog;
class JobRunner;

/// Gives the results of a project to the name that it is about to be saved under, so that nothing is computed
/// again: by links where the file system has them, else copied by a job, with progress that the user can
/// skip. What hinders it goes to the issues and no further; the results can be computed again. Returns when
/// that is done; while a job copies, an event loop runs. \param window what the progress belongs to.
void giveResults(const std::filesystem::path& fromProject, const std::filesystem::path& toProject,
                 JobRunner& jobs, IssueLog& issues, QWidget* window);

} // namespace quadrille
