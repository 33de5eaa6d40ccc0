# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# quadrille_add_folders(LAYER library …): a static library for each folder of a layer that folders.txt lists, in its order,
# called after the folder: quadrille_model_sequence_io. It links the libraries given and those of the folders that the table
# names; the CMakeLists.txt of the folder gives it its sources and what else it needs (that of the layer, where the folder is
# the layer's own).
# QUADRILLE_<LAYER>_LIBRARIES lists them for the caller.
function(quadrille_add_folders layer)
    set(table "${CMAKE_SOURCE_DIR}/cmake/folders.txt")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${table}")
    file(STRINGS "${table}" lines REGEX "^[ a-z]")
    set(libraries "")
    set(library "")
    foreach(line IN LISTS lines)
        string(STRIP "${line}" words)
        separate_arguments(words)
        if(line MATCHES "^[a-z]")
            set(library "")
            if(NOT line MATCHES "^${layer}(/|$)")
                continue()
            endif()
            string(REPLACE "/" "_" library "quadrille_${line}")
            add_library(${library} STATIC)
            target_link_libraries(${library} PUBLIC quadrille_options ${ARGN})
            quadrille_unity(${library})
            if(NOT line STREQUAL layer)
                add_subdirectory("${CMAKE_SOURCE_DIR}/${line}")
            endif()
            list(APPEND libraries ${library})
        elseif(library)
            list(POP_FRONT words used)
            list(TRANSFORM words PREPEND "quadrille_${used}_")
            list(TRANSFORM words REPLACE "/" "_")
            target_link_libraries(${library} PUBLIC ${words})
        endif()
    endforeach()
    string(TOUPPER "${layer}" layer)
    set(QUADRILLE_${layer}_LIBRARIES ${libraries} PARENT_SCOPE)
endfunction()
