#!/usr/bin/env bash
# Installs what is missing, builds Airlight in build/ and runs all its tests.
#
# Usage: Utilities/test.sh [CTEST OPTION...]      for example: Utilities/test.sh -R Python
#
# The tests run under one virtual X server, even if there is a screen, so that the result does not
# depend on it. AIRLIGHT_JOBS is the number of parallel jobs (default: one per processor).
#
# A skipped test is an error, unless it cannot run here: tests in ParaView if it cannot be fetched, the
# static checks outside a Git checkout, and tests that need packages if there is no apt-get to install
# them. Without options, running fewer tests than Testing/minimum-tests.txt says is an error, too.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
step_count=7
# Optional parts are tested, too.
dependencies=(--with-openvdb --with-doxygen --with-checks --with-clang --with-wheel)

step "Installing what is missing"
install_missing cmake ctest c++ xvfb-run xauth python3
# Tests that cannot run here, and the number of tests if all can.
may_skip=()
minimum=(--minimum "$root/Testing/minimum-tests.txt")
installs=1
command -v apt-get > /dev/null || {
  installs=0
  may_skip+=(--may-skip 'OpenVDB|DebianPackages|StaticChecks|TestExamples|AirlightFuzz-|ParaView')
}
[[ -e $root/.git ]] || may_skip+=(--may-skip StaticChecks)
((installs && $# == 0)) || minimum=()

step "Configuring"
# A fresh build compiles the files of a folder together, in less time; a developer's stays as it is.
unity=()
[[ -e $build/CMakeCache.txt ]] || unity=(-DAIRLIGHT_UNITY_BUILD=ON)
configure -DAIRLIGHT_BUILD_TESTING=ON "${unity[@]}"

step "Building, and fetching what later steps need"
# What cannot be fetched is fetched again there, with a message.
{
  "$root/Utilities/paraview-test.sh" --fetch || true
  ((!installs)) || "$root/Utilities/wheel.sh" --fetch || true
} > "$build/fetch.log" 2>&1 &
compile all
wait

step "Building for ParaView, if it can be fetched"
"$root/Utilities/paraview-test.sh" --build || {
  [[ $? == 125 && -z ${AIRLIGHT_PARAVIEW_PREFIX-} && ! -d $build/paraview-test/prefix ]] ||
    die "the ParaView plugin does not build."
  may_skip+=(--may-skip ParaView)
}

step "Building fuzzers"
"$root/Utilities/fuzz.sh" --build || (($? == 125 && !installs)) || die "the fuzzers do not build."

step "Building the wheel for pip's VTK"
if ((installs)); then
  "$root/Utilities/wheel.sh" --build || die "the wheel does not build."
else
  may_skip+=(--may-skip AirlightWheel)
fi

step "Testing"
cd "$build"
results=$build/Testing/Temporary/results.xml
# For all processes, those with a home folder of their own, too: compiling takes most of their time.
export MESA_SHADER_CACHE_DIR=${MESA_SHADER_CACHE_DIR:-$build/Testing/Temporary/shaders}
mkdir -p "$MESA_SHADER_CACHE_DIR"
on_virtual_display ctest --output-on-failure --no-tests=error --timeout 600 --parallel "$jobs" \
  --output-junit "$results" "$@" || die "some tests failed; see above."
case " $* " in
  *" -N "* | *" --show-only"*) exit ;; # no test was to run
esac
"$root/Utilities/check-tests.py" "$results" --log "$build/Testing/Temporary/LastTest.log" \
  "${minimum[@]}" "${may_skip[@]}" || die "tests that should have run did not; see above."
