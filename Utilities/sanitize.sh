#!/usr/bin/env bash
# Builds Airlight and its tests with sanitizers and runs the tests.
#
# Usage: Utilities/sanitize.sh address [CTEST OPTION...]   AddressSanitizer, LeakSanitizer and
#                                                          UndefinedBehaviorSanitizer, in build-asan/
#        Utilities/sanitize.sh thread [CTEST OPTION...]    ThreadSanitizer, in build-tsan/
#
# Uses Clang if available. `address` runs all tests, also those in Python, except those that build
# other programs or packages, which have no sanitizers. `thread` runs the tests of multi-threaded code
# (vtkSMPTools), with VTK's backend STDThread and four threads. VTK, Mesa, Python and OpenVDB are not
# instrumented: defects inside them are found only through calls of the C library, and ThreadSanitizer
# sees only those of their locks that are pthreads locks.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
step_count=4
dependencies=(--with-openvdb --with-clang)

# Tests of other builds, of packages, of style, and of ParaView.
unfit='Consumer|TestPackage|TestDebianPackages|TestRemoteModule|TestImport|ParaView|Reference$|Fuzz|TestDocumentation|AirlightWheel'
# Tests of code that uses vtkSMPTools.
shared='TestSilhouette|TestClosedSurface[.]cxx|TestClosedSurfaceRays|TestLitIntervals|TestOccluders|TestAirlightProbe|TestAirlightReference|TestShadowPlanes|TestShadowMeshes|TestDensityImage|TestRayFilterErrors'

case ${1-} in
  address)
    build=$root/build-asan
    targets=(all)
    options=(-E "$unfit")
    export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=1:detect_stack_use_after_return=1}
    export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
    LSAN_OPTIONS=$(leak_options)
    export LSAN_OPTIONS
    ;;
  thread)
    build=$root/build-tsan
    targets=(vtkAirlight{Module,Filters,Rendering,Composition}CxxTests)
    options=(-R Cxx- -E TestFaults)
    export TSAN_OPTIONS=${TSAN_OPTIONS:-halt_on_error=1:detect_deadlocks=0:suppressions=$root/Utilities/tsan.txt}
    export VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=4
    ;;
  *)
    sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    exit
    ;;
esac
kind=$1
shift

step "Installing what is missing"
install_missing cmake ctest c++ xvfb-run xauth

step "Configuring"
less=()
[[ $kind == address ]] || less=(-DAIRLIGHT_WRAP_PYTHON=OFF -DAIRLIGHT_BUILD_EXAMPLES=OFF "-DAIRLIGHT_TEST_FILTER=$shared")
configure_sanitized "$kind" -DAIRLIGHT_BUILD_TESTING=ON "${less[@]}"

step "Building"
compile "${targets[@]}"

step "Testing"
cd "$build"
on_virtual_display ctest --output-on-failure --no-tests=error --timeout 1800 --parallel "$jobs" \
  "${options[@]}" "$@" || die "some tests failed; see above."
