# What `cmake --install` lays down beside libraries and programs. Components: programs, development, documents, as the
# packages of AriadnePackages.cmake.
include(CMakePackageConfigHelpers)
get_property(programs GLOBAL PROPERTY ARIADNE_PROGRAMS)
get_property(component_names GLOBAL PROPERTY ARIADNE_LIBRARIES)
list(JOIN component_names ", " component_names)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ariadne)
configure_package_config_file(cmake/ariadne-config.cmake.in ${CMAKE_BINARY_DIR}/ariadne-config.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/ariadne-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/ariadne-config.cmake ${CMAKE_BINARY_DIR}/ariadne-config-version.cmake
  cmake/AriadneDependencies.cmake DESTINATION ${package_dir} COMPONENT development)
install(EXPORT ariadne-targets NAMESPACE ariadne:: DESTINATION ${package_dir} COMPONENT development)

# INIs name worlds and drives by paths from themselves: both lie as in the source tree.
set(share ${CMAKE_INSTALL_DATADIR}/ariadne)
install(DIRECTORY ini DESTINATION ${share} COMPONENT programs)
install(DIRECTORY datasets/worlds datasets/drives datasets/references DESTINATION ${share}/datasets
  COMPONENT programs)
install(FILES cmake/bash-completion DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME ariadne-slam COMPONENT programs)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/completions)
foreach(program IN LISTS programs)
  if(NOT program STREQUAL ariadne-slam)
    file(CREATE_LINK ariadne-slam ${CMAKE_BINARY_DIR}/completions/${program} SYMBOLIC)
    install(FILES ${CMAKE_BINARY_DIR}/completions/${program}
      DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT programs)
  endif()
endforeach()

# Licence and Debian's changelog with each package, documents with one.
set(documents ${CMAKE_INSTALL_DATADIR}/doc)
file(CONFIGURE OUTPUT changelog @ONLY CONTENT "ariadne (@PROJECT_VERSION@) unstable; urgency=medium

  * What changed is told in CHANGELOG.md of the package ariadne-doc.

 -- @CPACK_PACKAGE_CONTACT@  Mon, 30 Nov 2026 12:00:00 +0000
")
execute_process(COMMAND gzip -9nc ${CMAKE_BINARY_DIR}/changelog OUTPUT_FILE ${CMAKE_BINARY_DIR}/changelog.gz
  COMMAND_ERROR_IS_FATAL ANY)
foreach(package programs=ariadne-slam development=libariadne-dev documents=ariadne-doc)
  string(REGEX MATCH "^(.*)=(.*)$" ignored ${package})
  set(component ${CMAKE_MATCH_1})
  set(folder ${documents}/${CMAKE_MATCH_2})
  install(FILES LICENSE DESTINATION ${folder} RENAME copyright COMPONENT ${component})
  install(FILES ${CMAKE_BINARY_DIR}/changelog.gz DESTINATION ${folder} COMPONENT ${component})
endforeach()
install(FILES README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff DESTINATION ${documents}/ariadne-doc
  COMPONENT documents)
install(DIRECTORY doc DESTINATION ${documents}/ariadne-doc COMPONENT documents)

# A man page for each program, of what its --help says, where Debian's help2man is.
find_program(HELP2MAN help2man)
if(HELP2MAN)
  foreach(program IN LISTS programs)
    set(page ${CMAKE_BINARY_DIR}/man/${program}.1.gz)
    add_custom_command(OUTPUT ${page}
      COMMAND ${CMAKE_COMMAND} -D HELP2MAN=${HELP2MAN} -D PROGRAM=$<TARGET_FILE:${program}> -D PAGE=${page}
        -D VERSION=${PROJECT_VERSION} -P ${CMAKE_SOURCE_DIR}/cmake/AriadneManPage.cmake
      DEPENDS ${program} cmake/AriadneManPage.cmake VERBATIM COMMENT "Man page of ${program}")
    list(APPEND pages ${page})
  endforeach()
  add_custom_target(man ALL DEPENDS ${pages})
  install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs)
endif()
