#!/usr/bin/env bash
# Installs what is missing, builds the benchmarks in build/ and times frames of the pass against plain
# VTK frames of the same scenes (Documentation/benchmarks.md). Run it on a quiet machine.
#
# Usage: Utilities/benchmark.sh [OPTION...] [SCENE...]     for example: Utilities/benchmark.sh small lights
#
#   --silhouettes   time silhouettes of a large mesh instead; options are Google Benchmark's
#
# Other options are those of AirlightBenchmarkFrames: see Utilities/benchmark.sh --help. By default,
# frames are rendered in software under a virtual X server. --egl renders without an X server, on the
# graphics card if there is one. AIRLIGHT_DISPLAY=1 renders on the screen that DISPLAY names.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
step_count=4

step "Installing what is missing"
install_missing cmake c++ xvfb-run xauth

step "Configuring"
configure -DAIRLIGHT_BUILD_TESTING=ON

step "Building"
compile benchmarks

step "Measuring"
if [[ ${1-} == --silhouettes ]]; then
  shift
  exec "$build/bin/AirlightBenchmarkSilhouette" "$@"
elif [[ -n ${AIRLIGHT_DISPLAY-} ]]; then
  exec "$build/bin/AirlightBenchmarkFrames" "$@"
fi
on_virtual_display "$build/bin/AirlightBenchmarkFrames" "$@"
