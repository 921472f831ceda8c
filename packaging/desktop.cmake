# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: The Pendesk authors
# Component "desktop": everything but the programs, so that a test can install it alone.
include(GNUInstallDirs)
string(TIMESTAMP PENDESK_DAY "%Y-%m-%d" UTC)

# Writes CHANGELOG.md in the given form of changelog.awk to a variable.
function(pendesk_changelog form output)
    execute_process(COMMAND awk -v form=${form} -v day=${PENDESK_DAY} -f changelog.awk ${PROJECT_SOURCE_DIR}/CHANGELOG.md
        WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
    set(${output} "${text}" PARENT_SCOPE)
endfunction()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md changelog.awk)

function(pendesk_install folder)
    install(FILES ${ARGN} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder} COMPONENT desktop)
endfunction()

pendesk_changelog(appstream PENDESK_RELEASES)
configure_file(${PENDESK_ID}.metainfo.xml.in ${PENDESK_ID}.metainfo.xml @ONLY)

pendesk_install(applications ${PENDESK_ID}.desktop)
pendesk_install(metainfo ${CMAKE_CURRENT_BINARY_DIR}/${PENDESK_ID}.metainfo.xml)
pendesk_install(icons/hicolor/scalable/apps ${PROJECT_SOURCE_DIR}/resources/icons/pendesk.svg
    RENAME ${PENDESK_ID}.svg)
pendesk_install(man/man1 pendesk.1 pendeskctl.1 pendesk-sim.1)
pendesk_install(bash-completion/completions pendeskctl.bash RENAME pendeskctl)
pendesk_install(doc/pendesk/examples examples/pendesk-backup.service examples/pendesk-backup.timer)
