// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille::cli {

/// The program quadrille, all but its `main`: does what the arguments say and catches SIGINT and SIGTERM from
/// then on. To be called once in a process.
/// \return the exit status.
int runProgram(int argc, char** argv);

} // namespace quadrille::cli
