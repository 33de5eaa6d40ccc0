// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/check.h"

#include "model/core/file.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/exports/exportclaims.h"
#include "model/project/file/projectfile.h"
#include "model/project/json/jsontext.h"
#include "model/project/media/media.h"
#include "model/project/media/projectguard.h"
#include "model/project/results/makesteps.h"
#include "model/project/results/stepstate.h"
#include "model/project/store/resultplaces.h"

#include <set>

namespace quadrille {

namespace {

class Checker
{
public:
    Checker(const std::filesystem::path& file, const Progress& progress, bool allowsOutside)
        : m_file(file)
        , m_allowsOutside(allowsOutside)
        , m_folder(projectFolder(file))
        , m_progress(progress)
        , m_json(parseJson(readFile(file).text(), file))
    {
    }

    CheckReport run()
    {
        ProjectReading reading = readProject(m_file);
        m_report.problems = reading.problems;
        if (hasErrors(reading.problems))
            return std::move(m_report);
        m_project = std::move(reading.project);
        checkMedia();
        checkSequences();
        checkExports();
        checkResults();
        return std::move(m_report);
    }

private:
    void add(ProjectProblem problem)
    {
        problem.context.file = m_file;
        problem.context.place = m_json.placeOf(problem.pointer);
        m_report.problems.push_back(std::move(problem));
    }

    /// An error of another file, found at a place of the project.
    void add(const Error& error, const std::string& pointer)
    {
        if (error.code() == ErrorCode::Cancelled)
            throw error;
        add(invalidAt(pointer, withoutStop(error.what())));
    }

    static std::string withoutStop(std::string text)
    {
        if (text.ends_with('.'))
            text.pop_back();
        return text;
    }

    void checkMedia()
    {
        for (const MediaUse& use : mediaOf(m_project, m_folder)) {
            if (use.exists)
                continue;
            ProjectProblem problem;
            problem.code = ErrorCode::ProjectMissingMedia;
            problem.context.values = {{"what", use.owner}, {"path", use.path}};
            problem.pointer = use.pointer;
            m_lost.insert(use.pointer);
            add(std::move(problem));
        }
    }

    bool lacksMedia(const std::string& pointer) const
    {
        const auto at = m_lost.lower_bound(pointer + "/");
        return at != m_lost.end() && at->starts_with(pointer + "/");
    }

    void checkSequences()
    {
        m_opener = std::make_shared<SequenceOpener>(m_project, m_folder);
        const auto count = static_cast<std::int64_t>(m_project.sequences.size());
        for (std::int64_t i = 0; i < count; ++i) {
            m_progress.report(0.8 * static_cast<double>(i) / static_cast<double>(count));
            const std::string pointer = "/sequences/" + std::to_string(i);
            const SequenceEntry& entry = m_project.sequences[static_cast<std::size_t>(i)];
            if (lacksMedia(pointer) || shownClip(m_project, entry))
                continue;
            try {
                const auto opened = m_opener->open(entry.name, Progress(m_progress.token()));
                for (const Issue& issue : opened->issues) {
                    if (issue.severity == Issue::Severity::Warning)
                        add(warningAt(pointer, withoutStop(issue.toString())));
                }
            } catch (const Error& error) {
                add(error, pointer);
            }
        }
    }

    void checkExports()
    {
        const auto guard = projectGuard(m_project, m_file, {.outside = m_allowsOutside});
        for (std::size_t i = 0; i < m_project.exports.size(); ++i) {
            const ExportEntry& entry = m_project.exports[i];
            const std::string pointer = "/exports/" + std::to_string(i);
            try {
                checkOutputs(m_project, entry, m_project.exports, m_folder, *guard);
            } catch (const Error& error) {
                const bool isFormat = error.code() == ErrorCode::FormatUnknown && !entry.format.empty();
                add(error, pointer + (isFormat ? "/format" : "/path"));
            }
        }
        try {
            checkResultsPlace(m_file, {.outside = m_allowsOutside});
        } catch (const Error& error) {
            add(error, "");
        }
    }

    void checkResults()
    {
        const auto steps = makeSteps({m_opener, m_file});
        FileHashes hashes(cacheFolder(m_file) / "hashes.json");
        const auto status =
            stepStatus(steps, ResultStore(cacheFolder(m_file)), m_folder, hashes, m_progress.part(0.8, 1));
        for (std::size_t i = 0; i < steps.size(); ++i) {
            (status[i].isFresh ? m_report.freshResults : m_report.staleResults)++;
            if (!status[i].isDamaged)
                continue;
            ProjectProblem problem;
            problem.severity = ProjectProblem::Severity::Warning;
            problem.code = ErrorCode::ResultDamaged;
            problem.context.file = ResultStore(cacheFolder(m_file)).fileOf(steps[i].name);
            m_report.problems.push_back(std::move(problem));
        }
    }

    const std::filesystem::path& m_file;
    bool m_allowsOutside;
    std::filesystem::path m_folder;
    const Progress& m_progress;
    JsonText m_json;
    Project m_project;
    std::shared_ptr<SequenceOpener> m_opener;
    std::set<std::string> m_lost; ///< pointers of media that are not there
    CheckReport m_report;
};

} // namespace

CheckReport checkProject(const std::filesystem::path& file, const Progress& progress, bool allowsOutside)
{
    return Checker(file, progress, allowsOutside).run();
}

} // namespace quadrille
