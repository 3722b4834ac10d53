# ParaView ships its VTK in a folder of its own, where find_package(VTK) does not look.
# Sets paraview_vtk_hints; another VTK is preferred by -DVTK_DIR=... or CMAKE_PREFIX_PATH.

set(paraview_vtk_hints)
foreach (prefix IN LISTS CMAKE_PREFIX_PATH CMAKE_SYSTEM_PREFIX_PATH)
  foreach (library_folder IN ITEMS lib lib64 "lib/${CMAKE_LIBRARY_ARCHITECTURE}")
    file(GLOB found LIST_DIRECTORIES ON "${prefix}/${library_folder}/cmake/paraview-*/vtk")
    list(APPEND paraview_vtk_hints ${found})
  endforeach ()
endforeach ()
list(REMOVE_DUPLICATES paraview_vtk_hints)
