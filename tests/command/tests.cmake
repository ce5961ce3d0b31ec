# SPDX-License-Identifier: MIT
# Command tests: each script runs the built program in a temporary folder of its own.
if(TARGET schuler_program)
  add_executable(json_value ${CMAKE_CURRENT_LIST_DIR}/json_value.c)
  target_link_libraries(json_value PRIVATE schuler_flags PkgConfig::JANSSON)
  foreach(name help bad_input verdict compare sizes json same_bytes other_libm output interrupt data export faults catalog allan explain characterize terminal truth until report report_browser)
    add_test(NAME command_${name} COMMAND sh ${CMAKE_CURRENT_LIST_DIR}/${name}.sh)
    # 77: cannot be done here; ctest says "Skipped".
    set_tests_properties(command_${name} PROPERTIES LABELS command TIMEOUT 600 SKIP_RETURN_CODE 77
      ENVIRONMENT "SCHULER=$<TARGET_FILE:schuler_program>;JSON_VALUE=$<TARGET_FILE:json_value>;SOURCE_DIR=${PROJECT_SOURCE_DIR};COMMAND_TESTS=${CMAKE_CURRENT_LIST_DIR}")
  endforeach()
endif()
