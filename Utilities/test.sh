#!/usr/bin/env bash
# Installs what is missing, builds Airlight in build/ and runs all its tests.
#
# Usage: Utilities/test.sh [CTEST OPTION...]      for example: Utilities/test.sh -R Python
#
# The tests run under one virtual X server, also where there is a screen, so that the result does
# not depend on it. AIRLIGHT_JOBS is the number of parallel jobs (default: one per processor).
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
step_count=6
# What is optional is tested, too.
dependencies=(--with-openvdb --with-doxygen --with-checks --with-clang)

step "Installing what is missing"
install_missing cmake ctest c++ xvfb-run xauth

step "Configuring"
configure -DAIRLIGHT_BUILD_TESTING=ON

step "Building"
compile all

step "Building for ParaView, where it can be had"
"$root/Utilities/paraview-test.sh" --build || (($? == 125)) || die "the ParaView plugin does not build."

step "Building fuzzers, where there is Clang"
"$root/Utilities/fuzz.sh" --build || (($? == 125)) || die "the fuzzers do not build."

step "Testing"
cd "$build"
on_virtual_display ctest --output-on-failure --no-tests=error --timeout 600 --parallel "$jobs" "$@" ||
  die "some tests failed; see above."
