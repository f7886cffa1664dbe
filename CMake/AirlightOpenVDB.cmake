# OpenVDB, for builds of the library alone and for ParaView.

# Optional. Debian installs FindOpenVDB.cmake outside CMake's own folders, and it stops with an
# error rather than an answer when Boost's iostreams are missing.
find_path(AIRLIGHT_OPENVDB_MODULE_DIR FindOpenVDB.cmake
  PATHS "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB" "/usr/local/lib/cmake/OpenVDB"
  NO_DEFAULT_PATH)
find_path(AIRLIGHT_BOOST_IOSTREAMS_DIR boost/iostreams/filtering_stream.hpp)
mark_as_advanced(AIRLIGHT_OPENVDB_MODULE_DIR AIRLIGHT_BOOST_IOSTREAMS_DIR)
set(OpenVDB_FOUND OFF)
if (AIRLIGHT_OLD_STANDARD_LIBRARY)
  message(STATUS "OpenVDB: left out, as the system's strings are not those of this VTK")
elseif (AIRLIGHT_OPENVDB_MODULE_DIR AND AIRLIGHT_BOOST_IOSTREAMS_DIR)
  list(PREPEND CMAKE_MODULE_PATH "${AIRLIGHT_OPENVDB_MODULE_DIR}")
  set(CMAKE_MESSAGE_LOG_LEVEL WARNING) # it does not heed QUIET
  find_package(OpenVDB QUIET)
  unset(CMAKE_MESSAGE_LOG_LEVEL)
  list(POP_FRONT CMAKE_MODULE_PATH)
endif ()
if (OpenVDB_FOUND)
  message(STATUS "OpenVDB: ${OpenVDB_VERSION}")
elseif (NOT AIRLIGHT_OLD_STANDARD_LIBRARY)
  message(STATUS "OpenVDB: not found (optional)")
endif ()

# For source files that include OpenVDB. It finds out names of types once, in static data of
# templates that are in its library and in ours: with hidden symbols there are two copies, one of
# which stays empty.
function (airlight_includes_openvdb)
  set_source_files_properties(${ARGN} PROPERTIES
    COMPILE_OPTIONS "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-fvisibility=default;-fno-visibility-inlines-hidden>"
    # Clang refuses one of another visibility.
    SKIP_PRECOMPILE_HEADERS ON)
endfunction ()
