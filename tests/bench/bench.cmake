# SPDX-License-Identifier: MIT
# The instruction count of a lane-step. Only where the limits were taken: optimised by gcc 12 on x86-64.
add_executable(lane_steps bench/lane_steps.c)
target_link_libraries(lane_steps PRIVATE schuler_internal)
if(CMAKE_C_COMPILER_ID STREQUAL "GNU" AND CMAKE_C_COMPILER_VERSION VERSION_GREATER_EQUAL 12
   AND CMAKE_C_COMPILER_VERSION VERSION_LESS 13 AND CMAKE_BUILD_TYPE STREQUAL "Release"
   AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  add_test(NAME bench_instructions COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/bench/instructions.sh)
  set_tests_properties(bench_instructions PROPERTIES LABELS bench TIMEOUT 600 SKIP_RETURN_CODE 77
    ENVIRONMENT "LANE_STEPS=$<TARGET_FILE:lane_steps>")
endif()
