# SPDX-License-Identifier: MIT
# What `cmake --install` gives: the program, static libraries, headers, and a CMake package with what
# makes programs of one's own (program.cmake), docs/own-programs.md.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/lanescope)
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/lanescope)

set(components simulator workloads kernels analysis cli)
foreach(component IN LISTS components)
  set_target_properties(lanescope_${component} PROPERTIES EXPORT_NAME ${component})
  list(APPEND libraries lanescope_${component})
endforeach()
set_target_properties(lanescope_host PROPERTIES EXPORT_NAME host)

# Who includes the headers compiles what is inline in them, which is to round as it does in the
# libraries. What vector programs need beyond that is not for everyone: lanescope::host.
target_compile_features(lanescope_simulator INTERFACE cxx_std_20)
target_compile_options(lanescope_simulator INTERFACE $<INSTALL_INTERFACE:-ffp-contract=off>)
target_include_directories(lanescope_simulator INTERFACE $<INSTALL_INTERFACE:${headers}>)
# Kernels' listings name our headers as they are included.
target_compile_options(lanescope_host INTERFACE
  $<INSTALL_INTERFACE:-fmacro-prefix-map=$<INSTALL_PREFIX>/${headers}/=>)
if(LANESCOPE_SANITIZE)
  target_link_options(lanescope_simulator INTERFACE $<INSTALL_INTERFACE:-fsanitize=address,undefined>)
endif()

install(TARGETS lanescope RUNTIME)
install(TARGETS ${libraries} lanescope_host EXPORT lanescope)
install(DIRECTORY simulator workloads kernels analysis DESTINATION ${headers}
        FILES_MATCHING PATTERN "*.h" PATTERN "analysis/cli" EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/kernels/include/kernels/widths.h DESTINATION ${headers}/kernels)

# The package. What is declared is known when all folders have been read.
install(EXPORT lanescope NAMESPACE lanescope:: FILE lanescope-targets.cmake DESTINATION ${package})
set(declared "")
get_property(scenes GLOBAL PROPERTY LANESCOPE_SCENES)
list(TRANSFORM scenes PREPEND LANESCOPE_SCENES_ OUTPUT_VARIABLE scene_lists)
foreach(property LANESCOPE_LANES LANESCOPE_WORKLOADS LANESCOPE_KERNELS LANESCOPE_STUDIES
                 LANESCOPE_SCENES ${scene_lists} LANESCOPE_KERNEL_SOURCES)
  get_property(values GLOBAL PROPERTY ${property})
  list(TRANSFORM values REPLACE "^${PROJECT_SOURCE_DIR}/" "\${lanescope_root}/")
  list(JOIN values " " values)
  string(APPEND declared "set_property(GLOBAL PROPERTY ${property} ${values})\n")
endforeach()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/lanescope-config.cmake.in
  ${PROJECT_BINARY_DIR}/lanescope-config.cmake INSTALL_DESTINATION ${package} PATH_VARS headers)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lanescope-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/lanescope-config.cmake
  ${PROJECT_BINARY_DIR}/lanescope-config-version.cmake
  scripts/cmake/compiler.cmake
  scripts/cmake/instructions.cmake
  scripts/cmake/program.cmake
  scripts/cmake/registry.cmake
  scripts/cmake/vector_programs.cmake
  DESTINATION ${package})
