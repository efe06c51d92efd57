# ccache, where it is installed: objects that another tree of these sources has compiled with the same options are
# reused.
find_program(CCACHE ccache)
if(CCACHE)
  foreach(language C CXX)
    set(CMAKE_${language}_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
                                            CCACHE_NOHASHDIR=1 ${CCACHE})
  endforeach()
endif()
