#!/usr/bin/env bash
# Runs a command with a virtual display of its own, and ends the display with it.
#
# usage: Utilities/with-display.sh COMMAND [ARGUMENT...]
# SURFACE_SCALARS_SCREEN in the environment: size and depth, such as 1400x900x24
#
# The X server chooses a free display number itself: unlike with xvfb-run -a, two commands that start at the same moment
# never get the same one.
set -euo pipefail
[ $# -gt 0 ] || { echo "with-display: needs a command" >&2; exit 2; }
command -v Xvfb >/dev/null || { echo "with-display: needs Xvfb: install the package xvfb" >&2; exit 1; }

scratch=$(mktemp -d)
server=
trap '[ -z "$server" ] || kill "$server" 2>/dev/null || true; rm -rf "$scratch"' EXIT

Xvfb -displayfd 3 -screen 0 "${SURFACE_SCALARS_SCREEN:-1600x1200x24}" -nolisten tcp -noreset 3>"$scratch/number" 2>"$scratch/messages" &
server=$!
for ((tenths = 0; tenths < 300; ++tenths)); do
  [ ! -s "$scratch/number" ] || break
  kill -0 "$server" 2>/dev/null || break
  sleep 0.1
done
if [ ! -s "$scratch/number" ]; then
  { echo "with-display: the X server did not start:"; cat "$scratch/messages"; } >&2
  exit 1
fi
DISPLAY=:$(cat "$scratch/number") "$@"
