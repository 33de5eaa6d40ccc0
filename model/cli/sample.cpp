// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/sample.h"

#include "model/cli/commands.h"
#include "model/core/stagedfiles.h"

#include <filesystem>
#include <memory>

namespace quadrille::cli {

namespace fs = std::filesystem;

namespace {

struct SampleArguments
{
    std::string folder;
    bool overwrite = false;
};

/// Made beside its place, so that nothing of somebody else is lost on the way.
void runSample(const SampleArguments& arguments, Session& session)
{
    const Progress progress = session.console.progress(session.cancel, "Making the sample");
    WriteGuard guard({.overwrite = arguments.overwrite, .outside = true});
    const fs::path folder = arguments.folder;
    const std::string project = "sample.quadrille";
    StagedFiles files(folder, &guard);
    const fs::path staging = files.add(project).parent_path();
    writeSample(staging, {}, progress);
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(staging)) {
        if (file.is_regular_file() && file.path().filename() != project)
            files.add(file.path().lexically_relative(staging).string());
    }
    files.commit();
    session.console.endProgress();
    session.console.say((folder / project).string());
}

} // namespace

void addSample(CLI::App& app, Session& session)
{
    auto* command = app.add_subcommand("sample", "Write the built-in sample character and its project");
    const auto arguments = std::make_shared<SampleArguments>();
    command->add_option("DIR", arguments->folder, "Folder to write into; made where it is missing")
        ->required();
    addOverwrite(*command, arguments->overwrite);
    command->footer("Example:\n"
                    "  quadrille sample demo && quadrille rebuild demo/sample.quadrille");
    command->callback([arguments, &session] { runSample(*arguments, session); });
}

} // namespace quadrille::cli
