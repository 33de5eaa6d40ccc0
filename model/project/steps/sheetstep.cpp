// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/contenthash.h"
#include "model/core/image.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/buildstep.h"
#include "model/project/store/resultplaces.h"
#include "model/render/contactsheet.h"

namespace quadrille {

namespace {

/// More sequences would make a picture that nobody can look at.
constexpr std::size_t mostSequences = 40;

Result drawSheet(SequenceOpener& opener, const std::vector<std::string>& names,
                 const std::filesystem::path& projectFile, const Progress& progress)
{
    std::vector<MeshSequence> sequences;
    sequences.reserve(names.size());
    for (const std::string& name : names)
        sequences.push_back(opener.open(name, progress.part(0, 0.1))->sequence);
    ContactSheetOptions options;
    options.title = projectFile.stem().string();
    options.axes = opener.project().settings.axes;
    const Image sheet = contactSheet(sequences, options, progress.part(0.1, 0.95));
    const auto file = cacheFolder(projectFile) / "contact-sheet.png";
    writeImage(sheet, file);
    Result result;
    result.files = {{storedPath(file, opener.folder()), hashFile(file, progress)}};
    return result;
}

} // namespace

std::vector<BuildStep> makeSheetSteps(const StepMaking& making)
{
    const auto opener = making.opener;
    std::vector<std::string> names;
    BuildStep step;
    step.name = "contact-sheet";
    step.settings = making.projectFile.stem().string();
    for (const SequenceEntry& entry : opener->project().sequences) {
        if (names.size() == mostSequences)
            break;
        names.push_back(entry.name);
        step.settings += "\n" + entry.name + "\n" + sequenceSettings(opener->project(), entry);
    }
    if (names.empty())
        return {};
    step.inputs = clipInputs(opener->project(), names);
    step.files = [opener, names](const Progress& progress) {
        std::vector<std::filesystem::path> files;
        for (const std::string& name : names) {
            const auto own = opener->filesOf(name, progress);
            files.insert(files.end(), own.begin(), own.end());
        }
        return files;
    };
    step.compute = [opener, names, file = making.projectFile](const StepContext&, const Progress& progress) {
        return drawSheet(*opener, names, file, progress);
    };
    return {step};
}

} // namespace quadrille
