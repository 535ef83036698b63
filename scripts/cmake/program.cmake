# SPDX-License-Identifier: MIT
# Programs and what they consist of, in the repository and, from an installed package, outside of it.
# A kind of work, its scenes, a kernel or a study is declared once, where it is built; the order of
# declaration is the order in every list and table. Each program gets generated registries
# (registry.cmake) of all that is declared, and of its own beside it.
#
# What is declared is in global properties, which the package writes down (install.cmake):
#
#   LANESCOPE_WORKLOADS, LANESCOPE_KERNELS, LANESCOPE_STUDIES   names of descriptors
#   LANESCOPE_SCENES            functions that list scenes; for each function f
#   LANESCOPE_SCENES_f          the type, header and prefix of its descriptors, and their names
#   LANESCOPE_KERNEL_SOURCES    files in which kernels issue instructions
#   LANESCOPE_LANES             the numbers of lanes that machines are built with
#   LANESCOPE_ROOT              the folder that headers are included from

# lanescope_workloads(name...)  defined as `extern const Workload w_<name>`
function(lanescope_workloads)
  set_property(GLOBAL APPEND PROPERTY LANESCOPE_WORKLOADS ${ARGN})
endfunction()

# lanescope_kernels(name...)  defined as `extern const Kernel k_<name>`
function(lanescope_kernels)
  set_property(GLOBAL APPEND PROPERTY LANESCOPE_KERNELS ${ARGN})
endfunction()

# lanescope_studies(name...)  defined as `extern const Study study_<name>`
function(lanescope_studies)
  set_property(GLOBAL APPEND PROPERTY LANESCOPE_STUDIES ${ARGN})
endfunction()

# lanescope_scenes(<function> <TYPE> <header> <prefix> name...)
#
# The scenes of a kind of work, which <function> of its <header> lists. Each is a file <name>.cpp of
# the current folder that defines `extern const <TYPE> <prefix><name>`.
function(lanescope_scenes function type header prefix)
  foreach(name IN LISTS ARGN)
    target_sources(lanescope_workloads PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp)
  endforeach()
  set_property(GLOBAL APPEND PROPERTY LANESCOPE_SCENES ${function})
  set_property(GLOBAL PROPERTY LANESCOPE_SCENES_${function} ${type} ${header} ${prefix} ${ARGN})
endfunction()

# lanescope_kernel_sources(file...)  in which kernels issue instructions, for annotated listings.
# Paths are relative to the current folder.
function(lanescope_kernel_sources)
  foreach(file IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH file)
    set_property(GLOBAL APPEND PROPERTY LANESCOPE_KERNEL_SOURCES ${file})
  endforeach()
endfunction()

# lanescope_program(<target> [BARE] [LANES n...] [KERNELS kernel...] [INSTRUCTIONS file.h...]
#                   [SCENES file.cpp...] [WORKLOADS workload...] [STUDIES study...] [SOURCES file...])
#
# Makes a program with every command, of everything declared and then its own. A BARE program has no
# commands: it runs kernels in a main() of its own. A target that exists already, with a main() or
# with tests, gets the registries alone. Paths are relative to the current folder.
#
#   KERNELS       <name>.h    a vector program, which is instantiated, and beside it <name>.cpp,
#                             which defines `k_<name>` (vector_programs.cmake says the rest)
#                 <name>.cpp  defines `k_<name>`
#                 <name>      `k_<name>` is defined elsewhere in the program
#   INSTRUCTIONS  headers whose objects of `Instruction<Struct>` are instructions of the program
#   SCENES        files that define scenes as those of a kind of work are defined
#   WORKLOADS     <name>.cpp or <name>, which defines `w_<name>`
#   STUDIES       <name>.cpp or <name>, which defines `study_<name>`
#   SOURCES       further files: what else is compiled, and headers in which kernels issue
#                 instructions, for annotated listings
#   LANES         numbers of lanes, of 8, 16, 32 and 64, that the KERNELS are built for; fewer compile
#                 faster (default: those that Lanescope was built with)
#
# The target is compiled for the host that Lanescope was built for (lanescope::host); what else is
# linked to it is not.
function(lanescope_program target)
  cmake_parse_arguments(own "BARE" ""
    "LANES;KERNELS;INSTRUCTIONS;SCENES;WORKLOADS;STUDIES;SOURCES" ${ARGN})
  if(own_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "lanescope_program(${target}): '${own_UNPARSED_ARGUMENTS}' follows none of "
      "LANES, KERNELS, INSTRUCTIONS, SCENES, WORKLOADS, STUDIES and SOURCES")
  endif()
  foreach(lanes IN LISTS own_LANES)
    if(NOT lanes MATCHES "^(8|16|32|64)$")
      message(FATAL_ERROR "lanescope_program(${target} LANES ${lanes}): use some of 8, 16, 32, 64")
    endif()
  endforeach()
  lanescope_program_target(${target} ${own_BARE} ${own_SOURCES})
  lanescope_compile_programs(${target} "${own_LANES}" ${own_KERNELS})

  lanescope_program_registry(${target} workloads Workload workloads/work.h w_ LANESCOPE_WORKLOADS
                             ${own_WORKLOADS})
  lanescope_program_scenes(${target} ${own_SCENES})
  lanescope_program_registry(${target} kernels Kernel kernels/kernel.h k_ LANESCOPE_KERNELS
                             ${own_KERNELS})
  lanescope_program_instructions(${target} ${own_INSTRUCTIONS})
  if(own_BARE)
    return()
  endif()
  lanescope_program_registry(${target} studies Study analysis/studies/study.h study_
                             LANESCOPE_STUDIES ${own_STUDIES})
  set(headers ${own_KERNELS} ${own_INSTRUCTIONS} ${own_SOURCES})
  list(FILTER headers INCLUDE REGEX "\\.")
  lanescope_generate_kernel_sources(${target} ${headers})
endfunction()

# The executable, unless there is one, and what it is compiled with.
function(lanescope_program_target target is_bare)
  if(NOT TARGET ${target})
    add_executable(${target})
    if(is_bare)
      target_link_libraries(${target} PRIVATE lanescope::kernels)
    else()
      target_link_libraries(${target} PRIVATE lanescope::cli)
    endif()
  endif()
  target_link_libraries(${target} PRIVATE lanescope::host)
  # Listings show paths from the project on.
  get_property(root GLOBAL PROPERTY LANESCOPE_ROOT)
  if(NOT root STREQUAL PROJECT_SOURCE_DIR)
    target_compile_options(${target} PRIVATE -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
  endif()
  foreach(file IN LISTS ARGN)
    lanescope_require_file(${target} SOURCES ${file})
    cmake_path(ABSOLUTE_PATH file)
    target_sources(${target} PRIVATE ${file})
  endforeach()
endfunction()

# Instantiates the kernels that are named by their headers, those of a folder together.
function(lanescope_compile_programs target lanes)
  set(folders "")
  foreach(header IN LISTS ARGN)
    cmake_path(GET header EXTENSION LAST_ONLY extension)
    if(NOT extension STREQUAL ".h")
      continue()
    endif()
    lanescope_require_file(${target} KERNELS ${header})
    cmake_path(GET header PARENT_PATH folder)
    cmake_path(GET header STEM LAST_ONLY program)
    string(MAKE_C_IDENTIFIER "in_${folder}" key)
    set(folder_of_${key} "${folder}")
    list(APPEND folders ${key})
    list(APPEND programs_of_${key} ${program})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  if(folders)
    target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
    if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
      message(WARNING "lanescope_program(${target}): vector programs that are not optimized are slow; "
        "choose with -DCMAKE_BUILD_TYPE=Release")
    endif()
  endif()
  foreach(key IN LISTS folders)
    lanescope_vector_programs(${target} "${folder_of_${key}}" ${programs_of_${key}} LANES ${lanes}
                              INTO ${CMAKE_CURRENT_BINARY_DIR}/${target}_programs)
  endforeach()
endfunction()

# The registry of what is declared in a global property, and of a program's own: names, or files, of
# which <name>.cpp becomes part of the target.
function(lanescope_program_registry target function type header prefix property)
  string(TOUPPER ${function} argument)
  get_property(names GLOBAL PROPERTY ${property})
  foreach(entry IN LISTS ARGN)
    cmake_path(REPLACE_EXTENSION entry LAST_ONLY cpp OUTPUT_VARIABLE file)
    if(NOT file STREQUAL "${entry}.cpp")
      lanescope_require_file(${target} "${argument} ${entry}" ${file})
      cmake_path(ABSOLUTE_PATH file)
      target_sources(${target} PRIVATE ${file})
    endif()
    cmake_path(GET entry STEM LAST_ONLY name)
    list(APPEND names ${name})
  endforeach()
  lanescope_generate_registry(${target} ${target}_${function}.cpp ${function} ${type} ${header}
                              ${prefix} ${names})
endfunction()

# The registries of scenes; a file's kind is that of the descriptor which it defines.
function(lanescope_program_scenes target)
  get_property(functions GLOBAL PROPERTY LANESCOPE_SCENES)
  set(types "")
  set(left ${ARGN})
  foreach(function IN LISTS functions)
    get_property(scenes GLOBAL PROPERTY LANESCOPE_SCENES_${function})
    list(POP_FRONT scenes type header prefix)
    list(APPEND types ${type})
    foreach(file IN LISTS ARGN)
      lanescope_require_file(${target} SCENES ${file})
      cmake_path(GET file STEM LAST_ONLY name)
      file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/${file} definition
           REGEX "const +(lanescope::)?${type} +${prefix}${name} *[{;=]")
      if(definition)
        target_sources(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/${file})
        list(APPEND scenes ${name})
        list(REMOVE_ITEM left ${file})
      endif()
    endforeach()
    lanescope_generate_registry(${target} ${target}_${function}.cpp ${function} ${type} ${header}
                                ${prefix} ${scenes})
  endforeach()
  list(JOIN types ", " types)
  foreach(file IN LISTS left)
    message(FATAL_ERROR "lanescope_program(${target} SCENES ${file}): no scene is defined there; a "
      "file <name>.cpp ends in `extern const TYPE PREFIX<name>{...}`, TYPE being one of ${types}, as "
      "in workloads/*/scenes/")
  endforeach()
endfunction()

# Stops if a file that was given for an argument does not exist.
function(lanescope_require_file target argument file)
  cmake_path(ABSOLUTE_PATH file OUTPUT_VARIABLE absolute)
  if(NOT EXISTS ${absolute})
    message(FATAL_ERROR "lanescope_program(${target} ${argument}): there is no file ${absolute}")
  endif()
endfunction()

function(lanescope_generate_kernel_sources target)
  get_property(files GLOBAL PROPERTY LANESCOPE_KERNEL_SOURCES)
  get_property(root GLOBAL PROPERTY LANESCOPE_ROOT)
  set(entries "")
  foreach(file IN LISTS files ARGN)
    cmake_path(ABSOLUTE_PATH file NORMALIZE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    # As the compiler names it: see -fmacro-prefix-map.
    set(base ${root})
    cmake_path(IS_PREFIX base ${file} is_ours)
    if(NOT is_ours)
      set(base ${PROJECT_SOURCE_DIR})
    endif()
    cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${base})
    string(APPEND entries "      {\"${file}\", R\"source(${text})source\"},\n")
  endforeach()
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/${target}_kernel_sources.cpp)
  file(CONFIGURE OUTPUT ${generated} CONTENT [[
// Generated by scripts/cmake/program.cmake.
#include "analysis/annotation/sources.h"

namespace lanescope {
const std::vector<SourceFile>& kernel_sources() {
  static const std::vector<SourceFile> files{
@entries@  };
  return files;
}
}  // namespace lanescope
]] @ONLY)
  target_sources(${target} PRIVATE ${generated})
endfunction()
