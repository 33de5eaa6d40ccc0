# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# One interface target holds what every target of the project is compiled with.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
include(GNUInstallDirs)
# What sources of every kind include, for quadrille_share_headers.
set(QUADRILLE_COMMON_HEADERS
    <algorithm> <cmath> <filesystem> <functional> <map> <memory> <optional> <span> <string> <vector> <Eigen/Geometry>)
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
    -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast
    -Wno-missing-field-initializers # designated initializers leave the rest at its default
    # g++ 12 finds overlaps and, with precompiled headers, overflows in joined strings where there are none (its bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict$<SEMICOLON>-Wno-stringop-overflow$<SEMICOLON>-Wno-array-bounds>
    # What GCC tells of a header it tells of a source that is compiled with others, too: names that another's hide, and
    # members whose types are of an unnamed namespace.
    $<IF:$<BOOL:${QUADRILLE_UNITY}>,-Wshadow=local$<SEMICOLON>-Wno-subobject-linkage,-Wshadow>
    $<$<BOOL:${QUADRILLE_WARNINGS_AS_ERRORS}>:-Werror>)
# Where each core has memory for it, GCC throws nothing away before it has a gigabyte: an eighth of its time.
cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
math(EXPR memory "${memory} / ${cores}") # megabytes
if(memory GREATER_EQUAL 4096)
    target_compile_options(quadrille_options INTERFACE
        $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1048576$<SEMICOLON>--param=ggc-min-expand=200>)
endif()
# Links in a fifth of the time.
find_program(MOLD_PROGRAM mold)
if(MOLD_PROGRAM)
    target_link_options(quadrille_options INTERFACE -fuse-ld=mold)
endif()
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

# quadrille_unity(target): compiles the sources of each folder together, in equal lots of at most as many as the property
# QUADRILLE_UNITY_SIZE of the target or its directory says, once the target is complete.
# Reading the headers of Qt, VTK, Eigen and the standard library takes longer than compiling what is ours, so this builds
# from nothing in a third of the time; configure with -DQUADRILLE_UNITY=OFF to compile each source for itself. Names in
# unnamed namespaces must be unique within a folder. Sources with compiler flags of their own stay alone.
define_property(TARGET PROPERTY QUADRILLE_UNITY_SIZE INHERITED)
define_property(DIRECTORY PROPERTY QUADRILLE_UNITY_SIZE INHERITED)
set_property(GLOBAL PROPERTY QUADRILLE_UNITY_SIZE 12)
function(quadrille_unity target)
    if(QUADRILLE_UNITY)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
        cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY \"${CMAKE_SOURCE_DIR}\" CALL quadrille_group_sources ${target})")
    endif()
endfunction()

function(quadrille_group_sources target)
    get_target_property(sources ${target} SOURCES)
    get_target_property(folder ${target} SOURCE_DIR)
    get_property(size TARGET ${target} PROPERTY QUADRILLE_UNITY_SIZE)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    foreach(source IN LISTS sources)
        cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${folder}")
        cmake_path(GET source PARENT_PATH place)
        cmake_path(RELATIVE_PATH place BASE_DIRECTORY "${CMAKE_SOURCE_DIR}")
        string(MAKE_C_IDENTIFIER "${place}" place)
        list(APPEND places ${place})
        list(APPEND sources_${place} "${source}")
    endforeach()
    list(REMOVE_DUPLICATES places)
    foreach(place IN LISTS places)
        list(LENGTH sources_${place} count)
        math(EXPR lots "(${count} + ${size} - 1) / ${size}")
        set(done 0)
        foreach(source IN LISTS sources_${place})
            math(EXPR lot "${done} * ${lots} / ${count}")
            math(EXPR done "${done} + 1")
            set_source_files_properties("${source}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP "${place}_${lot}")
        endforeach()
    endforeach()
endfunction()

# quadrille_share_headers(NAME HEADERS header … LINK library … OPTIONS option … TARGETS target …): takes headers that most
# sources of some targets read, compiled once for all of them with what the libraries ask for. It is for speed alone: each
# source includes what it uses, and clang-tidy reads it without. Not for the tests, which take longer with them.
# The options are for the targets, too: GCC optimizes a source as the headers were, whatever is asked for the source.
function(quadrille_share_headers name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;LINK;OPTIONS;TARGETS")
    if(NOT TARGET ${name})
        file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/${name}.cpp" CONTENT "")
        add_library(${name} OBJECT "${CMAKE_BINARY_DIR}/${name}.cpp")
        target_link_libraries(${name} PRIVATE quadrille_options ${arg_LINK})
        target_compile_options(${name} PRIVATE ${arg_OPTIONS})
        target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
    endif()
    foreach(target IN LISTS arg_TARGETS)
        target_compile_options(${target} PRIVATE ${arg_OPTIONS})
        target_precompile_headers(${target} REUSE_FROM ${name})
    endforeach()
endfunction()

# quadrille_automoc(target …): has Qt's moc read the sources and headers of targets, each for itself. Reading Qt and VTK along
# takes nearly a hundred times as long, also after each edit of a header, and tells moc only which arguments are QObjects, to
# register their types; Qt 6 has these from the declarations. To be called where Qt6 was found.
function(quadrille_automoc)
    set(script "${CMAKE_BINARY_DIR}/moc.sh")
    get_target_property(moc Qt6::moc IMPORTED_LOCATION)
    file(CONFIGURE OUTPUT "${script}" @ONLY CONTENT [[#!/bin/bash
# moc without folders of headers.
arguments=()
for argument; do
    case $argument in
    -I*) ;;
    *) arguments+=("$argument") ;;
    esac
done
exec "@moc@" "${arguments[@]}"
]])
    file(CHMOD "${script}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE)
    set_target_properties(${ARGN} PROPERTIES AUTOMOC ON AUTOMOC_EXECUTABLE "${script}")
    # Sources include what moc writes of their headers; of little else there is a source that shared headers do not help.
    foreach(target IN LISTS ARGN)
        get_target_property(folder ${target} BINARY_DIR)
        set_source_files_properties("${folder}/${target}_autogen/mocs_compilation.cpp" TARGET_DIRECTORY ${target}
            PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    endforeach()
endfunction()
