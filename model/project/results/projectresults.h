// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/results/rebuild.h"
#include "model/project/store/resultstore.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// A project as it is at a moment, for those who work with its results.
struct WorkingProject
{
    Project project;
    std::filesystem::path file; ///< results lie beside it; it need not be there
    std::shared_ptr<ResultSession> session = std::make_shared<ResultSession>();
};

/// Results that were up to date when they were asked for; read one by one when they are needed. Safe from any
/// thread.
class FreshResults
{
public:
    FreshResults(const WorkingProject& working, const std::vector<BuildStep>& steps,
                 const RebuildReport& report);

    bool has(const std::string& step) const { return m_steps.contains(step); }
    /// \pre has(step). \throws Error ResultReplaced (somebody else has put another in its place meanwhile);
    /// as ResultStore::load.
    ResultPointer resultOf(const std::string& step) const;
    /// \pre has(step).
    const std::string& keyOf(const std::string& step) const { return m_steps.at(step).key; }
    /// For what is made of results as steps make it; tells nobody anything.
    StepContext context() const;

private:
    struct Step
    {
        std::string kind;
        std::string key;
    };

    std::shared_ptr<ResultSession> m_session;
    ResultStore m_store;
    std::map<std::string, Step> m_steps;
};

/// The way to results for all who work with a project: a rebuild, the editor, exports. What is up to date is
/// read, from memory where it is there; what is not is computed by its step, and stored for the others.
class ProjectResults
{
public:
    explicit ProjectResults(WorkingProject working);

    const Project& project() const { return m_working.project; }
    const WorkingProject& working() const { return m_working; }
    /// Opens the sequences of the project; sources are shared with other values of the project.
    const std::shared_ptr<SequenceOpener>& opener() const { return m_opener; }
    /// All that the project has, each after its inputs.
    const std::vector<BuildStep>& steps() const { return m_steps; }

    /// How some steps and their inputs stand, brought up to date before unless options say otherwise.
    /// \param options  targets and session are set here. \throws Error as rebuild.
    RebuildReport bring(const std::vector<std::string>& steps, const Progress& progress = {},
                        RebuildOptions options = {}) const;
    /// The results of a report that are up to date.
    FreshResults freshOf(const RebuildReport& report) const { return {m_working, m_steps, report}; }
    /// Results of some steps, brought up to date before. \throws Error of the step that failed, whose name is
    /// among its values as "step"; Cancelled; as rebuild.
    FreshResults get(const std::vector<std::string>& steps, const Progress& progress = {},
                     RebuildOptions options = {}) const;
    /// Nothing where one of them is not up to date; computes nothing. \throws Error Cancelled, of inputs that
    /// cannot be read.
    std::optional<FreshResults> getIfFresh(const std::vector<std::string>& steps,
                                           const Progress& progress = {}) const;

    /// What the store has of a step as it would be computed now, whether or not the results that it was made
    /// from are still there, which are not looked at; null where there is none. \throws Error Cancelled, of
    /// inputs that cannot be read.
    ResultPointer stored(const std::string& step, const Progress& progress = {}) const;

private:
    WorkingProject m_working;
    std::shared_ptr<SequenceOpener> m_opener;
    std::vector<BuildStep> m_steps;
};

} // namespace quadrille
