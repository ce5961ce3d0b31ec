# SPDX-License-Identifier: MIT
# libFuzzer entries, with address and undefined-behaviour sanitizers in every object. Clang only:
#   cmake -S . -B build/fuzz -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DSCHULER_FUZZ=ON
#   ninja -C build/fuzz fuzz_scenario && mkdir -p build/fuzz/corpus
#   build/fuzz/tests/fuzz_scenario -max_total_time=120 build/fuzz/corpus build/fuzz/tests/fuzz_seeds
option(SCHULER_FUZZ "Build the fuzz entries (clang)" OFF)
if(NOT SCHULER_FUZZ)
  return()
endif()
if(NOT CMAKE_C_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "SCHULER_FUZZ needs clang")
endif()

target_compile_options(schuler_flags INTERFACE
  -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -g)
target_link_options(schuler_flags INTERFACE -fsanitize=address,undefined)

# A short run over the seeds, so that the entries themselves cannot rot.
function(schuler_fuzz name)
  add_executable(${name} fuzz/${name}.c)
  target_link_libraries(${name} PRIVATE schuler_internal)
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  add_test(NAME ${name} COMMAND ${name} -runs=5000 -seed=1 -timeout=20 ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS fuzz TIMEOUT 600)
endfunction()
schuler_fuzz(fuzz_quantity)
schuler_fuzz(fuzz_increments)
file(GLOB seeds ${PROJECT_SOURCE_DIR}/scenarios/*.yaml ${PROJECT_SOURCE_DIR}/sensors/catalog/*.yaml)
file(COPY ${seeds} DESTINATION ${CMAKE_CURRENT_BINARY_DIR}/fuzz_seeds)
schuler_fuzz(fuzz_scenario ${CMAKE_CURRENT_BINARY_DIR}/fuzz_seeds)
