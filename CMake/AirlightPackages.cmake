# Debian packages: `cpack` in the build folder writes one for each component. Names, sections and
# dependencies follow Debian's policy: the library's package is named after its SONAME, so that two
# versions whose binaries differ can be installed side by side.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME airlight)
set(CPACK_PACKAGE_VENDOR "Airlight developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # CPack would put it before each package's own
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_COMPONENTS_ALL ${AIRLIGHT_COMPONENTS})
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Where dpkg-shlibdeps finds our own library, whose package it cannot know yet.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
# As Debian's own tools do it
if (NOT "$ENV{DEBEMAIL}" STREQUAL "")
  set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else ()
  set(maintainer "Airlight developers <airlight@example.invalid>")
endif ()
set(AIRLIGHT_PACKAGE_MAINTAINER "${maintainer}" CACHE STRING
  "Who makes the Debian packages: name and address")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${AIRLIGHT_PACKAGE_MAINTAINER}")

set(version "${Airlight_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
set(library "${AIRLIGHT_PACKAGE_runtime} (= ${version})")
set(purpose "Airlight puts the scene of a VTK renderer into a participating medium: the air is lit by the
scene's lamps, surfaces dim and fade with distance, and actors cast shadows through it. The
scattered light comes from a closed form or from quadrature with a stated error, and the edges of
shadows from geometry, without sampling at random.")

# airlight_package(<component> <section> <first line> <last paragraph> [<dependency>...])
function (airlight_package component section summary text)
  string(TOUPPER "CPACK_DEBIAN_${component}" prefix)
  list(JOIN ARGN ", " depends)
  set(${prefix}_PACKAGE_NAME "${AIRLIGHT_PACKAGE_${component}}" PARENT_SCOPE)
  set(${prefix}_PACKAGE_SECTION "${section}" PARENT_SCOPE)
  set(${prefix}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(${prefix}_DESCRIPTION "${summary}\n${purpose}\n\n${text}" PARENT_SCOPE)
endfunction ()

airlight_package(runtime libs "light in fog, smoke and water for VTK - shared library"
  "This package contains the shared library.")

# What dpkg-shlibdeps is to know of it. CPack writes the scripts that call ldconfig.
set(control "${CMAKE_BINARY_DIR}/packages")
file(WRITE "${control}/shlibs"
  "libvtkAirlight ${Airlight_VERSION_MAJOR}.${Airlight_VERSION_MINOR} "
  "${AIRLIGHT_PACKAGE_runtime} (>= ${Airlight_VERSION})\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${control}/shlibs")

# libvtk9-dev is in Debian 12 and 13; its dependencies bring what VTK's CMake package looks for.
airlight_package(development libdevel "light in fog, smoke and water for VTK - development files"
  "This package contains the headers and the CMake package."
  "${library}" "libvtk9-dev (>= ${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION})")

if (AIRLIGHT_WRAP_PYTHON)
  # The package is in the folder of this Python alone and its module fits no other.
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  airlight_package(python python "light in fog, smoke and water for VTK - Python package"
    "This package contains the Python package `airlight`."
    "${library}" "python3-vtk9 (>= ${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION})"
    "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR})"
    "python3 (<< ${Python3_VERSION_MAJOR}.${next_minor})")
  # What Python compiles goes with the package.
  file(WRITE "${control}/prerm"
    "#!/bin/sh\nset -e\npy3clean -p ${AIRLIGHT_PACKAGE_python}\n")
  file(CHMOD "${control}/prerm" PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${control}/prerm")
endif ()

airlight_package(programs graphics "light in fog, smoke and water for VTK - program"
  "This package contains the program `airlight`, which renders scenes and models in fog,
compares pictures, and shows scenes live."
  "${library}")

include(CPack)
