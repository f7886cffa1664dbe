# What is looked for: VTK, with the modules that vtk.module names.

# Puts the lists of vtk.module in the variables <prefix>_DEPENDS, <prefix>_TEST_DEPENDS and so on.
function (airlight_read_module prefix)
  file(STRINGS "${CMAKE_CURRENT_SOURCE_DIR}/vtk.module" words REGEX "^[^#]")
  string(REGEX MATCHALL "[^ ;]+" words "${words}")
  set(lists DEPENDS PRIVATE_DEPENDS OPTIONAL_DEPENDS TEST_DEPENDS)
  cmake_parse_arguments(read "" "NAME;LIBRARY_NAME" "DESCRIPTION;TEST_LABELS;${lists}" ${words})
  foreach (name IN LISTS lists)
    string(REPLACE "VTK::" "" modules "${read_${name}}")
    set(${prefix}_${name} "${modules}" PARENT_SCOPE)
  endforeach ()
endfunction ()

# VTK's Python is the system's, which need not be the first in PATH.
if (NOT DEFINED Python3_EXECUTABLE AND NOT DEFINED VTK_DIR AND EXISTS "/usr/bin/python3")
  set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The Python that VTK was built for")
endif ()

airlight_read_module(airlight)
set(components ${airlight_DEPENDS} ${airlight_PRIVATE_DEPENDS})
if (AIRLIGHT_BUILD_TESTING)
  list(APPEND components ${airlight_TEST_DEPENDS})
endif ()
if (AIRLIGHT_WRAP_PYTHON)
  list(APPEND components Python WrappingPythonCore)
endif ()
list(REMOVE_DUPLICATES components)
find_package(VTK 9.1 REQUIRED COMPONENTS ${components})
message(STATUS "VTK ${VTK_VERSION}: ${VTK_DIR}")

if (AIRLIGHT_WRAP_PYTHON AND NOT VTK_WRAP_PYTHON)
  message(FATAL_ERROR
    "This VTK has no Python wrapping: set AIRLIGHT_WRAP_PYTHON to OFF or VTK_DIR to another VTK.")
endif ()
