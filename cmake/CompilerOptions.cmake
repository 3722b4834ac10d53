# What our own targets are compiled with beyond the build type; generated code and other projects are left alone.

if (SURFACE_SCALARS_SANITIZE)
  add_compile_options("-fsanitize=${SURFACE_SCALARS_SANITIZE}" -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options("-fsanitize=${SURFACE_SCALARS_SANITIZE}")
endif ()

# surface_scalars_warnings(<target> [VTK])
# VTK: the target sees VTK's class macros, whose customary semicolon -Wpedantic objects to.
function (surface_scalars_warnings target)
  cmake_parse_arguments(PARSE_ARGV 1 warnings "VTK" "" "")
  if (MSVC)
    set(options /W4)
    set(as_errors /WX)
  else ()
    set(options -Wall -Wextra -Wshadow)
    if (NOT warnings_VTK)
      list(APPEND options -Wpedantic)
    endif ()
    set(as_errors -Werror)
  endif ()
  target_compile_options("${target}" PRIVATE
    ${options} "$<$<BOOL:${SURFACE_SCALARS_WARNINGS_AS_ERRORS}>:${as_errors}>")
endfunction ()
