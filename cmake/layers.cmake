# A layer: all of src/<name>/*.c as an object library that sees the public headers and its own folder only.
#   whirl_layer(<name> NEEDS <layers below> LIBRARIES <imported targets>)
# What lies in its folders kernels and elements is compiled once for every instruction set, with VECTOR_ISA its number
# (src/base/vector.h); the processor is asked when the program runs.
set_property(GLOBAL PROPERTY WHIRL_LAYERS "")

# Name, number, options. Kernels of 512 bits are scheduled for the first processors that have them at full speed: worth
# 3 percent.
set(WHIRL_ISAS "scalar 0" "128 1")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND WHIRL_ISAS "fma 2 -mfma" "avx2 3 -mavx2 -mfma" "avx512 4 -mavx512f -mfma -mtune=icelake-server")
endif()

# Writes for every instruction set a file that includes `source`, and adds them to the list `result`.
function(whirl_kernel source layer result)
  get_filename_component(stem ${source} NAME_WE)
  foreach(isa ${WHIRL_ISAS})
    separate_arguments(isa)
    list(POP_FRONT isa suffix number)
    set(file ${PROJECT_BINARY_DIR}/kernels/${layer}/${stem}_${suffix}.c)
    file(CONFIGURE OUTPUT ${file} CONTENT "#define VECTOR_ISA ${number}\n#include \"${source}\"\n")
    set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS "${isa}")
    list(APPEND ${result} ${file})
  endforeach()
  set(${result} ${${result}} PARENT_SCOPE)
endfunction()

function(whirl_layer name)
  cmake_parse_arguments(LAYER "" "" "NEEDS;LIBRARIES" ${ARGN})
  set(folder ${PROJECT_SOURCE_DIR}/src/${name})
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.c)
  file(GLOB kernels CONFIGURE_DEPENDS ${folder}/kernels/*.c ${folder}/elements/*.c)
  foreach(kernel ${kernels})
    whirl_kernel(${kernel} ${name} sources)
  endforeach()
  add_library(whirl_${name} OBJECT ${sources})
  target_include_directories(whirl_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/include
                             PRIVATE ${PROJECT_SOURCE_DIR}/src/base ${PROJECT_SOURCE_DIR}/src/${name})
  foreach(library ${LAYER_LIBRARIES})
    target_link_libraries(whirl_${name} PRIVATE ${library})
  endforeach()
  # The closure of the layers below and the libraries they need, for tests of one layer.
  set(closure ${name})
  set(libraries ${LAYER_LIBRARIES})
  foreach(below ${LAYER_NEEDS})
    get_target_property(more whirl_${below} WHIRL_CLOSURE)
    list(APPEND closure ${more})
    get_target_property(more whirl_${below} WHIRL_LINKS)
    if(more)
      list(APPEND libraries ${more})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES closure)
  list(REMOVE_DUPLICATES libraries)
  set_target_properties(whirl_${name} PROPERTIES WHIRL_CLOSURE "${closure}" WHIRL_LINKS "${libraries}")
  set_property(GLOBAL APPEND PROPERTY WHIRL_LAYERS ${name})
endfunction()

# Links a program with a layer and all below it.
function(whirl_link_layer program layer)
  get_target_property(closure whirl_${layer} WHIRL_CLOSURE)
  get_target_property(libraries whirl_${layer} WHIRL_LINKS)
  foreach(name ${closure})
    target_sources(${program} PRIVATE $<TARGET_OBJECTS:whirl_${name}>)
  endforeach()
  if(libraries)
    target_link_libraries(${program} PRIVATE ${libraries})
  endif()
  target_link_libraries(${program} PRIVATE m)
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/include
                             ${PROJECT_SOURCE_DIR}/src/base ${PROJECT_SOURCE_DIR}/src/${layer})
endfunction()

# libwhirl, shared and static, of all layers.
function(whirl_library)
  get_property(layers GLOBAL PROPERTY WHIRL_LAYERS)
  set(objects "")
  set(libraries "")
  foreach(name ${layers})
    list(APPEND objects $<TARGET_OBJECTS:whirl_${name}>)
    get_target_property(more whirl_${name} WHIRL_LINKS)
    if(more)
      list(APPEND libraries ${more})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES libraries)
  add_library(whirl_shared SHARED ${objects})
  add_library(whirl_static STATIC ${objects})
  foreach(kind shared static)
    set_target_properties(whirl_${kind} PROPERTIES OUTPUT_NAME whirl VERSION ${PROJECT_VERSION}
                          SOVERSION ${PROJECT_VERSION_MAJOR})
    target_include_directories(whirl_${kind} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                               $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:include>)
    target_link_libraries(whirl_${kind} PRIVATE ${libraries} m)
  endforeach()
  # Only whirl_* is exported: private names have no such prefix.
  target_link_options(whirl_shared PRIVATE -Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/exports.map)
  set_target_properties(whirl_shared PROPERTIES LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/exports.map)
endfunction()
