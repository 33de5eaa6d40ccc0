// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/model/project/testproject.h"

#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace quadrille::test {

struct Outcome
{
    int status = -1; ///< exit status; −1 when a signal ended it
    std::string out;
    std::string err;
};

/// Runs the built `quadrille` in a folder and waits for it.
Outcome runQuadrille(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

/// Does what it does without starting it: loading its libraries takes longer than most of what tests ask for.
Outcome runCopied(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

/// Starts it, sends SIGINT once `isTime` says so, and waits for it.
Outcome interruptQuadrille(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                           const std::function<bool()>& isTime);

} // namespace quadrille::test
