# Instruments the whole build. Utilities/sanitize.sh and Utilities/fuzz.sh build so, in folders of
# their own:
#   address   AddressSanitizer (with LeakSanitizer) and UndefinedBehaviorSanitizer
#   thread    ThreadSanitizer
# Fuzzers need `address`, and count which code is reached besides.

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
  # The run-time library is in the programs; libraries find it there.
  add_link_options("$<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-fsanitize=${sanitizers}>")
else ()
  add_link_options("-fsanitize=${sanitizers}")
endif ()
