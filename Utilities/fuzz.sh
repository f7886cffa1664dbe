#!/usr/bin/env bash
# Builds the fuzzers with Clang, in build-asan/, and runs them. They feed arbitrary input to the
# library and stop at a crash, a leak, a hang or a NaN.
#
# Usage: Utilities/fuzz.sh TARGET [RUNS | SECONDSs] [LIBFUZZER OPTION...]
#        Utilities/fuzz.sh all RUNS | SECONDSs        all targets, one after the other
#        Utilities/fuzz.sh --build                    only builds
#        Utilities/fuzz.sh --replay [TARGET...]       runs the corpus and a few thousand further inputs,
#                                                     as the tests do; does not build
#
# Targets: Photometry Scene PhaseTable OpenVDB Medium Filters Pass Frames. For example
# `Utilities/fuzz.sh Photometry 5000000` or `Utilities/fuzz.sh OpenVDB 60s`. New inputs are kept in
# build-asan/fuzz/<target>/, failing inputs beside that folder. Frames needs a display, or starts one.
#
# Exits with 125 without Clang; the tests are then skipped.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
build=$root/build-asan
corpus=$root/Testing/Fuzz/Corpus
targets=(Photometry Scene PhaseTable OpenVDB Medium Filters Pass Frames)

skip()
{
  echo "skipped: $*" >&2
  exit 125
}

build_fuzzers()
{
  command -v clang++ > /dev/null || skip "no clang++ to build fuzzers with."
  echo 'int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long); int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
    clang -x c -fsanitize=fuzzer,address -o /dev/null - 2> /dev/null ||
    skip "Clang has no libFuzzer: install its run-time libraries (Debian: libclang-rt-dev)."
  # Clang with strict C++, so that Apple's compiler and others accept the library, too. VTK's macros
  # leave semicolons behind.
  configure_sanitized address -DAIRLIGHT_BUILD_FUZZERS=ON -DAIRLIGHT_UNITY_BUILD=ON \
    "-DCMAKE_CXX_FLAGS=-pedantic-errors -Wno-extra-semi"
  compile fuzzers
}

# run TARGET [LIBFUZZER OPTION...]: runs a fuzzer and keeps a failing input.
run()
{
  local target=$1 found=$build/fuzz/$1
  local program=$build/bin/Fuzz$target
  shift
  [[ -x $program ]] || skip "there is no $program; Utilities/fuzz.sh --build makes it."
  mkdir -p "$found"
  # Mesa leaks and unloads itself, so LeakSanitizer cannot suppress it by name.
  local leaks=1
  [[ $target != Frames ]] || leaks=0
  local command=(env "ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=$leaks}" "LSAN_OPTIONS=$(leak_options)"
    "$program" -timeout=120 -rss_limit_mb=6000 -print_final_stats=1
    "-artifact_prefix=$found-" "$@" "$found" "$corpus/$target")
  if [[ $target == Frames && -z ${DISPLAY-} ]]; then
    command=(on_virtual_display "${command[@]}")
  fi
  "${command[@]}" || die "Fuzz$target failed; its input is $found-*."
}

# limit NUMBER[s]: libFuzzer's option.
limit()
{
  case $1 in
    *s) echo "-max_total_time=${1%s}" ;;
    *) echo "-runs=$1" ;;
  esac
}

# The number of further runs of --replay: a few seconds each.
declare -A replays=([Photometry]=20000 [Scene]=1000 [PhaseTable]=1000 [OpenVDB]=1000 [Medium]=1000
  [Filters]=2000 [Pass]=4000 [Frames]=0)

replay()
{
  local target
  for target in "$@"; do
    echo "== $target"
    rm -rf "$build/fuzz/$target"
    run "$target" -seed=1 "-runs=${replays[$target]}"
  done
}

case ${1-} in
  "" | -h | --help) sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" ;;
  --build) build_fuzzers ;;
  --replay)
    shift
    (($#)) || set -- "${targets[@]}"
    replay "$@"
    ;;
  *)
    target=$1
    amount=${2:-60s}
    shift $(($# < 2 ? $# : 2))
    build_fuzzers
    if [[ $target == all ]]; then
      for target in "${targets[@]}"; do
        run "$target" "$(limit "$amount")" "$@"
      done
    else
      run "$target" "$(limit "$amount")" "$@"
    fi
    ;;
esac
