# cmake -D SOURCE=<root> -D HEADER=<file> -P write_commit.cmake
# Writes the commit of the sources into HEADER, if it has changed since.
cmake_policy(VERSION 3.20) # as in CMakeLists.txt
find_program(GIT git)
set(commit "unknown")
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --show-prefix --short=12 HEAD
    OUTPUT_VARIABLE answer ERROR_QUIET RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE)
  # The prefix is empty where SOURCE is the root of its repository: sources inside another one have no commit of their own.
  if(NOT failed AND answer MATCHES "^\n?([0-9a-f]+)$")
    set(commit ${CMAKE_MATCH_1})
    execute_process(COMMAND ${GIT} -C ${SOURCE} diff --quiet HEAD -- . RESULT_VARIABLE changed ERROR_QUIET)
    if(changed)
      string(APPEND commit ", changed since")
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define HYBRID_COMMIT \"@commit@\"\n" @ONLY)
