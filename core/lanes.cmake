# SPDX-License-Identifier: MIT
# Lane code: the same sources compiled once per instruction set, each into objects of its own.
# schuler_lane_sources(file.c ...) may be called from any floor.

if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(SCHULER_ISAS scalar sse2 avx2 avx512)
else()
  set(SCHULER_ISAS scalar sse2) # "sse2" is the portable two-lane build there
endif()
set(SCHULER_LANES_scalar 1)
set(SCHULER_LANES_sse2 2)
set(SCHULER_LANES_avx2 4)
set(SCHULER_LANES_avx512 8)
set(SCHULER_FLAGS_scalar -fno-tree-vectorize)
set(SCHULER_FLAGS_sse2 "")
set(SCHULER_FLAGS_avx2 -mavx2)
set(SCHULER_FLAGS_avx512 -mavx512f -mavx512dq -mavx512vl -mavx512bw)
if(CMAKE_C_COMPILER_ID MATCHES "Clang")
  list(APPEND SCHULER_FLAGS_scalar -fno-slp-vectorize)
  list(APPEND SCHULER_FLAGS_avx512 -mprefer-vector-width=512)
endif()

foreach(isa IN LISTS SCHULER_ISAS)
  add_library(schuler_lanes_${isa} OBJECT)
  set_target_properties(schuler_lanes_${isa} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_definitions(schuler_lanes_${isa} PRIVATE SCHULER_BUILDING
    SCHULER_LANES=${SCHULER_LANES_${isa}} SCHULER_ISA_SUFFIX=${isa})
  target_compile_options(schuler_lanes_${isa} PRIVATE ${SCHULER_FLAGS_${isa}})
  target_link_libraries(schuler_lanes_${isa} PRIVATE schuler_flags)
  list(APPEND SCHULER_LANE_OBJECTS $<TARGET_OBJECTS:schuler_lanes_${isa}>)
endforeach()

# X(isa) for every instruction set of this build, used where the tables of lane code are collected.
set(_lines "")
foreach(isa IN LISTS SCHULER_ISAS)
  string(APPEND _lines "X(${isa})\n")
endforeach()
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/generated/schuler_isas.def CONTENT "${_lines}")

# Sources of the library that are compiled once, and lane code that is compiled for each instruction set.
function(schuler_sources)
  foreach(source IN LISTS ARGN)
    target_sources(schuler_objects PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/${source})
  endforeach()
endfunction()

function(schuler_lane_sources)
  foreach(source IN LISTS ARGN)
    foreach(isa IN LISTS SCHULER_ISAS)
      target_sources(schuler_lanes_${isa} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/${source})
    endforeach()
  endforeach()
endfunction()

# schuler_table(NAME word...) writes generated/NAME.def with X(word) for each word.
function(schuler_table name)
  set(lines "")
  foreach(word IN LISTS ARGN)
    string(APPEND lines "X(${word})\n")
  endforeach()
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/generated/${name}.def CONTENT "${lines}")
endfunction()
