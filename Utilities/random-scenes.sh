#!/usr/bin/env bash
# Renders random scenes and compares each with the CPU's picture of it: see "Random scenes" in
# Documentation/trust.md. Installs what is missing and builds Airlight in build/.
#
# Usage: Utilities/random-scenes.sh [OPTION...]       default: --scenes 5000 --first 0
#
#   --scenes N     the number of scenes
#   --first SEED   starts with this seed
#   --each N       the first N of each 50 seeds, which share their kinds of contents
#   --faults       corrupts pixels of each scene that passes; nine of ten have to be reported
#   --step K       every K-th seed: 50 seeds in a row share their kinds of contents
#   --list FILE    the seeds in the file
#   --verbose      describes each scene
#
# Fails if a scene fails; names the scenes to investigate at the end.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
step_count=4

if [[ ${1-} == -h || ${1-} == --help ]]; then
  sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit
fi
(($#)) || set -- --scenes 5000 --first 0

step "Installing what is missing"
install_missing cmake c++ xvfb-run xauth

step "Configuring"
configure -DAIRLIGHT_BUILD_TESTING=ON

step "Building"
compile AirlightRandomScenes

step "Drawing"
# Mesa's software renderer compiles shaders in a third of the time, and draws the same.
GALLIVM_PERF=nopt on_virtual_display "$build/bin/AirlightRandomScenes" "$@" ||
  die "some scenes fail; see above."
