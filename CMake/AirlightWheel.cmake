# A wheel: the library and its Python modules in one folder, airlight/, beside the folder vtkmodules of
# the package vtk. pyproject.toml is the recipe; scikit-build-core sets SKBUILD.

# Some C++ tests, beside the wheel: Utilities/wheel.sh runs them. An sdist has none.
option(AIRLIGHT_WHEEL_TESTING "Build C++ tests with the wheel's library" OFF)
mark_as_advanced(AIRLIGHT_WHEEL_TESTING)
set(AIRLIGHT_BUILD_TESTING "${AIRLIGHT_WHEEL_TESTING}")
set(AIRLIGHT_BUILD_EXAMPLES OFF)
set(AIRLIGHT_WRAP_PYTHON ON)
set(CMAKE_INSTALL_LIBDIR "airlight")
set(CMAKE_INSTALL_BINDIR "airlight") # for the libraries of Windows
set(AIRLIGHT_PYTHON_DESTINATION ".")

# PyPI has vtk-sdk for macOS only: for Linux, its parts are put together.
if (CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT VTK_DIR)
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Wrapping/Wheel/vtk_sdk.py"
            "${CMAKE_BINARY_DIR}/vtk_sdk"
    OUTPUT_VARIABLE vtk_dir
    OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
  set(VTK_DIR "${vtk_dir}" CACHE PATH "The CMake package of VTK")
endif ()
