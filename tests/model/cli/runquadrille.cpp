// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/cli/runquadrille.h"

#include "model/cli/program.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <sys/wait.h>
#include <thread>

namespace quadrille::test {

namespace {

enum class Start
{
    Built, ///< the program as it is built
    Copied ///< its functions in a copy of this process
};

/// A copy of a process has but the one thread that made it, and could wait for others for ever.
bool hasOneThread()
{
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}) == 1;
}

pid_t start(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
            const TemporaryFolder& outputs, Start how)
{
    const bool isBuilt = how == Start::Built || !hasOneThread();
    std::cout.flush();
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child != 0)
        return child;
    std::vector<std::string> words{QUADRILLE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    ::dup2(::open((outputs / "out").c_str(), flags, 0600), STDOUT_FILENO);
    ::dup2(::open((outputs / "err").c_str(), flags, 0600), STDERR_FILENO);
    std::filesystem::current_path(folder);
    if (!isBuilt)
        std::exit(cli::runProgram(static_cast<int>(words.size()), argv.data()));
    ::execv(argv.front(), argv.data());
    ::_exit(127);
}

std::string outputOf(const std::filesystem::path& file)
{
    return std::filesystem::file_size(file) == 0 ? "" : textOf(file);
}

Outcome finish(int status, const TemporaryFolder& outputs)
{
    Outcome run;
    run.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    run.out = outputOf(outputs / "out");
    run.err = outputOf(outputs / "err");
    return run;
}

Outcome outcomeOf(const std::vector<std::string>& arguments, const std::filesystem::path& folder, Start how)
{
    const TemporaryFolder outputs;
    const pid_t child = start(arguments, folder, outputs, how);
    int status = 0;
    ::waitpid(child, &status, 0);
    return finish(status, outputs);
}

} // namespace

Outcome runQuadrille(const std::vector<std::string>& arguments, const std::filesystem::path& folder)
{
    return outcomeOf(arguments, folder, Start::Built);
}

Outcome runCopied(const std::vector<std::string>& arguments, const std::filesystem::path& folder)
{
    return outcomeOf(arguments, folder, Start::Copied);
}

Outcome interruptQuadrille(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                           const std::function<bool()>& isTime)
{
    const TemporaryFolder outputs;
    const pid_t child = start(arguments, folder, outputs, Start::Built);
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        if (isTime()) {
            ::kill(child, SIGINT);
            ::waitpid(child, &status, 0);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return finish(status, outputs);
}

} // namespace quadrille::test
