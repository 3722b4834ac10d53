# Installs the build tree BUILD below the folder WORK, moves what was installed, builds the projects CONSUMER and EXAMPLE against
# it and runs them. With SOURCE, BUILD is configured (OPTIONS, separated by blanks) and built first.

function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "Failed (${result}): ${command}")
  endif ()
endfunction ()

set(common
  -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=${CONFIG}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}")

if (SOURCE)
  separate_arguments(options UNIX_COMMAND "${OPTIONS}")
  run("${CMAKE_COMMAND}" ${common} -S "${SOURCE}" -B "${BUILD}"
    -DSURFACE_SCALARS_BUILD_TESTING=OFF -DSURFACE_SCALARS_WARNINGS_AS_ERRORS=ON ${options})
  run("${CMAKE_COMMAND}" --build "${BUILD}" --config "${CONFIG}" --parallel 2)
endif ()

# Moving shows that nothing points back to where it was installed first.
file(REMOVE_RECURSE "${WORK}/installed" "${WORK}/moved" "${WORK}/consumer")
run("${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIG}" --prefix "${WORK}/installed")
file(RENAME "${WORK}/installed" "${WORK}/moved")

foreach (component IN ITEMS Core Filters)
  set(consumer "${WORK}/consumer/${component}")
  run("${CMAKE_COMMAND}" ${common} -S "${CONSUMER}" -B "${consumer}"
    "-DCMAKE_PREFIX_PATH=${WORK}/moved" "-DCOMPONENT=${component}" "-DSANITIZE=${SANITIZE}")
  run("${CMAKE_COMMAND}" --build "${consumer}" --config "${CONFIG}")
  run("${consumer}/use${component}")
endforeach ()

# The example that README points to, on the scan that comes with us.
run("${CMAKE_COMMAND}" ${common} -S "${EXAMPLE}" -B "${WORK}/consumer/example"
  "-DCMAKE_PREFIX_PATH=${WORK}/moved")
run("${CMAKE_COMMAND}" --build "${WORK}/consumer/example" --config "${CONFIG}")
run("${WORK}/consumer/example/contour_scan" "${DATA}/kitten.xyz" "${WORK}/contours.vtp")
