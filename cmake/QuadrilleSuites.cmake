# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# Read by ctest itself (see quadrille_model_test): makes each suite of a GoogleTest program a test. A test of its own for
# every TEST would start the program, with all its libraries, two thousand times more: three minutes of a processor.
# Expects QUADRILLE_PROGRAM, QUADRILLE_TIMEOUT in seconds, and in QUADRILLE_APART suites that are tests already.
cmake_policy(VERSION 3.25)
if(NOT EXISTS "${QUADRILLE_PROGRAM}")
    get_filename_component(name "${QUADRILLE_PROGRAM}" NAME)
    add_test("${name}_NOT_BUILT" "${QUADRILLE_PROGRAM}")
    return()
endif()
execute_process(COMMAND "${QUADRILLE_PROGRAM}" --gtest_list_tests
    OUTPUT_VARIABLE listing RESULT_VARIABLE result TIMEOUT 60)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${QUADRILLE_PROGRAM} does not list its tests: ${result}\n${listing}")
endif()
# “Suite.” begins a line, perhaps with the type it is for behind; its tests are indented.
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\.( |\n|$)" suites "${listing}")
foreach(suite IN LISTS suites)
    string(REGEX REPLACE "[^A-Za-z0-9_/]" "" suite "${suite}")
    if(suite IN_LIST QUADRILLE_APART)
        continue()
    endif()
    add_test("${suite}" "${QUADRILLE_PROGRAM}" "--gtest_filter=${suite}.*")
    # Skipped is a suite of which nothing but skipped tests is told at the end.
    set_tests_properties("${suite}" PROPERTIES LABELS model TIMEOUT "${QUADRILLE_TIMEOUT}"
        SKIP_REGULAR_EXPRESSION "PASSED  \\] 0 tests\\.\n(\\[  SKIPPED \\][^\n]*\n)+$")
endforeach()
