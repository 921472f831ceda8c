# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: The Pendesk authors
# The Debian package. Programs name their libraries themselves (dpkg-shlibdeps); what Qt loads at run time is named here.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Pendesk authors <pendesk@pendesk.invalid>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6sql6-sqlite, hicolor-icon-theme")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-wayland, qt6-translations-l10n, fonts-inter, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "fonts-noto-cjk")
set(CPACK_PACKAGE_DESCRIPTION
"Pendesk talks to DX100, DX200, FS100, YRC1000 and YRC1000micro controllers
over HSES and shows live what they say: status, alarms, I/O, registers,
variables, position, jobs and files. It makes backups that are verified to
the bit, compares and restores them, and has a virtual controller for trying
it without a robot.

This package has the window (pendesk), a program for scripts (pendeskctl)
and virtual controllers for tests and training (pendesk-sim).")

# What Debian wants otherwise than other systems is done to the copy that is packed.
pendesk_changelog(debian changelog)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/changelog "${changelog}")
configure_file(debianize.cmake.in debianize.cmake @ONLY)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_BINARY_DIR}/debianize.cmake)
