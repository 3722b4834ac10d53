#!/usr/bin/env bash
# From a bare Debian 12 to the result of all tests: installs, builds with warnings as errors, checks format and
# clang-tidy, tests.
# The tests themselves include the build without ParaView and a project that uses the installed package.
#
# Tests with the label `long` take much longer and are left out: ctest --preset release -L long
#
# usage: Utilities/test.sh [BUILD_FOLDER] [CTEST_ARGUMENT...]      default: build
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=${1:-build}
shift $(($# > 0 ? 1 : 0))
jobs=$(nproc)

Utilities/install-dependencies.sh

cache=()
if command -v ccache >/dev/null; then
  cache=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  # With paths relative to the build folder the tests, which build Core once more in theirs, find it there.
  mkdir -p "$build"
  CCACHE_BASEDIR=$(cd "$build" && pwd)
  export CCACHE_BASEDIR CCACHE_NOHASHDIR=true
fi
cmake --preset release -B "$build" \
  -DSURFACE_SCALARS_WARNINGS_AS_ERRORS=ON -DSURFACE_SCALARS_BUILD_TESTING=ON "${cache[@]}"
cmake --build "$build" --parallel "$jobs"

Utilities/check-format.sh
Utilities/check-tidy.sh "$build"

exec ctest --test-dir "$build" --output-on-failure --label-exclude long --parallel "$jobs" "$@"
