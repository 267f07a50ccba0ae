# cmake -D HELP2MAN=x -D PROGRAM=x -D PAGE=x.1.gz -D VERSION=x -P AriadneManPage.cmake
get_filename_component(folder "${PAGE}" DIRECTORY)
file(MAKE_DIRECTORY "${folder}")
execute_process(COMMAND "${PROGRAM}" --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "^[^\n.;:(]*" about "${help}")
execute_process(
  COMMAND "${HELP2MAN}" --no-info "--version-string=${VERSION}" "--name=${about}" "${PROGRAM}"
  COMMAND gzip -9n OUTPUT_FILE "${PAGE}" COMMAND_ERROR_IS_FATAL ANY)
