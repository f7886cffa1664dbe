#!/usr/bin/env bash
# Installs what is missing, builds Airlight in build/ and renders Figure 1: a scene without a medium
# (a), in a medium without shadows (b), and with volumetric shadows (c). Also builds the Python package.
#
# Usage: Utilities/demo.sh [--output DIR] [--no-view]
#
# Writes figure1-a.png, figure1-b.png, figure1-c.png and figure1.png, the three side by side, into
# DIR (default: the current directory). If there is a screen, it then opens the scene in the viewer.
# AIRLIGHT_JOBS is the number of parallel jobs (default: one per processor).
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
step_count=4

# cached NAME: the value of a CMake variable of the build.
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

usage() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; }

output=$PWD
view=yes
while (($#)); do
  case $1 in
    --output)
      (($# >= 2)) || die "--output needs a directory."
      output=$2
      shift
      ;;
    --output=*) output=${1#*=} ;;
    --no-view) view=no ;;
    -h | --help)
      usage
      exit
      ;;
    *) die "unknown option '$1'; try --help." ;;
  esac
  shift
done
mkdir -p "$output" || die "cannot make the directory '$output'."

airlight=$build/bin/airlight
scene=$root/Examples/Data/figure1.json
if [[ -n ${DISPLAY:-} ]]; then
  run=("$airlight")
else
  run=(on_virtual_display "$airlight")
fi

step "Installing what is missing"
install_missing cmake c++ xvfb-run xauth

step "Configuring"
# A newcomer waits for a first picture, not for a developer's incremental builds.
unity=()
[[ -e $build/CMakeCache.txt ]] || unity=(-DAIRLIGHT_UNITY_BUILD=ON)
configure -DAIRLIGHT_BUILD_EXAMPLES=ON -DAIRLIGHT_WRAP_PYTHON=ON "${unity[@]}"

step "Building"
compile airlight AnimatedFog vtkAirlightPython
python=$(cached Python3_EXECUTABLE)
package=$build/$(cached AIRLIGHT_PYTHON_DESTINATION)
PYTHONPATH=$package${PYTHONPATH:+:$PYTHONPATH} "$python" -m airlight > /dev/null ||
  die "the Python package in $package does not load; see Python's message above."

step "Rendering Figure 1 into $output"
cd "$output"
shown=(--exposure 0.6) # the same, or they would not compare
"${run[@]}" render "$scene" "${shown[@]}" --no-medium -o figure1-a.png
"${run[@]}" render "$scene" "${shown[@]}" --technique None -o figure1-b.png
"${run[@]}" render "$scene" "${shown[@]}" -o figure1-c.png
"${run[@]}" montage figure1-a.png figure1-b.png figure1-c.png -o figure1.png
echo "Done: $PWD/figure1.png"
echo "In Python: PYTHONPATH=$package $python -m airlight"

if [[ -n ${DISPLAY:-} && $view == yes ]]; then
  echo "Opening the viewer; press q to leave it."
  "$airlight" view "$scene"
fi
