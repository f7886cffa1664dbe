# Builds, wraps and tests the module through VTK's module system.

set(AIRLIGHT_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Airlight")
set(AIRLIGHT_HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/airlight")

if (AIRLIGHT_WRAP_PYTHON)
  # Debian's VTK installs into lib/python3/dist-packages, which Python searches below /usr only.
  # The folder with the full version is searched below /usr and /usr/local alike.
  if (NOT AIRLIGHT_PYTHON_DESTINATION)
    vtk_module_python_default_destination(python_destination)
  endif ()
  string(REPLACE "/python3/" "/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/"
    python_destination "${python_destination}")
  set(AIRLIGHT_PYTHON_DESTINATION "${python_destination}" CACHE STRING
    "Folder of the Python package below the install prefix and below the build folder")
  set(AIRLIGHT_PYTHONPATH "${CMAKE_BINARY_DIR}/${AIRLIGHT_PYTHON_DESTINATION}")
endif ()

set(enable_tests OFF)
if (AIRLIGHT_BUILD_TESTING)
  set(enable_tests ON)
  enable_testing()
  include("${VTK_DIR}/vtkModuleTesting.cmake")
  set(ExternalData_SOURCE_ROOT "${CMAKE_CURRENT_SOURCE_DIR}")
endif ()

include(CMake/AirlightStageModule.cmake)
airlight_stage_module(Airlight "${CMAKE_CURRENT_SOURCE_DIR}/vtk.module"
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/AirlightModule.cmake" "${CMAKE_CURRENT_SOURCE_DIR}/Testing")
vtk_module_scan(
  MODULE_FILES            "${AIRLIGHT_MODULES_DIR}/Airlight/vtk.module"
  REQUEST_MODULES         Airlight::Airlight
  PROVIDES_MODULES        modules
  HIDE_MODULES_FROM_CACHE ON
  ENABLE_TESTS            "${enable_tests}")

set(library_version VERSION "${Airlight_VERSION}"
  SOVERSION "${Airlight_VERSION_MAJOR}.${Airlight_VERSION_MINOR}")
if (SKBUILD) # a wheel has no links
  set(library_version)
endif ()

set(project_source_dir "${CMAKE_SOURCE_DIR}")
set(CMAKE_SOURCE_DIR "${AIRLIGHT_MODULES_DIR}")
vtk_module_build(
  MODULES                    ${modules}
  PACKAGE                    Airlight
  ${library_version}
  INSTALL_EXPORT             Airlight
  CMAKE_DESTINATION          "${AIRLIGHT_CMAKE_DESTINATION}"
  HEADERS_DESTINATION        "${AIRLIGHT_HEADERS_DESTINATION}"
  LIBRARY_DESTINATION        "${CMAKE_INSTALL_LIBDIR}"
  ENABLE_WRAPPING            "${AIRLIGHT_WRAP_PYTHON}"
  TEST_INPUT_DATA_DIRECTORY  "${CMAKE_CURRENT_SOURCE_DIR}/Testing/Data"
  TEST_OUTPUT_DATA_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/Testing/Data" # data are read in place
  TEST_OUTPUT_DIRECTORY      "${CMAKE_BINARY_DIR}/Testing/Temporary")
set(CMAKE_SOURCE_DIR "${project_source_dir}")

if (AIRLIGHT_WRAP_PYTHON)
  set(python_stubs)
  if (SKBUILD)
    set(python_stubs BUILD_PYI_FILES ON)
    add_custom_target(vtk_python_copy) # of VTK's own build, which VTK's rules name
  endif ()
  vtk_module_wrap_python(
    MODULES             ${modules}
    TARGET              Airlight::Python
    PYTHON_PACKAGE      airlight
    MODULE_DESTINATION  "${AIRLIGHT_PYTHON_DESTINATION}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    CMAKE_DESTINATION   "${AIRLIGHT_CMAKE_DESTINATION}"
    INSTALL_HEADERS     OFF
    SOABI               "${Python3_SOABI}"
    ${python_stubs})
  set(AIRLIGHT_PYTHON_FILES
    __main__.py
    density.py
    display.py
    headless.py
    paraview.py
    pyvista/__init__.py
    pyvista/arguments.py
    pyvista/buffers.py
    pyvista/component.py
    pyvista/dataset_accessor.py
    pyvista/lamp.py
    pyvista/messages.py
    pyvista/pass_chain.py
    pyvista/polydata_accessor.py
    pyvista/provider.py
    pyvista/requirements.py
    pyvista/scene.py
    pyvista/settings.py
    pyvista/smooth_edges.py
    pyvista/state.py
    pyvista/subplot.py
    windows.py)
  configure_file(Wrapping/Python/airlight/__init__.py.in
    "${AIRLIGHT_PYTHONPATH}/airlight/__init__.py" @ONLY)
  install(
    FILES       "${AIRLIGHT_PYTHONPATH}/airlight/__init__.py"
    DESTINATION "${AIRLIGHT_PYTHON_DESTINATION}/airlight"
    COMPONENT   python)
  foreach (file IN LISTS AIRLIGHT_PYTHON_FILES)
    get_filename_component(folder "airlight/${file}" DIRECTORY)
    configure_file("Wrapping/Python/airlight/${file}"
      "${AIRLIGHT_PYTHONPATH}/airlight/${file}" COPYONLY)
    install(
      FILES       "${AIRLIGHT_PYTHONPATH}/airlight/${file}"
      DESTINATION "${AIRLIGHT_PYTHON_DESTINATION}/${folder}"
      COMPONENT   python)
  endforeach ()
  message(STATUS "Python package airlight: PYTHONPATH=${AIRLIGHT_PYTHONPATH}")
endif ()
