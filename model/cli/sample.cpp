// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/sample.h"

#include "model/cli/commands.h"

#include <memory>

namespace quadrille::cli {

void addSample(CLI::App& app, Session& session)
{
    auto* command = app.add_subcommand("sample", "Write the built-in sample character and its project");
    const auto folder = std::make_shared<std::string>();
    command->add_option("DIR", *folder, "Folder to write into; made where it is missing")->required();
    command->footer("Example:\n"
                    "  quadrille sample demo && quadrille rebuild demo/sample.quadrille");
    command->callback([folder, &session] {
        const Progress progress = session.console.progress(session.cancel, "Making the sample");
        const auto project = writeSample(*folder, {}, progress);
        session.console.endProgress();
        session.console.say(project.string());
    });
}

} // namespace quadrille::cli
