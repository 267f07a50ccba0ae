# cmake -D HELP2MAN=x -D PROGRAM=x -D PAGE=x.1.gz -D VERSION=x -P AriadneManPage.cmake: the program's --help as a man page,
# with sections for its examples and for each subcommand's --help, line by line as they are.
cmake_minimum_required(VERSION 3.25)
get_filename_component(folder "${PAGE}" DIRECTORY)
get_filename_component(name "${PROGRAM}" NAME)
function(help_of out)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
  set(${out} "${help}" PARENT_SCOPE)
endfunction()
function(add_section title text)
  string(REPLACE "\\" "\\e" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  string(REPLACE "\n." "\n\\&." text "${text}")
  set(sections "${sections}[>${title}]\n.nf\n${text}.fi\n" PARENT_SCOPE)
endfunction()

help_of(help)
string(REGEX MATCH "^[^\n.;:(]*" about "${help}")
string(REGEX REPLACE "[, ]+$" "" about "${about}")
string(REPLACE "\n  -h,--help" "\n  -h, --help" help "${help}")  # as help2man reads it

set(sections "")
string(REGEX MATCH "\nSubcommands:\n(  [^\n]*\n)+" list "${help}")
string(REGEX MATCHALL "\n  [a-z][a-z-]*" subcommands "${list}")
foreach(subcommand IN LISTS subcommands)
  string(STRIP "${subcommand}" subcommand)
  help_of(text ${subcommand})
  string(REGEX REPLACE "\n\n[^ \n][^\n]*[^:\n]\n.*$" "\n" text "${text}")  # what the program's own help says as well
  add_section(${subcommand} "${text}")
endforeach()
if(help MATCHES "\nExamples?:\n((  [^\n]*\n)+)")
  add_section(examples "${CMAKE_MATCH_1}")
  string(REPLACE "${CMAKE_MATCH_0}" "\n" help "${help}")
endif()

# help2man runs a program: this one prints the help without what has a section of its own.
file(WRITE "${folder}/help/${name}.txt" "${help}")
file(WRITE "${folder}/help/${name}.sections" "[see also]\nThe documents in /usr/share/doc/ariadne\\-doc.\n${sections}")
file(WRITE "${folder}/help/${name}" "#!/bin/sh\nexec cat '${folder}/help/${name}.txt'\n")
file(CHMOD "${folder}/help/${name}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
execute_process(
  COMMAND "${HELP2MAN}" --no-info "--version-string=${VERSION}" "--name=${about}"
    "--include=${folder}/help/${name}.sections" "${folder}/help/${name}"
  COMMAND gzip -9n OUTPUT_FILE "${PAGE}" COMMAND_ERROR_IS_FATAL ANY)
