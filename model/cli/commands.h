// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/cli/console.h"
#include "model/core/progress.h"
#include "model/core/units.h"
#include "model/project/document/project.h"
#include "model/project/file/projectfile.h"
#include "model/sequence/axes.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace quadrille::cli {

/// What one run of the program shares.
struct Session
{
    Console console;
    CancelToken cancel; ///< set by Ctrl-C
    int status = 0;     ///< what the program returns
};

// Each adds its subcommand; the work is done while the command line is parsed.
void addInfo(CLI::App& app, Session& session);
void addConvert(CLI::App& app, Session& session);
void addSample(CLI::App& app, Session& session);
void addImport(CLI::App& app, Session& session);
void addCheck(CLI::App& app, Session& session);
void addRebuild(CLI::App& app, Session& session);
void addData(CLI::App& app, Session& session);
void addTransitions(CLI::App& app, Session& session);

/// Reads a project and says what in it has no effect or may not be meant.
/// \throws Error as loadProject.
Project loadProject(const std::string& file, Console& console);

/// A wrong use that only the arguments' values show.
[[noreturn]] void throwUsage(const std::string& text);

/// "A:B", both included.
FrameRange parseRange(const std::string& text);
/// Options for a coordinate system; what was not given is as in `otherwise`.
struct AxesArguments
{
    std::string up;
    std::string unit;

    bool isGiven() const { return !up.empty() || !unit.empty(); }
    CoordinateSystem toAxes(const CoordinateSystem& fallback = {}) const;
};
/// Adds the option --overwrite.
void addOverwrite(CLI::App& command, bool& overwrite);
/// Adds the option --allow-outside.
void addAllowOutside(CLI::App& command, bool& outside);
/// Frame rates, positive.
CLI::Validator positiveNumber();

} // namespace quadrille::cli
