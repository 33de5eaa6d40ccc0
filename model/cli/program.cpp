// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/cli/program.h"

#include "model/cli/commands.h"
#include "model/core/caughterror.h"

#include <csignal>
#include <cstdio>

namespace quadrille::cli {

namespace {

/// What Ctrl-C sets; a second Ctrl-C ends the program at once.
CancelToken* tokenOfSignal = nullptr;

void onSignal(int signal)
{
    tokenOfSignal->cancel();
    std::signal(signal, SIG_DFL);
}

void addCommands(CLI::App& app, Session& session)
{
    app.name("quadrille");
    app.description("Quadrille, headless: makes new performances from captured textured mesh sequences.");
    app.set_version_flag("--version", "quadrille " QUADRILLE_VERSION);
    app.require_subcommand(1);
    app.fallthrough();
    const auto level = [&session](Console::Level wanted) {
        return [&session, wanted](std::int64_t) { session.console.setLevel(wanted); };
    };
    app.add_flag_function("-q,--quiet", level(Console::Level::Quiet), "Say errors only")->trigger_on_parse();
    app.add_flag_function("-v,--verbose", level(Console::Level::Verbose), "Say more")->trigger_on_parse();
    app.footer("Exit status: 0 done, 1 failed, 2 wrong usage. “quadrille COMMAND --help” has examples.");
    addInfo(app, session);
    addConvert(app, session);
    addSample(app, session);
    addImport(app, session);
    addCheck(app, session);
    addRebuild(app, session);
    addData(app, session);
    addTransitions(app, session);
}

} // namespace

int runProgram(int argc, char** argv)
{
    Session session;
    tokenOfSignal = &session.cancel;
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
    CLI::App app;
    addCommands(app, session);
    if (argc == 1) {
        std::fputs(app.help().c_str(), stderr);
        return 2;
    }
    try {
        app.parse(argc, argv);
        session.console.endProgress();
        return session.status;
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        session.console.endProgress();
        session.console.fail(error.what());
        std::fputs("“quadrille --help” and “quadrille COMMAND --help” say what is possible.\n", stderr);
        return 2;
    } catch (...) {
        session.console.endProgress();
        session.console.fail(caughtError().what());
        return 1;
    }
}

} // namespace quadrille::cli
