# The CMake package: find_package(Airlight) gives the target Airlight::Airlight, from the install
# tree and from the build tree.

include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_BINARY_DIR}/${AIRLIGHT_CMAKE_DESTINATION}")
configure_package_config_file(CMake/AirlightConfig.cmake.in "${package_dir}/AirlightConfig.cmake"
  INSTALL_DESTINATION "${AIRLIGHT_CMAKE_DESTINATION}")
write_basic_package_version_file("${package_dir}/AirlightConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)

install(
  FILES       "${package_dir}/AirlightConfig.cmake"
              "${package_dir}/AirlightConfigVersion.cmake"
  DESTINATION "${AIRLIGHT_CMAKE_DESTINATION}"
  COMPONENT   development)

# The four components and the packages that they become; each package has the licence.
set(AIRLIGHT_COMPONENTS runtime development)
set(AIRLIGHT_PACKAGE_runtime "libvtkairlight${Airlight_VERSION_MAJOR}.${Airlight_VERSION_MINOR}")
set(AIRLIGHT_PACKAGE_development "libvtkairlight-dev")
set(AIRLIGHT_PACKAGE_python "python3-airlight")
set(AIRLIGHT_PACKAGE_programs "airlight")
if (AIRLIGHT_WRAP_PYTHON)
  list(APPEND AIRLIGHT_COMPONENTS python)
endif ()
if (TARGET airlight)
  list(APPEND AIRLIGHT_COMPONENTS programs)
endif ()
foreach (component IN LISTS AIRLIGHT_COMPONENTS)
  install(
    FILES       LICENSE
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${AIRLIGHT_PACKAGE_${component}}"
    RENAME      copyright
    COMPONENT   "${component}")
endforeach ()
