// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/cli/program.h"

int main(int argc, char** argv)
{
    return quadrille::cli::runProgram(argc, argv);
}
