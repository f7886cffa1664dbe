# Compiler, warnings and where things are put.

# Debian's folder of libraries, lib/<architecture>, is searched below /usr, /usr/local and whatever
# prefix CMake is told alike. CMake itself takes it for /usr alone, but the prefix may be chosen later
# (by packages, by cmake --install --prefix).
if (EXISTS "/etc/debian_version" AND CMAKE_LIBRARY_ARCHITECTURE
    AND NOT DEFINED CMAKE_INSTALL_LIBDIR)
  set(CMAKE_INSTALL_LIBDIR "lib/${CMAKE_LIBRARY_ARCHITECTURE}" CACHE PATH
    "Folder of libraries below the install prefix")
endif ()
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON) # for clang-tidy
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

# For our own sources; the generated Python wrappers are compiled without.
set(AIRLIGHT_WARNINGS "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra>")

find_program(AIRLIGHT_CCACHE ccache)
mark_as_advanced(AIRLIGHT_CCACHE)
if (AIRLIGHT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_C_COMPILER_LAUNCHER "${AIRLIGHT_CCACHE}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${AIRLIGHT_CCACHE}")
endif ()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")

# An installed tree finds its own library wherever it is moved, and VTK where it was found. A wheel finds
# VTK beside itself.
if (APPLE)
  set(own_folder "@loader_path")
else ()
  set(own_folder "$ORIGIN")
endif ()
if (SKBUILD)
  set(CMAKE_INSTALL_RPATH "${own_folder}" "${own_folder}/../vtkmodules")
else ()
  file(RELATIVE_PATH bin_to_lib "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
  set(CMAKE_INSTALL_RPATH "${own_folder}" "${own_folder}/${bin_to_lib}")
  set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
endif ()
