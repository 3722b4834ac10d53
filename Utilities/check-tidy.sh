#!/usr/bin/env bash
# Runs clang-tidy with .clang-tidy on the sources of Core and Filters; any warning is an error.
#
# usage: Utilities/check-tidy.sh [BUILD_FOLDER]      default: build (configured, so that compile_commands.json is there)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=${1:-build}
run-clang-tidy -p "$build" -quiet -j"$(nproc)" \
  "^$PWD/(Core|Filters)/[^/]*\.cxx\$" >"$build/clang-tidy.log" 2>&1 || {
  grep -E 'warning:|error:' "$build/clang-tidy.log" | sort -u
  echo "clang-tidy found something; the whole output is in $build/clang-tidy.log."
  exit 1
}
echo "clang-tidy is content with Core and Filters."
