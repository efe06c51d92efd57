# The exports of libwhirl.so, read from the headers. Functions of the stable headers, include/whirl/*.h, have the
# version WHIRL_<ABI>. All others (include/whirl/engine) have that of the minor version: the dynamic linker refuses a
# program that was compiled with other headers (docs/abi.md). No other symbol is visible from outside.

# Appends the names of the functions that a header declares.
function(whirl_declared header names)
  file(READ ${header} text)
  string(REGEX REPLACE "//[^\n]*|typedef[^\n]*|static inline[^\n]*" "" text "${text}")
  string(REGEX MATCHALL "whirl_[a-z0-9_]+\\(" found "${text}")
  # Functions that custom elements call have short names in the sources.
  string(REGEX MATCHALL "#define [a-z_]+ whirl_[a-z_]+\n" renamed "${text}")
  string(REGEX REPLACE "#define [a-z_]+ |\n" "" renamed "${renamed}")
  string(REPLACE "(" "" found "${found}")
  set(${names} ${${names}} ${found} ${renamed} PARENT_SCOPE)
endfunction()

# The lines of a version script for these names.
function(whirl_version_node name names out)
  list(REMOVE_DUPLICATES names)
  list(SORT names)
  list(JOIN names ";\n    " lines)
  set(${out} "${name} {\n  global:\n    ${lines};\n" PARENT_SCOPE)
endfunction()

# Writes the version script of the linker. Headers that change are read again.
function(whirl_exports script)
  file(GLOB stable_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/whirl/*.h)
  file(GLOB other_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/whirl/engine/*.h)
  list(APPEND stable_headers ${PROJECT_SOURCE_DIR}/cmake/version.h.in)
  list(APPEND other_headers ${PROJECT_SOURCE_DIR}/src/rotor/assembly.h ${PROJECT_SOURCE_DIR}/src/rotor/element.h)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${stable_headers} ${other_headers})
  foreach(kind stable other)
    set(${kind} "")
    foreach(header ${${kind}_headers})
      whirl_declared(${header} ${kind})
    endforeach()
  endforeach()
  list(REMOVE_ITEM other ${stable})
  whirl_version_node(WHIRL_${WHIRL_ABI} "${stable}" first)
  whirl_version_node(WHIRL_${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} "${other}" second)
  file(CONFIGURE OUTPUT ${script} CONTENT "${first}  local:\n    *;\n};\n\n${second}};\n" @ONLY)
endfunction()
