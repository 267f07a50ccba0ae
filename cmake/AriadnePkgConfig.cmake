# ariadne.pc, for those who build without CMake: all libraries, as a static library's user must name them. MRPT has no
# .pc of its own in Debian.
get_property(libraries GLOBAL PROPERTY ARIADNE_LIBRARIES)
list(REVERSE libraries)
list(TRANSFORM libraries PREPEND "-lariadne_")
list(JOIN libraries " " libraries)
set(mrpt "")
foreach(part slam maps obs bayes kinematics graphs opengl tfest poses img random config serialization io system
    containers rtti math core)
  string(APPEND mrpt " -lmrpt-${part}")
endforeach()
set(headers "$<TARGET_PROPERTY:ariadne_map_builder,INCLUDE_DIRECTORIES>;$<TARGET_PROPERTY:ariadne_sim,INCLUDE_DIRECTORIES>")
set(headers "$<REMOVE_DUPLICATES:$<FILTER:${headers},EXCLUDE,^${CMAKE_SOURCE_DIR}|^/usr/include$>>")
file(RELATIVE_PATH prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)  # wherever it is installed
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/ariadne.pc CONTENT "prefix=\${pcfiledir}/${prefix}
libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}

Name: ariadne
Description: ${PROJECT_DESCRIPTION}
Version: ${PROJECT_VERSION}
Requires: fmt tbb eigen3 cairo libpng zlib yaml-cpp sqlite3 liblz4 libzstd
Cflags: -I\${includedir} -I$<JOIN:${headers}, -I>
Libs: -L\${libdir} ${libraries}${mrpt} -lfastcdr -lbz2 -pthread
")
install(FILES ${CMAKE_BINARY_DIR}/ariadne.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
