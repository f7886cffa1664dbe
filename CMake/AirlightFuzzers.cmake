# Instruments the whole build for libFuzzer: coverage, AddressSanitizer and
# UndefinedBehaviorSanitizer. Utilities/fuzz.sh builds so, in a folder of its own.

if (NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR
    "AIRLIGHT_BUILD_FUZZERS needs Clang, not ${CMAKE_CXX_COMPILER_ID}: configure with "
    "-DCMAKE_CXX_COMPILER=clang++, or run Utilities/fuzz.sh, which does.")
endif ()

set(AIRLIGHT_SANITIZERS address,undefined,float-cast-overflow)
add_compile_options(
  "-fsanitize=fuzzer-no-link,${AIRLIGHT_SANITIZERS}"
  -fno-sanitize-recover=all
  -fno-omit-frame-pointer
  "-fsanitize-ignorelist=${CMAKE_CURRENT_SOURCE_DIR}/Testing/Fuzz/ignored.txt")
# The run-time library is in the programs.
add_link_options("$<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-fsanitize=${AIRLIGHT_SANITIZERS}>")
