# `cpack` in the build folder makes Debian packages: programs, library and headers, documents.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ariadne)
set(CPACK_PACKAGE_VENDOR "the Ariadne authors")
set(CPACK_PACKAGE_CONTACT "the Ariadne authors <maintainers@users.noreply.h-seed-7f50206f.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL programs development documents)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# LTO and hardening are Debian's matter; what a program links is found out by dpkg-shlibdeps.
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME ariadne-slam)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "gnuplot-nox")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "mrpt-common")
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "${PROJECT_DESCRIPTION}
Maps logs of a laser scanner and odometry, explores simulated buildings, and
compares runs. Reads MRPT rawlogs, CARMEN logs and ROS recordings, writes what
MRPT and ROS read.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libariadne-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libmrpt-slam-dev, libmrpt-maps-dev, libmrpt-obs-dev, libmrpt-bayes-dev, \
libmrpt-kinematics-dev, libeigen3-dev, libtbb-dev, libfmt-dev, nlohmann-json3-dev, libcli11-dev, libboost-math-dev, \
libcairo2-dev, libpng-dev, zlib1g-dev, libyaml-cpp-dev, libfastcdr-dev, libsqlite3-dev, libbz2-dev, liblz4-dev, \
libzstd-dev, pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "${PROJECT_DESCRIPTION} (library)
Static libraries and headers: the filter, its grid, loops and recovery,
simulation, exploration.")
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_NAME ariadne-doc)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOCUMENTS_DESCRIPTION "${PROJECT_DESCRIPTION} (documents)
Parameters, models, experiments and what they showed.")
include(CPack)
