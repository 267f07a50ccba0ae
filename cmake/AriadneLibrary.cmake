# ariadne_add_library(NAME SOURCES ... DEPENDS ...): one library of libs/, with the project's
# warnings, its headers and its place in the installed package.
function(ariadne_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(ariadne_${name} ${ARG_SOURCES})
  add_library(ariadne::${name} ALIAS ariadne_${name})
  set_target_properties(ariadne_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(ariadne_${name} PUBLIC cxx_std_17)
  target_include_directories(ariadne_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(ariadne_${name} PUBLIC ${ARG_DEPENDS})
  ariadne_set_options(ariadne_${name})
  install(TARGETS ariadne_${name} EXPORT ariadne-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  set_property(GLOBAL APPEND PROPERTY ARIADNE_LIBRARIES ${name})
endfunction()

# Warnings, sanitizers, clang-tidy and ARIADNE_UNITY, for everything that is ours.
function(ariadne_set_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wnon-virtual-dtor)
  if(ARIADNE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(ARIADNE_TIDY)
    set_target_properties(${target} PROPERTIES CXX_CLANG_TIDY clang-tidy)
  endif()
  if(ARIADNE_UNITY)
    ariadne_compile_together(${target})
  endif()
endfunction()

# Files that include about thirty of the target's, chosen by their names so that a new file moves no other. CMake's own
# UNITY_BUILD includes them by absolute paths, which __FILE__ then holds, and another clone's compilation is none for ccache.
function(ariadne_compile_together target)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  math(EXPR groups "(${count} + 29) / 30")
  set(together "")
  foreach(source IN LISTS sources)
    if(IS_ABSOLUTE "${source}")  # a generated one
      list(APPEND together ${source})
    else()
      string(MD5 hash ${source})
      string(SUBSTRING ${hash} 0 7 hash)
      math(EXPR group "0x${hash} % ${groups}")
      file(RELATIVE_PATH path ${CMAKE_CURRENT_BINARY_DIR} ${CMAKE_CURRENT_SOURCE_DIR}/${source})
      string(APPEND includes_${group} "#include \"${path}\"\n")
    endif()
  endforeach()
  math(EXPR last "${groups} - 1")
  foreach(group RANGE ${last})
    if(DEFINED includes_${group})
      set(file ${target}_together_${group}.cpp)
      if(group EQUAL 0)
        set(file ${target}_together.cpp)
      endif()
      file(CONFIGURE OUTPUT ${file} CONTENT "${includes_${group}}" @ONLY)
      list(APPEND together ${CMAKE_CURRENT_BINARY_DIR}/${file})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES SOURCES "${together}")
  # Every file is an included one, so that GCC takes its unnamed namespaces for a header's.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# For code whose time nobody waits for: half of the compiler's work. The last -O counts.
function(ariadne_optimise_little target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# ariadne_add_app(NAME SOURCES ... DEPENDS ...): a program in build/<preset>/bin.
function(ariadne_add_app name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS})
  ariadne_set_options(${name})
  ariadne_start_fast(${name})
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
  set_property(GLOBAL APPEND PROPERTY ARIADNE_PROGRAMS ${name})
endfunction()

# ariadne_add_test(NAME SOURCES ... DEPENDS ...): a GoogleTest program, each case its own ctest.
function(ariadne_add_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} GTest::gtest_main)
  ariadne_set_options(${name})
  ariadne_optimise_little(${name})
  ariadne_start_fast(${name})
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
  ariadne_set_test_environment(${name})
endfunction()

# gtest_discover_tests passes the first of several variables on and loses the others, however they are escaped
# (CMake 3.25); ctest itself sets them here, after it has read the list of the program's cases.
function(ariadne_set_test_environment name)
  set(file ${CMAKE_CURRENT_BINARY_DIR}/${name}_environment.cmake)
  file(CONFIGURE OUTPUT ${file} @ONLY CONTENT [=[
foreach(test IN LISTS @name@_TESTS)
  set_tests_properties("${test}" PROPERTIES ENVIRONMENT
    "ARIADNE_SOURCE_DIR=@CMAKE_SOURCE_DIR@;ARIADNE_BIN_DIR=@CMAKE_BINARY_DIR@/bin;LSAN_OPTIONS=suppressions=@CMAKE_SOURCE_DIR@/cmake/lsan.supp;TSAN_OPTIONS=suppressions=@CMAKE_SOURCE_DIR@/cmake/tsan.supp")
endforeach()
]=])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${file})
endfunction()
