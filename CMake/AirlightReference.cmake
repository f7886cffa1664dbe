# The class reference: the target `doc` makes it with Doxygen, in reference/html below the build
# folder, and a test does so, too, and fails with Doxygen's warnings.
#
# As a script it makes the reference without a build, as the documentation site needs it:
#
#   cmake -DAirlight_VERSION=1.2.3 -DAIRLIGHT_REFERENCE_DIR=DIR -P CMake/AirlightReference.cmake

find_program(AIRLIGHT_DOXYGEN doxygen)
if (CMAKE_SCRIPT_MODE_FILE)
  set(Airlight_SOURCE_DIR "${CMAKE_CURRENT_LIST_DIR}/..")
  cmake_path(NORMAL_PATH Airlight_SOURCE_DIR)
  string(REGEX REPLACE "/$" "" Airlight_SOURCE_DIR "${Airlight_SOURCE_DIR}")
  set(CMAKE_CURRENT_SOURCE_DIR "${Airlight_SOURCE_DIR}")
else ()
  mark_as_advanced(AIRLIGHT_DOXYGEN)
  set(AIRLIGHT_REFERENCE_DIR "${CMAKE_BINARY_DIR}/reference")
endif ()

include("${CMAKE_CURRENT_LIST_DIR}/AirlightSources.cmake")
set(documented_classes ${classes}
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters/vtkOpenVDBDensityReader") # whether it is built or not
list(REMOVE_DUPLICATES documented_classes)
list(TRANSFORM documented_classes APPEND ".h" OUTPUT_VARIABLE headers)
list(APPEND headers "${CMAKE_CURRENT_SOURCE_DIR}/Documentation/doxygen/mainpage.md")
list(TRANSFORM headers REPLACE "(.+)" "\"\\1\"")
list(JOIN headers " " AIRLIGHT_REFERENCE_INPUT)
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/Documentation/doxygen/Doxyfile.in"
  "${AIRLIGHT_REFERENCE_DIR}/Doxyfile" @ONLY)

set(make_reference "${CMAKE_COMMAND}"
  "-DDOXYGEN=${AIRLIGHT_DOXYGEN}"
  "-DFOLDER=${AIRLIGHT_REFERENCE_DIR}"
  "-DCLASSES=${documented_classes}"
  -P "${CMAKE_CURRENT_SOURCE_DIR}/CMake/AirlightMakeReference.cmake")
if (CMAKE_SCRIPT_MODE_FILE)
  execute_process(COMMAND ${make_reference} COMMAND_ERROR_IS_FATAL ANY)
  return ()
endif ()
add_custom_target(doc
  COMMAND ${make_reference}
  COMMENT "Making the class reference"
  VERBATIM)
if (AIRLIGHT_BUILD_TESTING)
  add_test(NAME "Airlight::Airlight-Reference" COMMAND ${make_reference})
  set_tests_properties("Airlight::Airlight-Reference" PROPERTIES
    SKIP_REGULAR_EXPRESSION "Doxygen was not found")
endif ()
