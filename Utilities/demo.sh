#!/usr/bin/env bash
# From a bare Debian 12 to contours on a scanned point cloud: installs what is needed, builds the plugin, contours
# Data/kitten.xyz and writes contours.vtp (the curves) and contours.png (a picture).
#
# usage: Utilities/demo.sh [--gui] [--output FOLDER]
#
#   --output FOLDER   where to write; default: demo-output in the current folder
#   --gui             writes nothing: opens ParaView's window with the points and their contours
set -euo pipefail

usage() { sed -n '/^# usage/,/^set/{/^set/d;s/^# \{0,1\}//;p}' "${BASH_SOURCE[0]}"; }

gui=
output=demo-output
while [ $# -gt 0 ]; do
  case $1 in
    --gui) gui=yes ;;
    --output) [ $# -ge 2 ] || { echo "demo: --output needs a folder" >&2; exit 2; }; output=$2; shift ;;
    --help | -h) usage; exit 0 ;;
    *) { echo "demo: unknown argument $1"; usage; } >&2; exit 2 ;;
  esac
  shift
done
if [ -n "$gui" ] && [ -z "${DISPLAY:-}" ]; then
  echo "demo: --gui opens a window, but there is no display (DISPLAY is not set). Run it in a desktop session," >&2
  echo "or without --gui to write the curves and a picture to files." >&2
  exit 1
fi

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$project/build

"$project/Utilities/install-dependencies.sh" --no-tests

# A build folder that is there already keeps its options.
options=()
[ -f "$build/CMakeCache.txt" ] || options+=(-DSURFACE_SCALARS_BUILD_TESTING=OFF)
(cd "$project" && cmake --preset release "${options[@]}")
cmake --build "$build" --target SurfaceScalars --parallel "$(nproc)"

plugin=$(find "$build"/lib* -name SurfaceScalars.so -path "*/plugins/*" -print -quit) # not those that tests installed
[ -n "$plugin" ] || { echo "demo: the build made no SurfaceScalars.so in $build" >&2; exit 1; }
export SURFACE_SCALARS_PLUGIN=$plugin SURFACE_SCALARS_DATA=$project/Data

if [ -n "$gui" ]; then
  unset SURFACE_SCALARS_OUTPUT
  exec paraview --script="$project/Utilities/demo.py"
fi

mkdir -p "$output"
rm -f "$output/contours.vtp" "$output/contours.png"
echo "Contouring Data/kitten.xyz and painting it: half a minute"
SURFACE_SCALARS_OUTPUT=$(cd "$output" && pwd) PYTHONDONTWRITEBYTECODE=1 \
  "$project/Utilities/with-display.sh" pvpython "$project/Utilities/demo.py"
for file in "$output/contours.vtp" "$output/contours.png"; do
  [ -s "$file" ] || { echo "demo: $file was not written" >&2; exit 1; }
done

cat <<TEXT

Written:
  $output/contours.vtp: the curves as polylines with the arrays IsoValue, ComponentId, Closed and Length
  $output/contours.png: a picture of them

Next:
- Look at the curves:
    paraview $output/contours.vtp
- Open the scan and its contours in ParaView's window, and change values and parameters there:
    ${BASH_SOURCE[0]} --gui
- Contour your own points: in ParaView, Tools > Manage Plugins > Load New, choose
    $plugin
  then Filters > Surface Scalars > Point Set Contour. README.md says more.
TEXT
