#!/usr/bin/env bash
# Runs clang-tidy with .clang-tidy on the sources of Core and Filters, several of them at a time; any warning is an
# error. (Unused using declarations it reports only where a source is checked alone.)
#
# usage: Utilities/check-tidy.sh [BUILD_FOLDER]      default: build (configured, so that compile_commands.json is there)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=$(realpath "${1:-build}")
rm -rf "$build/tidy"
Utilities/tidy-groups.py "$build/compile_commands.json" "$build/tidy" "$PWD"/Core/*/*.cxx "$PWD"/Filters/*.cxx
cp .clang-tidy "$build/tidy/"
run-clang-tidy -p "$build/tidy" -quiet -j"$(nproc)" -header-filter='/(Core/[^/]+|Filters)/[^/]+$' \
  >"$build/clang-tidy.log" 2>&1 || {
  grep -E 'warning:|error:' "$build/clang-tidy.log" | sort -u
  echo "clang-tidy found something; the whole output is in $build/clang-tidy.log."
  exit 1
}
echo "clang-tidy is content with Core and Filters."
