# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# quadrille_add_folders(LAYER): adds the folders of a layer that folders.txt lists, in its order.
function(quadrille_add_folders layer)
    set(table "${CMAKE_SOURCE_DIR}/cmake/folders.txt")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${table}")
    file(STRINGS "${table}" folders REGEX "^${layer}/")
    foreach(folder IN LISTS folders)
        add_subdirectory("${CMAKE_SOURCE_DIR}/${folder}")
    endforeach()
endfunction()
