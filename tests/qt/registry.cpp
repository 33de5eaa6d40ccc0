// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"

#include <filesystem>
#include <iostream>
#include <map>
#include <string>

namespace quadrille::test {

static std::map<std::string, RunTest>& registeredTests()
{
    static std::map<std::string, RunTest> tests;
    return tests;
}

Registration::Registration(const char* source, RunTest run)
{
    registeredTests().emplace(std::filesystem::path(source).stem().string(), run);
}

} // namespace quadrille::test

int main(int argc, char** argv)
{
    const auto& tests = quadrille::test::registeredTests();
    const auto found = argc > 1 ? tests.find(argv[1]) : tests.end();
    if (found == tests.end()) {
        std::cerr << "Usage: " << argv[0] << " TEST [FUNCTION…] [OPTION…]; the tests:\n";
        for (const auto& [name, run] : tests)
            std::cerr << "  " << name << '\n';
        return 2;
    }
    // The test sees the program's name and what follows its own.
    argv[1] = argv[0];
    return found->second(argc - 1, argv + 1);
}
