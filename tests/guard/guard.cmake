# SPDX-License-Identifier: MIT
# Guards: cheap checks of what no compiler sees. Each is one script, named after its test.
# schuler_guard(NAME arguments...)
function(schuler_guard name)
  add_test(NAME guard_${name} COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/guard/${name} ${ARGN})
  # 77: cannot be done here (a tool is missing); ctest says "Skipped".
  set_tests_properties(guard_${name} PROPERTIES LABELS guard TIMEOUT 900 SKIP_RETURN_CODE 77
    ENVIRONMENT "CC=${CMAKE_C_COMPILER};CXX=${CMAKE_CXX_COMPILER}")
endfunction()

set(sanitized FALSE)
if(CMAKE_C_FLAGS MATCHES "-fsanitize|--coverage")
  set(sanitized TRUE) # their run-time library adds symbols, and wants to be linked first
endif()

schuler_guard(floors ${PROJECT_SOURCE_DIR})
schuler_guard(file_size ${PROJECT_SOURCE_DIR})
schuler_guard(format ${PROJECT_SOURCE_DIR})

# Contraction must be off for every object, also where the processor has the instruction.
add_executable(test_contraction guard/test_contraction.c)
target_link_libraries(test_contraction PRIVATE schuler_flags PkgConfig::CMOCKA)
target_include_directories(test_contraction PRIVATE ${PROJECT_SOURCE_DIR}/tests)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  target_compile_options(test_contraction PRIVATE -mfma)
endif()
add_test(NAME guard_contraction COMMAND test_contraction)
set_tests_properties(guard_contraction PROPERTIES LABELS guard SKIP_RETURN_CODE 77)
schuler_guard(no_fma $<TARGET_FILE:schuler_internal>)

if(BUILD_SHARED_LIBS AND NOT sanitized)
  schuler_guard(symbols ${PROJECT_SOURCE_DIR} $<TARGET_FILE:schuler>)
endif()
if(NOT sanitized)
  schuler_guard(headers ${PROJECT_BINARY_DIR})
  schuler_guard(package ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR} ${CMAKE_COMMAND})
endif()
if(TARGET schuler_program)
  schuler_guard(version ${PROJECT_SOURCE_DIR} $<TARGET_FILE:schuler_program> ${PROJECT_BINARY_DIR})
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT sanitized) # its missions are too long otherwise
    schuler_guard(readme ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
  endif()
  if(NOT sanitized)
    schuler_guard(recipe ${PROJECT_SOURCE_DIR} ${CMAKE_COMMAND})
    schuler_guard(plugin ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR} ${CMAKE_COMMAND})
    schuler_guard(plugin_faults ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR} $<TARGET_FILE:schuler_program>)
  endif()
endif()
