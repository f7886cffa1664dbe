#!/usr/bin/env bash
# Draws random scenes and compares each with the CPU's picture of it: see "Random scenes" in
# Documentation/trust.md. Installs what is missing and builds Airlight in build/.
#
# Usage: Utilities/random-scenes.sh [OPTION...]       default: --scenes 5000 --first 0
#
#   --scenes N     so many
#   --first SEED   from this seed on
#   --each N       the first N of each 50 seeds, which have the same kinds of things
#   --faults       spoils pixels of each scene that passes; nine of ten have to be reported
#   --step K       every K-th seed: 50 seeds in a row have the same kinds of things
#   --list FILE    those whose seeds are in the file
#   --verbose      says what each scene is
#
# Fails where a scene does; those to look into are named at the end.
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
