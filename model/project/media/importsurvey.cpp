// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/importsurvey.h"

#include "model/core/bounds.h"
#include "model/sequence/io/files/sourcefiles.h"
#include "model/sequence/io/registry.h"

#include <algorithm>
#include <array>
#include <set>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// What the extension of a file says of its format; null where no importer has it.
const FormatInfo* formatOf(const fs::path& file)
{
    const std::string extension = lowerExtension(file);
    for (const auto& importer : importers()) {
        const FormatInfo& format = importer->format();
        if (std::ranges::find(format.extensions, extension) != format.extensions.end())
            return &format;
    }
    return nullptr;
}

std::vector<std::string> extensionsWhere(bool onePerFrame)
{
    std::vector<std::string> extensions;
    for (const auto& importer : importers()) {
        const FormatInfo& format = importer->format();
        if (format.onePerFrame == onePerFrame)
            extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
    }
    return extensions;
}

/// The pattern that means a series: its files with #### for the number.
fs::path patternOf(const SourceFiles& series)
{
    const std::string first = series.files.front().filename().string();
    const std::string last = series.files.back().filename().string();
    std::size_t before = 0;
    while (before < std::min(first.size(), last.size()) && first[before] == last[before])
        ++before;
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    while (before > 0 && isDigit(first[before - 1]))
        --before;
    std::size_t end = before;
    while (end < first.size() && isDigit(first[end]))
        ++end;
    return series.files.front().parent_path() / (first.substr(0, before) + "####" + first.substr(end));
}

class Finder
{
public:
    void add(const fs::path& path)
    {
        std::error_code error;
        if (fs::is_directory(path, error)) {
            addFolder(path, true);
        } else if (isPattern(path)) {
            addSource(path);
        } else {
            const FormatInfo* format = formatOf(path);
            if (format != nullptr && format->onePerFrame) {
                const SourceFiles series = seriesAround(path);
                if (series.isSeries())
                    addSource(patternOf(series));
                else
                    m_meshes.push_back(path);
            } else {
                m_needsMesh = m_needsMesh || (format != nullptr && format->needsMesh);
                addSource(path); // what is not known is refused with its reason when it is opened
            }
        }
    }

    FoundSources finish()
    {
        FoundSources found{std::move(m_sources), {}};
        if (m_needsMesh && m_meshes.size() == 1)
            found.mesh = m_meshes.front();
        else if (!m_needsMesh)
            found.sources.insert(found.sources.end(), m_meshes.begin(), m_meshes.end());
        return found;
    }

private:
    void addSource(const fs::path& source)
    {
        if (m_known.insert(source).second)
            m_sources.push_back(source);
    }

    void addFolder(const fs::path& folder, bool withFoldersBelow)
    {
        const FolderContent meshes = scanFolder(folder, extensionsWhere(true));
        for (const SourceFiles& series : meshes.series)
            addSource(patternOf(series));
        for (const SourceFiles& single : meshes.singles)
            m_meshes.push_back(single.files.front());
        std::vector<fs::path> takes;
        std::vector<fs::path> folders;
        for (const auto& entry : fs::directory_iterator(folder)) {
            const FormatInfo* format = entry.is_regular_file() ? formatOf(entry.path()) : nullptr;
            if (format != nullptr && !format->onePerFrame) {
                m_needsMesh = m_needsMesh || format->needsMesh;
                takes.push_back(entry.path());
            } else if (entry.is_directory() && !entry.path().filename().string().starts_with('.')) {
                folders.push_back(entry.path());
            }
        }
        const auto byName = [](const fs::path& a, const fs::path& b) {
            return naturalLess(a.filename().string(), b.filename().string());
        };
        std::ranges::sort(takes, byName);
        std::ranges::sort(folders, byName);
        std::ranges::for_each(takes, [this](const fs::path& take) { addSource(take); });
        if (withFoldersBelow)
            std::ranges::for_each(folders, [this](const fs::path& below) { addFolder(below, false); });
    }

    std::vector<fs::path> m_sources;
    std::set<fs::path> m_known;
    std::vector<fs::path> m_meshes; ///< single ones
    bool m_needsMesh = false;
};

fs::path meshNamedBy(const std::vector<Issue>& issues)
{
    for (const Issue& issue : issues) {
        if (issue.code != Issue::Code::MeshFound)
            continue;
        for (const auto& [name, value] : issue.context.values) {
            if (name == "path")
                return value;
        }
    }
    return {};
}

fs::path jointAnglesBeside(const fs::path& source)
{
    fs::path file = source;
    file.replace_extension(".bvh");
    std::error_code error;
    return fs::is_regular_file(file, error) ? file : fs::path();
}

Vec3f sizeOf(const MeshSequence& sequence)
{
    const Frame frame = sequence.frame(FrameIndex(0));
    return boundsOf(frame.positions()).size().cast<float>();
}

/// Opens a source; where it lacks a mesh, with the first that fits. \param import  takes that mesh.
ImportResult openWithMesh(const fs::path& source, ImportOptions& import, const std::vector<fs::path>& meshes,
                          const Progress& progress)
{
    try {
        return openSequences(source, import, progress);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::FormatNeedsMesh)
            throw;
        for (const fs::path& mesh : meshes) {
            import.mesh = mesh;
            try {
                return openSequences(source, import, progress);
            } catch (const Error& unfit) {
                if (unfit.code() == ErrorCode::Cancelled)
                    throw;
            }
        }
        throw;
    }
}

std::vector<SurveyedTake> survey(const fs::path& source, const SurveyOptions& options,
                                 const Progress& progress)
{
    SurveyedTake take;
    take.source = source;
    take.name = source.stem().string();
    try {
        const SourceFiles files = findSource(source);
        const Importer& importer = importerFor(files);
        take.format = importer.format().name;
        ImportOptions import;
        import.fps = options.fps;
        if (importer.format().needsMesh)
            import.mesh = options.mesh;
        ImportResult result = openWithMesh(source, import, options.knownMeshes, progress);
        take.issues = std::move(result.issues);
        take.coordinates = result.coordinates;
        take.hasOwnFps = result.hasOwnFps;
        take.isSampled = result.isSampled;
        take.mesh = import.mesh.empty() ? meshNamedBy(take.issues) : import.mesh;
        take.jointAngles = jointAnglesBeside(source);
        std::vector<SurveyedTake> takes;
        const bool several = result.sequences.size() > 1;
        for (MeshSequence& sequence : result.sequences) {
            takes.push_back(take);
            takes.back().name = sequence.name;
            takes.back().clip = several ? sequence.name : std::string();
            takes.back().size = sizeOf(sequence);
            if (!take.hasOwnFps && sequence.frameCount() > 1)
                takes.back().rate = rateBeside(source, sequence.frameCount());
            takes.back().sequence = std::move(sequence);
        }
        return takes;
    } catch (const Error& error) {
        if (error.code() == ErrorCode::Cancelled)
            throw;
        take.error = error;
        return {take};
    }
}

} // namespace

FoundSources findSources(std::span<const fs::path> paths)
{
    Finder finder;
    for (const fs::path& path : paths)
        finder.add(path);
    FoundSources found = finder.finish();
    if (found.sources.empty())
        throw Error(ErrorCode::SeriesEmpty, {paths.empty() ? fs::path() : paths.front(), {}, {}});
    return found;
}

std::vector<SurveyedTake> surveySources(const std::vector<fs::path>& sources, const SurveyOptions& options,
                                        const Progress& progress)
{
    std::vector<std::vector<SurveyedTake>> each(sources.size());
    std::atomic<std::int64_t> done{0};
    tbb::parallel_for(std::size_t{0}, sources.size(), [&](std::size_t i) {
        each[i] = survey(sources[i], options, Progress(progress.token()));
        progress.report(++done, static_cast<std::int64_t>(sources.size()));
    });
    std::vector<SurveyedTake> takes;
    for (auto& some : each)
        std::ranges::move(some, std::back_inserter(takes));
    return takes;
}

double likelyMetresPerUnit(double height)
{
    constexpr double smallest = 0.5; // of a person, metres
    constexpr double largest = 2.6;
    for (const double metres : {1.0, 0.01, 0.001, 0.0254, 0.3048}) {
        if (height * metres >= smallest && height * metres <= largest)
            return metres;
    }
    return 1;
}

} // namespace quadrille
