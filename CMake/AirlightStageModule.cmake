# VTK builds a module in the folder of its module file, by that folder's path below CMAKE_SOURCE_DIR.
# Airlight's own namespace takes a module file of its own, and ParaView's build a folder outside of
# its source tree. So each module gets a small folder below ${CMAKE_BINARY_DIR}/modules that hands over
# to the sources. Set CMAKE_SOURCE_DIR to that while VTK builds the modules.

set(AIRLIGHT_MODULES_DIR "${CMAKE_BINARY_DIR}/modules")

# airlight_stage_module(<name> <module file> <file to include> [<folder of tests>])
# Makes ${AIRLIGHT_MODULES_DIR}/<name>/vtk.module of the module file, VTK::Airlight renamed to
# Airlight::Airlight.
function (airlight_stage_module name module_file entry)
  set(folder "${AIRLIGHT_MODULES_DIR}/${name}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${module_file}")
  file(READ "${module_file}" text)
  string(REPLACE "VTK::Airlight" "Airlight::Airlight" text "${text}")
  file(CONFIGURE OUTPUT "${folder}/vtk.module" CONTENT "${text}" @ONLY)
  file(CONFIGURE OUTPUT "${folder}/CMakeLists.txt" CONTENT "include(\"${entry}\")\n" @ONLY)
  if (ARGC GREATER 3)
    file(CONFIGURE OUTPUT "${folder}/Testing/CMakeLists.txt" @ONLY
      CONTENT "add_subdirectory(\"${ARGV3}\" \"${CMAKE_BINARY_DIR}/Testing\")\n")
  endif ()
endfunction ()
