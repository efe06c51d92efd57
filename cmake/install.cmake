# `cmake --install`: the commands, libwhirl shared and static, headers, pkg-config and CMake package files, the man page,
# bash completion and the cases.
include(CMakePackageConfigHelpers)

set_target_properties(whirl_shared PROPERTIES EXPORT_NAME whirl)
install(TARGETS whirl RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TARGET whirl-mpi)
  install(TARGETS whirl-mpi RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(TARGETS whirl_shared EXPORT whirlTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS whirl_static ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/whirl ${PROJECT_BINARY_DIR}/include/whirl DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.h")
# Headers for custom elements, which whirl_element() of whirlKernels.cmake compiles.
install(FILES src/base/vector.h src/base/elementary.h src/base/words/keys.h src/rotor/assembly.h src/rotor/block.h
              src/rotor/body.h src/rotor/coupling.h src/rotor/drive.h src/rotor/element.h src/rotor/generic.h src/rotor/numbers.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/whirl/element)
install(FILES docs/whirl.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES cli/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME whirl)
if(TARGET whirl-mpi)
  install(FILES cli/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME whirl-mpi)
endif()
if(NOT TARGET whirl-mpi)
  install(CODE "message(STATUS \"Not installed: whirl-mpi, for mpirun; cmake ${PROJECT_BINARY_DIR} -DWHIRL_MPI=ON builds it, too\")")
endif()
# The explorer's template, where `make explorer` has built it.
install(FILES ${PROJECT_BINARY_DIR}/explorer/template.html DESTINATION ${CMAKE_INSTALL_DATADIR}/whirl
        RENAME explorer.html OPTIONAL)
install(CODE "if(NOT EXISTS \"${PROJECT_BINARY_DIR}/explorer/template.html\")
  message(STATUS \"Not installed: the explorer's page; make explorer builds it\")
endif()")
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/whirl FILES_MATCHING PATTERN "*.yaml")

# The static library leaves its own libraries to the program that links it: those that have a pkg-config file by that
# name, the others as linker options.
set(WHIRL_STATIC_MODULES hdf5-serial yaml-0.1 udunits muparser jansson matio zlib)
set(WHIRL_STATIC_OPTIONS "")
get_target_property(sundials SUNDIALS::CVODES INTERFACE_LINK_LIBRARIES)
foreach(file ${sundials})
  get_filename_component(name ${file} NAME_WE)
  string(REGEX REPLACE "^lib" "-l" option ${name})
  list(APPEND WHIRL_STATIC_OPTIONS ${option})
endforeach()
list(APPEND WHIRL_STATIC_OPTIONS ${OpenMP_C_FLAGS} -lstdc++ -lm)
string(JOIN " " WHIRL_PC_MODULES ${WHIRL_STATIC_MODULES})
string(JOIN " " WHIRL_PC_OPTIONS ${WHIRL_STATIC_OPTIONS})

# Path from the folder of libraries up to the prefix: a relative one, so that an installed tree can be moved.
string(REGEX REPLACE "[^/]+" ".." WHIRL_PC_PREFIX ${CMAKE_INSTALL_LIBDIR})
configure_file(cmake/whirl.pc.in whirl.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/whirl.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/whirl)
install(EXPORT whirlTargets NAMESPACE whirl:: DESTINATION ${package})
configure_package_config_file(cmake/whirlConfig.cmake.in whirlConfig.cmake INSTALL_DESTINATION ${package}
                              PATH_VARS CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/whirlConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/whirlConfig.cmake ${PROJECT_BINARY_DIR}/whirlConfigVersion.cmake
              cmake/whirlKernels.cmake DESTINATION ${package})
