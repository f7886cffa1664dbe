#!/usr/bin/env bash
# Tests the tests: applies one fault at a time to the code, and reports which test detects it.
#
# Usage: Utilities/mutants.sh [--all-tests] [NAME...]   all mutants, or those whose names contain a NAME
#        Utilities/mutants.sh --list [NAME...]          describes them
#
# A mutant is a patch in Testing/Mutants. Its text names the fault and the tests that should detect it.
# For each mutant, the script applies the patch, builds, runs those tests and reverts the patch. If they
# detect nothing, --all-tests then runs all tests. See "Mutants" in Documentation/trust.md.
#
# All of this happens in build/mutants, a clone of the last commit. The patches are those of the working
# tree. The tests have to pass there without a mutant first.
#
# AIRLIGHT_JOBS is the number of parallel jobs (default: one per processor).
#
# Fails if a mutant survives that Testing/Mutants/survivors.txt does not excuse, and if a mutant does
# not apply or does not build.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
mutants=$root/Testing/Mutants
origin=$root
# From here on, lib.sh works on the clone.
root=$origin/build/mutants
build=$root/build
log=$root/build/mutants.log
step_count=4
# Mesa's software renderer compiles shaders in a third of the time, and draws the same.
export GALLIVM_PERF=${GALLIVM_PERF-nopt}

# fault NAME: the first line of the patch.
fault()
{
  head -n 1 "$mutants/$1.patch"
}

# tests_of NAME: the names of the tests that should detect it, separated by |.
tests_of()
{
  sed -n '/^--- /q; s/^Tests: *//p' "$mutants/$1.patch"
}

# excuse NAME: why the mutant may survive, or nothing.
excuse()
{
  awk -v name="$1" '$1 == name { $1 = ""; print substr($0, 2) }' "$mutants/survivors.txt"
}

# choose [NAME...]: sets `names`; by default all.
choose()
{
  local file name wanted
  names=()
  for file in "$mutants"/*.patch; do
    name=$(basename "$file" .patch)
    for wanted in "${@:-}"; do
      if [[ $name == *"$wanted"* ]]; then
        names+=("$name")
        break
      fi
    done
  done
  ((${#names[@]})) || die "no mutant has such a name; --list names all."
}

# Makes the clone, or updates it to the last commit.
update_clone()
{
  local commit
  commit=$(git -C "$origin" rev-parse HEAD) || die "this is no Git checkout, of which to make a clone."
  [[ -d $root/.git ]] || git clone --quiet --no-checkout "$origin" "$root"
  git -C "$root" fetch --quiet "$origin" "$commit"
  git -C "$root" checkout --quiet --force --detach "$commit"
  # Do not fetch ParaView a second time.
  if [[ -d $origin/build/paraview-test/prefix/usr ]]; then
    export AIRLIGHT_PARAVIEW_PREFIX=${AIRLIGHT_PARAVIEW_PREFIX:-$origin/build/paraview-test/prefix/usr}
  fi
}

# target_of TEST: what has to be built for it. Python's tests of the programs need everything.
target_of()
{
  local folder file
  folder=$(cd "$root/Testing/Cxx" && find . -name "$1.cxx" -printf '%h')
  file=$root/Testing/Python/${1#AirlightPython-}.py
  if [[ -n $folder ]]; then
    echo "vtkAirlight${folder#./}CxxTests"
  elif [[ $1 == AirlightParaView-* ]]; then
    echo AirlightParaViewTests
  elif [[ -e $file ]] && ! grep -qE 'AIRLIGHT_|(program|example)test' "$file"; then
    echo vtkAirlightPython
  else
    echo all
  fi
}

# build_for TESTS: builds only what the tests run; `all` stands for all tests. The output goes to the
# log.
build_for()
{
  local targets name
  mapfile -t targets < <(for name in ${1//|/ }; do target_of "$name"; done | sort -u)
  cmake --build "$build" --parallel "$jobs" --target "${targets[@]}" > "$log" 2>&1 || return 1
  # All tests include those in ParaView: without this, they would run with the last mutant's plugin.
  if [[ $1 == all || $1 == *ParaView* ]]; then
    "$root/Utilities/paraview-test.sh" --build >> "$log" 2>&1 || (($? == 125)) || return 1
  fi
}

# run_tests CTEST OPTION...: stops at the first failure. Sets `killer` to its name, or to nothing if
# all pass, and `ran` to the number of tests that were not skipped.
run_tests()
{
  local failed=$build/Testing/Temporary/LastTestsFailed.log
  rm -f "$failed"
  (cd "$build" && on_virtual_display ctest --no-tests=error --stop-on-failure --timeout 600 \
    --parallel "$jobs" "$@") > "$log" 2>&1 || [[ -e $failed ]] || die "ctest fails; see $log."
  # The list of failed tests includes skipped ones.
  killer=$(sed -n 's/^ *[0-9]*\/[0-9]* *Test *#[0-9]*: *\([^ ]*\) .*\*\*\*\(Failed\|Timeout\|Exception\).*/\1/p' \
    "$log" | head -n 1)
  ran=$(grep -cE '^ *[0-9]+/[0-9]+ *Test .*(Passed|\*\*\*(Failed|Timeout|Exception))' "$log" || true)
}

# The option that selects tests by their names without prefixes.
by_name()
{
  echo "(^|[:-])(${1})\$"
}

# report NAME TEXT: a line of the table.
report()
{
  printf '%-34s %s\n' "$1" "$2"
}

# try NAME: one mutant, from patch to result.
try()
{
  local tests begin reason
  tests=$(tests_of "$1")
  begin=$SECONDS
  if ! git -C "$root" apply "$mutants/$1.patch"; then
    report "$1" "DOES NOT APPLY"
    broken=$((broken + 1))
    return
  fi
  if ! build_for "$tests"; then
    report "$1" "DOES NOT BUILD: $(grep -m 1 -E 'error' "$log" || true)"
    broken=$((broken + 1))
    revert
    return
  fi
  run_tests -R "$(by_name "$tests")"
  if [[ -z $killer ]] && ((all_tests)); then
    build_for all || die "$1 does not build for all tests; see $log."
    run_tests
  fi
  revert
  reason=$(excuse "$1")
  if [[ -n $killer ]]; then
    killed=$((killed + 1))
    report "$1" "killed by $killer in $((SECONDS - begin)) s"
    [[ -z $reason ]] || echo "  note: take it out of survivors.txt."
  elif ((ran == 0)); then
    skipped=$((skipped + 1))
    report "$1" "not tried: its tests are skipped here"
  elif [[ -n $reason ]]; then
    excused=$((excused + 1))
    report "$1" "survived; $reason"
  else
    survived=$((survived + 1))
    report "$1" "SURVIVED: $(fault "$1")"
  fi
}

# Reverts the patches.
revert()
{
  git -C "$root" checkout --quiet --force HEAD -- .
}

all_tests=0
list=0
while [[ ${1-} == -* ]]; do
  case $1 in
    -h | --help)
      sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit
      ;;
    --list) list=1 ;;
    --all-tests) all_tests=1 ;;
    *) die "unknown option '$1'; try --help." ;;
  esac
  shift
done
choose "$@"
if ((list)); then
  for name in "${names[@]}"; do
    printf '%s\n  %s\n  %s\n' "$name" "$(fault "$name")" "$(tests_of "$name")"
  done
  exit
fi

step "Cloning the last commit"
update_clone
trap revert EXIT

step "Configuring"
configure -DAIRLIGHT_BUILD_TESTING=ON -DCMAKE_LINK_DEPENDS_NO_SHARED=ON

step "Building and testing without mutants"
wanted=$(for name in "${names[@]}"; do tests_of "$name"; done | tr '|' '\n' | sort -u)
for test in $wanted; do
  (cd "$build" && ctest -N -R "$(by_name "$test")") | grep -q 'Total Tests: [1-9]' ||
    die "there is no test $test, which a mutant names."
done
build_for "${wanted//$'\n'/|}" || die "the build fails; see $log."
run_tests -R "$(by_name "${wanted//$'\n'/|}")"
[[ -z $killer ]] || die "$killer fails without a mutant; see $log."

step "Testing with ${#names[@]} mutants, one at a time"
killed=0
survived=0
excused=0
skipped=0
broken=0
for name in "${names[@]}"; do
  try "$name"
done
echo "$killed of ${#names[@]} killed, $survived survived, $excused survived as survivors.txt says," \
  "$skipped not tried, $broken broken"
((survived + broken == 0)) || die "a test is missing for each that survived; see above."
