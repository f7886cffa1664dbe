#!/usr/bin/env bash
# Renders frames of random scenes that change, and checks properties that hold for every frame: see
# "Random frames" in Documentation/trust.md. Installs what is missing and builds Airlight in build/.
#
# Usage: Utilities/random-frames.sh [OPTION...]       default: --frames 10000 --first 0
#
#   --frames N     the number of frames
#   --first SEED   starts with the scene of this seed
#   --step K       every K-th seed: 50 seeds in a row share their shaders
#   --list FILE    the scenes whose seeds are in the file
#   --verbose      describes each scene
#
# Fails if a scene fails; names the failing scenes at the end.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
step_count=4

if [[ ${1-} == -h || ${1-} == --help ]]; then
  sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit
fi
(($#)) || set -- --frames 10000 --first 0

step "Installing what is missing"
install_missing cmake c++ xvfb-run xauth

step "Configuring"
configure -DAIRLIGHT_BUILD_TESTING=ON

step "Building"
compile AirlightRandomFrames

step "Drawing"
# Mesa's software renderer compiles shaders in a third of the time, and draws the same.
GALLIVM_PERF=nopt on_virtual_display "$build/bin/AirlightRandomFrames" \
  --open "$root/Testing/Frames/OpenSeeds.txt" "$@" || die "some scenes fail; see above."
