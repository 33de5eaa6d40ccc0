# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
find_package(GTest REQUIRED)

# Where tests find the real captures; tests that need them say "skipped" when the folder is not there.
set(QUADRILLE_DATA_DIR "${CMAKE_SOURCE_DIR}/../shared/data" CACHE PATH "Folder of real captures for tests")

# The sources of tests take longest to compile and shortest to run: what they test is optimized, they are a little.
set(QUADRILLE_TEST_OPTIONS $<$<CONFIG:Release>:-Og>)
# The headers of GoogleTest and QtTest take longer still, so many sources are compiled at a time (see quadrille_unity).
set_property(DIRECTORY PROPERTY QUADRILLE_UNITY_SIZE 32)

# Where the test SampleRebuild leaves the rebuilt sample.
set(QUADRILLE_REBUILT_SAMPLE "${CMAKE_BINARY_DIR}/tests/rebuiltsample")

# Seconds after which a test is taken to hang. Under a sanitizer all takes many times as long.
set(QUADRILLE_TEST_TIMEOUT 900)
# Milliseconds for one function; Qt gives up after five minutes otherwise.
set(function_timeout 1200000)
if(QUADRILLE_SANITIZE)
    set(QUADRILLE_TEST_TIMEOUT 7200)
    set(function_timeout 3000000)
endif()
list(APPEND QUADRILLE_QT_TEST_ENVIRONMENT QTEST_FUNCTION_TIMEOUT=set:${function_timeout})
# The thread sanitizer's detector of deadlocks counts what one library under Qt locks and misses that another unlocks it.
# And it ends a process that starts threads after another program was started from it.
if(QUADRILLE_SANITIZE STREQUAL "thread")
    list(APPEND QUADRILLE_QT_TEST_ENVIRONMENT
        TSAN_OPTIONS=path_list_append:detect_deadlocks=0:die_after_fork=0)
endif()

# quadrille_model_test(NAME source.cpp … [LIBRARIES target …] [APART suite …]): one GoogleTest program, each of its suites
# known to ctest, but for those whose tests the caller adds.
function(quadrille_model_test name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES;APART")
    add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
    target_link_libraries(${name} PRIVATE Quadrille::Model quadrille_plain_algebra GTest::gmock GTest::gtest_main ${arg_LIBRARIES})
    target_compile_options(${name} PRIVATE ${QUADRILLE_TEST_OPTIONS})
    target_compile_definitions(${name} PRIVATE
        QUADRILLE_DATA_DIR="${QUADRILLE_DATA_DIR}")
    quadrille_unity(${name})
    set(suites "${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake")
    file(GENERATE OUTPUT "${suites}" CONTENT "set(QUADRILLE_PROGRAM [[$<TARGET_FILE:${name}>]])
set(QUADRILLE_TIMEOUT ${QUADRILLE_TEST_TIMEOUT})
set(QUADRILLE_APART ${arg_APART})
include([[${CMAKE_SOURCE_DIR}/cmake/QuadrilleSuites.cmake]])
")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${suites}")
endfunction()

# quadrille_qt_program(NAME source.cpp … [LIBRARIES target …]): one program for all QtTest classes of a folder; its first
# argument says which of them to run (see tests/qt/registry.h).
function(quadrille_qt_program name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES")
    find_package(Qt6 REQUIRED COMPONENTS Test Widgets)
    add_executable(${name} ${arg_UNPARSED_ARGUMENTS} "${CMAKE_SOURCE_DIR}/tests/qt/registry.cpp")
    quadrille_automoc(${name})
    if(QUADRILLE_SANITIZE)
        target_sources(${name} PRIVATE "${CMAKE_SOURCE_DIR}/tests/keeplibraries.cpp")
    endif()
    if(QUADRILLE_SANITIZE STREQUAL "thread")
        target_sources(${name} PRIVATE "${CMAKE_SOURCE_DIR}/tests/qt/handovers.cpp")
        set_source_files_properties("${CMAKE_SOURCE_DIR}/tests/qt/handovers.cpp" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
    target_link_libraries(${name} PRIVATE Qt6::Test Qt6::Widgets Quadrille::Model ${arg_LIBRARIES})
    target_compile_options(${name} PRIVATE ${QUADRILLE_TEST_OPTIONS})
    target_compile_definitions(${name} PRIVATE
        QUADRILLE_DATA_DIR="${QUADRILLE_DATA_DIR}")
    quadrille_unity(${name})
endfunction()

# Where no times are known yet the costly begin: tests of the interface take seconds to minutes, others less than one.

# quadrille_qt_tests(PROGRAM test …): test classes of a program, each run for itself on a private X display. Their label is
# the program's name without “test_”.
function(quadrille_qt_tests program)
    string(REPLACE test_ "" label ${program})
    foreach(test IN LISTS ARGN)
        add_test(NAME ${test} COMMAND xvfb-run -a -s "-screen 0 1600x1000x24" $<TARGET_FILE:${program}> ${test})
        set_tests_properties(${test} PROPERTIES LABELS ${label} TIMEOUT ${QUADRILLE_TEST_TIMEOUT} COST 10
            ENVIRONMENT_MODIFICATION "${QUADRILLE_QT_TEST_ENVIRONMENT}")
    endforeach()
endfunction()

# quadrille_desktop_tests(PROGRAM test …): the same on a larger display that has a window manager, as users have one.
function(quadrille_desktop_tests program)
    foreach(test IN LISTS ARGN)
        add_test(NAME ${test} COMMAND "${CMAKE_SOURCE_DIR}/tests/desktop/run.sh" $<TARGET_FILE:${program}> ${test})
        set_tests_properties(${test} PROPERTIES TIMEOUT ${QUADRILLE_TEST_TIMEOUT} SKIP_RETURN_CODE 77 COST 100
            ENVIRONMENT_MODIFICATION "${QUADRILLE_QT_TEST_ENVIRONMENT}")
    endforeach()
endfunction()
