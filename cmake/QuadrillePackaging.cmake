# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
set(CPACK_GENERATOR "DEB")
set(CPACK_PACKAGE_NAME "quadrille")
set(CPACK_PACKAGE_CONTACT "The Quadrille developers <maintainers@users.noreply.quadrille.example>")
set(CPACK_PACKAGE_FILE_NAME "quadrille-${PROJECT_VERSION}")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION "graphics")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_SOURCE_DIR}/LICENSE")
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
include(CPack)
