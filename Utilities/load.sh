#!/usr/bin/env bash
# Installs what is missing, builds the load tests in build/ and runs them in full: 10 000 frames in
# which everything moves, 64 lights, 2 000 actors, 10 million triangles, a tiled picture of 7680 x 4320
# pixels, and the same scenes in three processes (Documentation/trust.md). This takes about half an hour.
#
# Usage: Utilities/load.sh [TEST [OPTION...]]     for example: Utilities/load.sh frames --frames 1000
#
# Tests and options are those of AirlightLoad: see Utilities/load.sh --help.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
step_count=4

step "Installing what is missing"
install_missing cmake c++ xvfb-run xauth

step "Configuring"
configure -DAIRLIGHT_BUILD_TESTING=ON

step "Building"
compile AirlightLoad

# load TEST [OPTION...]
load()
{
  echo "-- $*"
  on_virtual_display "$build/bin/AirlightLoad" "$@" || failed+=("$1")
}

step "Running"
failed=()
if (($# > 0)); then
  load "$@"
else
  load frames
  load lights
  load actors
  load triangles
  load tiles
  load processes
fi
((${#failed[@]} == 0)) || die "failed: ${failed[*]}; see above."
