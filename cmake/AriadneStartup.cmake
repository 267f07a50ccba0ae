# MRPT brings 180 shared libraries. At a program's start the dynamic linker asks them for each
# symbol in the order of the link line, and most symbols are those that a few libraries have for
# themselves. With these few in front it asks half as often, and a program starts in 0.07 s
# instead of 0.09 (doc/lab/benchmarks/README.md). Where ldd or one of them is missing, only that is lost.
set(ARIADNE_RICH_IN_SYMBOLS xerces-c geos gdal mrpt-expr crypto proj poppler kmldom sqlite3 netcdf
  draco gdcmMSFF)

# Sets `out` to the files of those libraries that MRPT's maps stand on.
function(ariadne_find_rich_in_symbols out)
  get_target_property(maps mrpt::maps LOCATION)
  execute_process(COMMAND ldd ${maps} OUTPUT_VARIABLE libraries ERROR_QUIET RESULT_VARIABLE ignored)
  set(found "")
  foreach(name IN LISTS ARIADNE_RICH_IN_SYMBOLS)
    if(libraries MATCHES "=> ([^\n]*/lib${name}[-0-9.]*\\.so[^ \n]*) \\(")
      list(APPEND found ${CMAKE_MATCH_1})
    endif()
  endforeach()
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

set(ARIADNE_FIRST_LIBRARIES "")
if(NOT ARIADNE_SANITIZE)  # a sanitizer's library must be the first
  ariadne_find_rich_in_symbols(ARIADNE_FIRST_LIBRARIES)
endif()

# For a program that links MRPT.
function(ariadne_start_fast target)
  if(ARIADNE_FIRST_LIBRARIES)
    target_link_options(${target} PRIVATE "LINKER:--push-state,--no-as-needed"
      ${ARIADNE_FIRST_LIBRARIES} "LINKER:--pop-state")
  endif()
endfunction()
