# Instruments the whole build. Utilities/sanitize.sh and Utilities/fuzz.sh build so, in folders of
# their own:
#   address   AddressSanitizer (with LeakSanitizer) and UndefinedBehaviorSanitizer
#   thread    ThreadSanitizer
# Fuzzers need `address`, and count which code is reached besides.

# Called in each folder after its tests: gives them what Utilities/sanitize.sh needs them to have.
function (airlight_sanitize_tests)
  get_property(tests DIRECTORY PROPERTY TESTS)
  if (tests AND TARGET AirlightKeepLoaded)
    set_property(TEST ${tests} APPEND PROPERTY ENVIRONMENT
      "LD_PRELOAD=${AIRLIGHT_SANITIZER_RUNTIME}:$<TARGET_FILE:AirlightKeepLoaded>")
  endif ()
endfunction ()

set(AIRLIGHT_SANITIZER "" CACHE STRING "Build with sanitizers: address, thread, or none")
set_property(CACHE AIRLIGHT_SANITIZER PROPERTY STRINGS "" address thread)
if (AIRLIGHT_BUILD_FUZZERS)
  if (NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR
      "AIRLIGHT_BUILD_FUZZERS needs Clang, not ${CMAKE_CXX_COMPILER_ID}: configure with "
      "-DCMAKE_CXX_COMPILER=clang++, or run Utilities/fuzz.sh, which does.")
  endif ()
  set(AIRLIGHT_SANITIZER address)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif ()

if (AIRLIGHT_SANITIZER STREQUAL "address")
  set(sanitizers address,undefined,float-cast-overflow)
elseif (AIRLIGHT_SANITIZER STREQUAL "thread")
  set(sanitizers thread)
elseif (AIRLIGHT_SANITIZER)
  message(FATAL_ERROR "AIRLIGHT_SANITIZER is ${AIRLIGHT_SANITIZER}, not address, thread or empty.")
else ()
  return ()
endif ()
add_compile_options("-fsanitize=${sanitizers}" -fno-sanitize-recover=all -fno-omit-frame-pointer)
if (CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_compile_options(
    "-fsanitize-ignorelist=${CMAKE_CURRENT_SOURCE_DIR}/Testing/Fuzz/ignored.txt")
endif ()

# Programs that are not instrumented, Python for one, have the run-time library preloaded.
if (CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND AIRLIGHT_SANITIZER STREQUAL "address" AND
    NOT AIRLIGHT_BUILD_FUZZERS)
  set(runtime "libclang_rt.asan-${CMAKE_SYSTEM_PROCESSOR}.so")
elseif (CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # It is in the programs; libraries find it there.
  add_link_options("$<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-fsanitize=${sanitizers}>")
  return ()
elseif (AIRLIGHT_SANITIZER STREQUAL "address")
  set(runtime "libasan.so")
else ()
  set(runtime "libtsan.so")
endif ()
execute_process(
  COMMAND "${CMAKE_CXX_COMPILER}" "-print-file-name=${runtime}"
  OUTPUT_VARIABLE AIRLIGHT_SANITIZER_RUNTIME
  OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
file(REAL_PATH "${AIRLIGHT_SANITIZER_RUNTIME}" AIRLIGHT_SANITIZER_RUNTIME)
get_filename_component(folder "${AIRLIGHT_SANITIZER_RUNTIME}" DIRECTORY)
add_link_options("-fsanitize=${sanitizers}" "-Wl,-rpath,${folder}")
if (CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_link_options(-shared-libasan)
endif ()
if (AIRLIGHT_SANITIZER STREQUAL "address")
  add_library(AirlightKeepLoaded SHARED Testing/Sanitizers/KeepLoaded.c)
  target_compile_options(AirlightKeepLoaded PRIVATE -fno-sanitize=all)
endif ()
