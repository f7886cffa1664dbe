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
install(
  FILES       LICENSE
  DESTINATION "${CMAKE_INSTALL_DOCDIR}"
  COMPONENT   runtime)
