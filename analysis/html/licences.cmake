# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# cmake -DMODULES=<node_modules> -DOUTPUT=<file> -P licences.cmake
#
# Writes the licences of all packages in one text; packages with the same text share it.
file(GLOB files ${MODULES}/*/LICENSE* ${MODULES}/*/license*)
set(digests "")
foreach(file IN LISTS files)
  cmake_path(GET file PARENT_PATH folder)
  cmake_path(GET folder FILENAME package)
  file(MD5 ${file} digest)
  if(NOT digest IN_LIST digests)
    list(APPEND digests ${digest})
    set(file_${digest} ${file})
  endif()
  list(APPEND packages_${digest} ${package})
endforeach()
file(WRITE ${OUTPUT} "")
foreach(digest IN LISTS digests)
  file(READ ${file_${digest}} text)
  list(JOIN packages_${digest} ", " packages)
  file(APPEND ${OUTPUT} "== ${packages}\n\n")
  file(APPEND ${OUTPUT} "${text}\n\n")
endforeach()
