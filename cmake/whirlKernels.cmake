# Sources that are compiled once for every instruction set, with VECTOR_ISA set to its number (vector.h): the library's
# kernels and the elements of its users.

# Name, number, options. Kernels of 512 bits are scheduled for the first processors that run them at full speed: that
# gains 3 percent. -fno-tree-slp-vectorize: if gcc 12 makes vectors of pairs of numbers, it fuses c a - s b next to
# s a + c b in spite of -ffp-contract=off.
set(WHIRL_ISAS "scalar 0" "128 1")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT WHIRL_PORTABLE)
  set(wide "fma 2 -mfma -fno-tree-slp-vectorize" "avx2 3 -mavx2 -mfma" "avx512 4 -mavx512f -mfma -mtune=icelake-server")
  if(WHIRL_WIDE)
    list(FILTER wide INCLUDE REGEX "^${WHIRL_WIDE} ")
    string(REGEX REPLACE "^[a-z0-9]+ ([0-9]).*" "\\1" number "${wide}")
    add_compile_definitions(WHIRL_WIDE=${WHIRL_WIDE} WHIRL_WIDE_ISA=${number})
  endif()
  list(APPEND WHIRL_ISAS ${wide})
endif()

# Every product is rounded where it is written (no contraction), so that compilers and widths agree to the bit.
set(WHIRL_ROUNDING -ffp-contract=off -fno-math-errno -fno-trapping-math)

# The address sanitizer finds wrong addresses when they are used, so pointers need no check beforehand. In kernels such
# checks would multiply the time to compile by five, and so would the unrolling that loops request (VECTOR_FOR), which
# -O1 leaves out.
set(WHIRL_SANITIZED_KERNELS "")
if(WHIRL_SANITIZE MATCHES address AND WHIRL_SANITIZE MATCHES undefined)
  set(WHIRL_SANITIZED_KERNELS -O1 -fno-sanitize=pointer-overflow,null,object-size)
endif()
# Fuzzers search new paths through readers of files, not through kernels.
if(WHIRL_FUZZ)
  list(APPEND WHIRL_SANITIZED_KERNELS -fno-sanitize=fuzzer-no-link)
endif()

# Writes for every instruction set a file into `folder` that includes `source`, and adds these files to the list
# `result`. The compiler finds `source` by its place in `root`: with an absolute path, compiler caches could not be
# shared by several trees.
function(whirl_kernel source root folder result)
  get_filename_component(stem ${source} NAME_WE)
  file(RELATIVE_PATH included ${root} ${source})
  foreach(isa ${WHIRL_ISAS})
    separate_arguments(isa)
    list(POP_FRONT isa suffix number)
    set(file ${folder}/${stem}_${suffix}.c)
    file(CONFIGURE OUTPUT ${file} CONTENT "#define VECTOR_ISA ${number}\n#include \"${included}\"\n")
    set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS "${isa};${WHIRL_SANITIZED_KERNELS}")
    list(APPEND ${result} ${file})
  endforeach()
  set(${result} ${${result}} PARENT_SCOPE)
endfunction()

# Adds a custom element to a target: the file that defines it, compiled as the library's elements are.
#   whirl_element(<target> <file.c>)
function(whirl_element target source)
  get_filename_component(source ${source} ABSOLUTE)
  get_filename_component(folder ${source} DIRECTORY)
  get_filename_component(above ${folder} DIRECTORY)
  whirl_kernel(${source} ${above} ${CMAKE_CURRENT_BINARY_DIR}/kernels/${target} files)
  set_property(SOURCE ${files} APPEND PROPERTY COMPILE_OPTIONS ${WHIRL_ROUNDING})
  set_source_files_properties(${files} PROPERTIES INCLUDE_DIRECTORIES "${folder};${above}" OBJECT_DEPENDS ${source})
  target_sources(${target} PRIVATE ${files})
endfunction()
