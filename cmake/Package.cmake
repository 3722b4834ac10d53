# The installed package: find_package(SurfaceScalars COMPONENTS Core Filters) gives SurfaceScalars::Core and
# SurfaceScalars::Filters. The same files serve the build tree.

include(CMakePackageConfigHelpers)

set(config_folder "${CMAKE_BINARY_DIR}/${SURFACE_SCALARS_CMAKE_DESTINATION}")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/SurfaceScalarsConfig.cmake.in"
  "${config_folder}/SurfaceScalarsConfig.cmake"
  INSTALL_DESTINATION "${SURFACE_SCALARS_CMAKE_DESTINATION}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${config_folder}/SurfaceScalarsConfigVersion.cmake"
  VERSION       "${PROJECT_VERSION}"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${config_folder}/SurfaceScalarsConfig.cmake"
    "${config_folder}/SurfaceScalarsConfigVersion.cmake"
  DESTINATION "${SURFACE_SCALARS_CMAKE_DESTINATION}"
  COMPONENT   development)

export(
  EXPORT    SurfaceScalarsCore
  NAMESPACE SurfaceScalars::
  FILE      "${config_folder}/SurfaceScalarsCore-targets.cmake")
install(
  EXPORT      SurfaceScalarsCore
  NAMESPACE   SurfaceScalars::
  FILE        "SurfaceScalarsCore-targets.cmake"
  DESTINATION "${SURFACE_SCALARS_CMAKE_DESTINATION}"
  COMPONENT   development)

install(
  FILES       "${PROJECT_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/licenses/SurfaceScalars"
  COMPONENT   licenses)
