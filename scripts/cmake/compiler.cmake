# SPDX-License-Identifier: MIT
# Stops if the compiler is older than those that will do. What decides is std::source_location, and
# operators and conditions on vector types in templates.
set(lanescope_oldest_GNU 12)
set(lanescope_oldest_Clang 16)
set(lanescope_oldest ${lanescope_oldest_${CMAKE_CXX_COMPILER_ID}})
if(NOT lanescope_oldest OR CMAKE_CXX_COMPILER_VERSION VERSION_LESS lanescope_oldest)
  message(FATAL_ERROR
    "Lanescope needs GCC ${lanescope_oldest_GNU} or Clang ${lanescope_oldest_Clang}, or newer; "
    "${CMAKE_CXX_COMPILER} is ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}. "
    "Choose one with -DCMAKE_CXX_COMPILER=.")
endif()
