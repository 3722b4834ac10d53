#!/usr/bin/env bash
# Installs, on Debian 12, what building and testing need. Does nothing where it is all there.
#
# usage: Utilities/install-dependencies.sh [--no-tests]      --no-tests: only what building and using needs
set -euo pipefail

packages=(
  g++ cmake ninja-build
  paraview paraview-dev python3-paraview
  libeigen3-dev libnanoflann-dev libspectra-dev
  # optional: factors large matrices twice as fast; its sums, otherwise by the reference BLAS, twice as fast again
  libsuitesparse-dev libopenblas0-serial
  # what paraview-dev's CMake files ask for without depending on it
  libopenmpi-dev libdouble-conversion-dev zlib1g-dev qttools5-dev qtxmlpatterns5-dev-tools
  # a display for pvpython where there is none
  xvfb xauth
  # the icons in the window of ParaView
  libqt5svg5)
if [ "${1:-}" != --no-tests ]; then
  packages+=(libgtest-dev libgmock-dev libbenchmark-dev imagemagick clang-format clang-tidy ccache git python3-scipy)
fi

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "All ${#packages[@]} packages are installed."
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Installing ${missing[*]} needs root: run this as root, or install sudo." >&2; exit 1; }
  as_root=(sudo)
fi
echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
