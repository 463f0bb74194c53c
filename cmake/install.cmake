# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts where; the exported targets confidel::core, confidel::certificate and confidel::check; the Debian package.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(CONFIDEL_SHARE ${PROJECT_BINARY_DIR}/share)
# Manual pages and completions are made by the program itself, from its own command line: they cannot be stale.
add_custom_command(OUTPUT ${CONFIDEL_SHARE}/made
  COMMAND ${CMAKE_COMMAND} -E make_directory ${CONFIDEL_SHARE}/man/man1
  COMMAND confidel manual --output ${CONFIDEL_SHARE}/man/man1
  COMMAND confidel completion bash > ${CONFIDEL_SHARE}/confidel.bash
  COMMAND confidel completion zsh > ${CONFIDEL_SHARE}/_confidel
  COMMAND confidel completion fish > ${CONFIDEL_SHARE}/confidel.fish
  COMMAND ${CMAKE_COMMAND} -E touch ${CONFIDEL_SHARE}/made
  DEPENDS confidel VERBATIM)
add_custom_target(confidel-manuals ALL DEPENDS ${CONFIDEL_SHARE}/made)
install(DIRECTORY ${CONFIDEL_SHARE}/man/man1/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 FILES_MATCHING PATTERN "*.1")
install(FILES checkers/gmp/confidel-check.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${CONFIDEL_SHARE}/confidel.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME confidel)
install(FILES ${CONFIDEL_SHARE}/_confidel DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${CONFIDEL_SHARE}/confidel.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

set_target_properties(confidel_core PROPERTIES EXPORT_NAME core)
set_target_properties(confidel_proofs PROPERTIES EXPORT_NAME certificate)
set_target_properties(confidel-check PROPERTIES EXPORT_NAME check)
install(TARGETS confidel RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS confidel_core confidel_proofs confidel-check EXPORT confidelTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY core proofs DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/confidel FILES_MATCHING PATTERN "*.h" PATTERN "coq" EXCLUDE)
install(EXPORT confidelTargets NAMESPACE confidel:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/confidel)
configure_package_config_file(cmake/confidelConfig.cmake.in ${PROJECT_BINARY_DIR}/confidelConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/confidel)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/confidelConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/confidelConfig.cmake ${PROJECT_BINARY_DIR}/confidelConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/confidel)
file(RELATIVE_PATH CONFIDEL_PC_TO_PREFIX /p/${CMAKE_INSTALL_LIBDIR}/pkgconfig /p)
configure_file(cmake/confidel.pc.in ${PROJECT_BINARY_DIR}/confidel.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/confidel.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# The Debian package: dependencies of the programs from their libraries, those of the C++ library as recommendations.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME confidel)
set(CPACK_PACKAGE_CONTACT "The Confidel developers <confidel@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libcgal-dev, libgmp-dev, libmpfr-dev, libfmt-dev, libtbb-dev, libssl-dev, libzstd-dev")
include(CPack)
