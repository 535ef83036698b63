# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# cmake -DSOURCE=<repository> -DHEADER=<file> -P commit.cmake
#
# Writes a header with the commit of the repository, `+` if tracked files have changed, or nothing
# if it is none. Leaves the header alone if it says so already.
set(commit "")
execute_process(COMMAND git describe --always --abbrev=12 --dirty=+ --exclude=*
                WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit ERROR_QUIET
                OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
if(failed)
  set(commit "")
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define LANESCOPE_COMMIT \"@commit@\"\n" @ONLY)
