# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# One interface target holds what every target of the project is compiled with.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
include(GNUInstallDirs)
set(CMAKE_INSTALL_DOCDIR "${CMAKE_INSTALL_DATAROOTDIR}/doc/quadrille")

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    # What precompiled headers need.
    set(ccache "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${CCACHE_PROGRAM}")
    set(CMAKE_C_COMPILER_LAUNCHER "${ccache}")
    set(CMAKE_CXX_COMPILER_LAUNCHER "${ccache}")
endif()

add_library(quadrille_options INTERFACE)
target_include_directories(quadrille_options INTERFACE "${CMAKE_SOURCE_DIR}")
target_compile_options(quadrille_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast
    -Wno-missing-field-initializers # designated initializers leave the rest at its default
    # g++ 12 finds overlaps in joined strings where there are none (its bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    $<$<BOOL:${QUADRILLE_WARNINGS_AS_ERRORS}>:-Werror>)
if(QUADRILLE_SANITIZE)
    # Instrumented code makes GCC see uninitialized values where there are none.
    target_compile_options(quadrille_options INTERFACE
        -fsanitize=${QUADRILLE_SANITIZE} -fno-omit-frame-pointer -Wno-maybe-uninitialized)
    target_link_options(quadrille_options INTERFACE -fsanitize=${QUADRILLE_SANITIZE})
endif()
if(QUADRILLE_COVERAGE)
    target_compile_options(quadrille_options INTERFACE --coverage)
    target_link_options(quadrille_options INTERFACE --coverage)
endif()

# Headers that most sources of the interface read, compiled once for each of its libraries. It is for speed alone: each
# source includes what it uses, and clang-tidy reads it without. Not for the model and the tests: g++ 12 then finds
# overflows of strings where there are none.
set(QUADRILLE_QT_HEADERS
    <algorithm> <cmath> <filesystem> <functional> <map> <memory> <optional> <span> <string> <vector> <QtWidgets>)
