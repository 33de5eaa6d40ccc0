# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
set(CPACK_GENERATOR "DEB")
set(CPACK_PACKAGE_NAME "quadrille")
set(CPACK_PACKAGE_CONTACT "The Quadrille developers <maintainers@users.noreply.quadrille.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "editor for 4D performance capture")
set(CPACK_PACKAGE_DESCRIPTION
    "Opens captured people as textured mesh sequences, plays them at their true rate, and exports them for other
programs. The program quadrille does the same without a display.")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Plugins and data that no library names: OpenGL without a graphics card, and Qt's own texts in French.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1-mesa-dri, qt6-translations-l10n")
set(CPACK_DEBIAN_PACKAGE_SECTION "graphics")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_SOURCE_DIR}/LICENSE")
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
include(CPack)
