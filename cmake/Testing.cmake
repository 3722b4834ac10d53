# Helpers for the tests. Every test gets a time limit; its name starts with its folder's: Core.LocalFit.reproducesQuadratics.

include(GoogleTest)

set(SURFACE_SCALARS_TEST_OUTPUT "${PROJECT_BINARY_DIR}/Testing/Temporary")
file(MAKE_DIRECTORY "${SURFACE_SCALARS_TEST_OUTPUT}")

if (SURFACE_SCALARS_PARAVIEW)
  find_program(SURFACE_SCALARS_PVPYTHON pvpython HINTS "${ParaView_PREFIX_PATH}/bin" REQUIRED
    DOC "ParaView's Python, to test the plugin")
endif ()

# surface_scalars_add_test(<name> [VTK] [TIMEOUT <seconds>] SOURCES <file>... LIBRARIES <target>...)
# A GoogleTest program; each of its tests becomes one of CTest's. VTK: it includes VTK's or our filters' headers.
# The macros SURFACE_SCALARS_DATA and SURFACE_SCALARS_OUTPUT name the folder Data and one to write to.
function (surface_scalars_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 test "VTK" "TIMEOUT" "SOURCES;LIBRARIES")
  if (NOT test_TIMEOUT)
    set(test_TIMEOUT 300)
  endif ()
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  add_executable("${name}" ${test_SOURCES})
  target_link_libraries("${name}" PRIVATE ${test_LIBRARIES} GTest::gmock GTest::gtest_main)
  target_compile_definitions("${name}" PRIVATE
    "SURFACE_SCALARS_DATA=\"${PROJECT_SOURCE_DIR}/Data\""
    "SURFACE_SCALARS_OUTPUT=\"${SURFACE_SCALARS_TEST_OUTPUT}\"")
  if (test_VTK)
    surface_scalars_warnings("${name}" VTK)
  else ()
    surface_scalars_warnings("${name}")
  endif ()
  gtest_discover_tests("${name}"
    TEST_PREFIX       "${folder}."
    DISCOVERY_TIMEOUT 60
    PROPERTIES        TIMEOUT "${test_TIMEOUT}")
endfunction ()

# surface_scalars_add_pvpython_test(<name> <script> [TIMEOUT <seconds>] [ARGUMENTS <argument>...])
# Runs the script in pvpython, with a display; it fails by its exit code. The environment variables SURFACE_SCALARS_PLUGIN,
# SURFACE_SCALARS_DATA and SURFACE_SCALARS_OUTPUT name the plugin's file, the folder Data and one to write to. The script can
# import the modules that lie beside it.
function (surface_scalars_add_pvpython_test name script)
  cmake_parse_arguments(PARSE_ARGV 2 test "" "TIMEOUT" "ARGUMENTS")
  if (NOT test_TIMEOUT)
    set(test_TIMEOUT 300)
  endif ()
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  get_filename_component(script "${script}" ABSOLUTE)
  add_test(
    NAME    "${folder}.${name}"
    COMMAND "${PROJECT_SOURCE_DIR}/Utilities/with-display.sh"
      "${SURFACE_SCALARS_PVPYTHON}" "${script}" ${test_ARGUMENTS}) # pvpython cannot draw without a display
  set(environment
    "SURFACE_SCALARS_PLUGIN=$<TARGET_FILE:SurfaceScalars>"
    "SURFACE_SCALARS_DATA=${PROJECT_SOURCE_DIR}/Data"
    "SURFACE_SCALARS_OUTPUT=${SURFACE_SCALARS_TEST_OUTPUT}"
    "PYTHONDONTWRITEBYTECODE=1"
    "OMPI_MCA_ess_singleton_isolated=1") # one process needs no daemon of Open MPI, which may fail to start
  set_tests_properties("${folder}.${name}" PROPERTIES
    TIMEOUT     "${test_TIMEOUT}"
    ENVIRONMENT "${environment}")
endfunction ()
