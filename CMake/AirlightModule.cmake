# The VTK module. VTK reads this through the root CMakeLists.txt where Airlight is its remote module, the
# project through a folder that AirlightStageModule.cmake makes.
include("${CMAKE_CURRENT_LIST_DIR}/AirlightSources.cmake")

# Libraries of headers, for our own sources only.
find_path(AIRLIGHT_GLM_INCLUDE_DIR glm/glm.hpp)
find_path(AIRLIGHT_EIGEN_INCLUDE_DIR Eigen/Dense PATH_SUFFIXES eigen3)
foreach (library IN ITEMS GLM EIGEN)
  if (NOT AIRLIGHT_${library}_INCLUDE_DIR)
    message(FATAL_ERROR
      "${library} was not found: install it (Debian: libglm-dev, libeigen3-dev) or set "
      "AIRLIGHT_${library}_INCLUDE_DIR to its include folder.")
  endif ()
  mark_as_advanced(AIRLIGHT_${library}_INCLUDE_DIR)
endforeach ()

foreach (file IN LISTS glsl)
  vtk_encode_string(
    INPUT         "${file}"
    HEADER_OUTPUT header
    SOURCE_OUTPUT source)
  list(APPEND private_headers "${header}")
  list(APPEND private_sources "${source}")
  list(APPEND glsl_sources "${source}")
endforeach ()

# The list of phase functions for vtkPhaseFunction::NewByName(), from the CLASSES of the rooms.
set(phase_function_includes "")
set(phase_function_names "")
foreach (class IN LISTS classes)
  get_filename_component(name "${class}" NAME)
  if (name MATCHES "^vtk.+PhaseFunction$")
    string(APPEND phase_function_includes "#include \"${name}.h\"\n")
    string(APPEND phase_function_names " X(${name})")
  endif ()
endforeach ()
set(header "${CMAKE_CURRENT_BINARY_DIR}/AirlightPhaseFunctionClasses.h")
file(CONFIGURE OUTPUT "${header}" @ONLY
  CONTENT "${phase_function_includes}#define AIRLIGHT_PHASE_CLASSES(X)@phase_function_names@\n")
list(APPEND private_headers "${header}")

vtk_module_add_module("${_vtk_build_module}"
  CLASSES         ${classes}
  PRIVATE_CLASSES ${private_classes}
  SOURCES         ${private_sources}
  PRIVATE_HEADERS ${private_headers})

if (AIRLIGHT_UNITY_BUILD)
  include("${CMAKE_CURRENT_LIST_DIR}/AirlightUnityBuild.cmake")
endif ()

foreach (folder IN ITEMS Module Filters Rendering)
  vtk_module_include("${_vtk_build_module}"
    PUBLIC "$<BUILD_INTERFACE:${airlight_root}/${folder}>")
endforeach ()
vtk_module_include("${_vtk_build_module}"
  PRIVATE "${airlight_root}/Module/glsl")
vtk_module_include("${_vtk_build_module}" SYSTEM
  PRIVATE "${AIRLIGHT_GLM_INCLUDE_DIR}" "${AIRLIGHT_EIGEN_INCLUDE_DIR}")

vtk_module_link("${_vtk_build_module}"
  PRIVATE ${CMAKE_DL_LIBS}) # vtkAirlightHeadlessWindow opens libEGL
if (TARGET VTK::glew) # until VTK 9.3
  vtk_module_link("${_vtk_build_module}"
    PRIVATE VTK::glew)
endif ()

vtk_module_compile_features("${_vtk_build_module}"
  PUBLIC cxx_std_17)
if (AIRLIGHT_WARNINGS) # not inside VTK, which has its own
  vtk_module_compile_options("${_vtk_build_module}"
    PRIVATE ${AIRLIGHT_WARNINGS})
endif ()
if (AIRLIGHT_COVERAGE)
  # Little optimization, so that lines stay apart; counters that threads may share.
  vtk_module_compile_options("${_vtk_build_module}"
    PRIVATE --coverage -fprofile-update=atomic -O1)
  vtk_module_link_options("${_vtk_build_module}"
    PRIVATE --coverage)
endif ()
if (TARGET OpenVDB::openvdb)
  airlight_includes_openvdb("${airlight_root}/Filters/OpenVDB/AirlightOpenVDBFile.cxx")
  vtk_module_link("${_vtk_build_module}"
    PRIVATE OpenVDB::openvdb)
endif ()
