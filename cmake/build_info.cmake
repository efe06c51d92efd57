# The facts of the build that src/base/build.c reports: compiler, flags and libraries when configuring, the git revision
# and a hash of the sources at every build. Included after whirl_layer(base), when the compile options are set.
#   cmake -DSOURCE=<folder> -DHEADER=<file> -P cmake/build_info.cmake    writes revision and hash; the build runs this

if(CMAKE_SCRIPT_MODE_FILE)
  cmake_minimum_required(VERSION 3.25)
  # Computes a SHA-256 over the sums and names of files.
  function(hash_of result)
    set(sums "")
    foreach(file ${ARGN})
      file(SHA256 ${SOURCE}/${file} sum)
      string(APPEND sums "${sum} ${file}\n")
    endforeach()
    string(SHA256 hash "${sums}")
    set(${result} "${hash}" PARENT_SCOPE)
  endfunction()
  set(revision "unknown")
  execute_process(COMMAND git -C ${SOURCE} rev-parse HEAD OUTPUT_VARIABLE head RESULT_VARIABLE failed
                  ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(failed EQUAL 0)
    set(revision "${head}")
    execute_process(COMMAND git -C ${SOURCE} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes ERROR_QUIET)
    if(changes)
      string(APPEND revision ", modified")
    endif()
  endif()
  # Hash everything that is compiled into the library, and the options of its kernels.
  file(GLOB_RECURSE files RELATIVE ${SOURCE} ${SOURCE}/src/*.c ${SOURCE}/src/*.cc ${SOURCE}/src/*.h ${SOURCE}/src/*.inc ${SOURCE}/include/*.h)
  list(APPEND files cmake/layers.cmake cmake/whirlKernels.cmake)
  list(SORT files)
  hash_of(sources ${files})
  list(FILTER files INCLUDE REGEX "^src/rotor/pads/(pad_tables|reynolds|table|table_file)[.][ch]$")
  hash_of(film_sources ${files})
  # Rewritten only when it changes, so that nothing is compiled again without need.
  file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define BUILD_REVISION \"@revision@\"\n#define BUILD_SOURCES \"@sources@\"\n#define BUILD_FILM_SOURCES \"@film_sources@\"\n" @ONLY)
  return()
endif()

set(folder ${PROJECT_BINARY_DIR}/build_info)
set(BUILD_COMPILER "${CMAKE_C_COMPILER_ID} ${CMAKE_C_COMPILER_VERSION}")
set(BUILD_TYPE "${CMAKE_BUILD_TYPE}")

# Keeps the flags that affect the code: neither those of warnings nor the name of the folder in which packages are
# built.
string(TOUPPER "${CMAKE_BUILD_TYPE}" kind)
get_directory_property(options COMPILE_OPTIONS)
separate_arguments(given UNIX_COMMAND "${CMAKE_C_FLAGS} ${CMAKE_C_FLAGS_${kind}}")
set(flags ${given} ${options})
list(FILTER flags EXCLUDE REGEX "^-W|:-W|^-f[a-z]+-prefix-map=")
list(JOIN flags " " BUILD_FLAGS)
string(REPLACE "\\" "\\\\" BUILD_FLAGS "${BUILD_FLAGS}")
string(REPLACE "\"" "\\\"" BUILD_FLAGS "${BUILD_FLAGS}")

# SUNDIALS comes without a pkg-config file and says its version in a header.
set(sundials_version "of unknown version")
get_target_property(sundials_folder SUNDIALS::CVODES INTERFACE_INCLUDE_DIRECTORIES)
set(sundials_header "${sundials_folder}/sundials/sundials_config.h")
if(EXISTS "${sundials_header}")
  file(STRINGS "${sundials_header}" line REGEX "#define SUNDIALS_VERSION ")
  string(REGEX MATCH "\"(.+)\"" line "${line}")
  set(sundials_version "${CMAKE_MATCH_1}")
endif()
set(libraries "HDF5 ${HDF5_VERSION}" "SUNDIALS ${sundials_version}" "libyaml ${YAML_VERSION}"
    "muParser ${MUPARSER_VERSION}" "UDUNITS ${UDUNITS_VERSION}" "Jansson ${JANSSON_VERSION}"
    "OpenMP ${OpenMP_C_VERSION}" "Eigen ${EIGEN_VERSION}" "toml++ ${TOML_VERSION}" "matio ${MATIO_VERSION}"
    "zlib ${ZLIB_VERSION}")
list(JOIN libraries ", " BUILD_LIBRARIES)

configure_file(${CMAKE_CURRENT_LIST_DIR}/build_info.h.in ${folder}/build_info.h @ONLY)

set(write_revision ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DHEADER=${folder}/build_revision.h
    -P ${CMAKE_CURRENT_LIST_FILE})
add_custom_target(build_revision ALL COMMAND ${write_revision} BYPRODUCTS ${folder}/build_revision.h
                  COMMENT "Revision and hash of the sources" VERBATIM)
add_dependencies(whirl_base build_revision)
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/base/build.c PROPERTIES COMPILE_DEFINITIONS BUILD_INFO
                            INCLUDE_DIRECTORIES ${folder})
