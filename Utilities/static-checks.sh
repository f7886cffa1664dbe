#!/usr/bin/env bash
# Checks who includes whom, version and changelog, and the code with clang-tidy, cppcheck, shellcheck
# and pyflakes.
#
# Usage: Utilities/static-checks.sh --quick             all but clang-tidy; of C++ only the library
#        Utilities/static-checks.sh --all               everything; clang-tidy takes a processor an hour
#        Utilities/static-checks.sh --changed [COMMIT]  files that differ from COMMIT (default: HEAD),
#                                                       and sources that include a changed header
#        Utilities/static-checks.sh FILE...             these files
#
# clang-tidy needs a build of each file by itself (AIRLIGHT_UNITY_BUILD=OFF): in build/, or in the
# folder AIRLIGHT_BUILD; and the ParaView plugin's, if Utilities/paraview-test.sh has made one.
# AIRLIGHT_JOBS is the number of parallel jobs (default: one per processor).
#
# Exits with 1 if there is a finding, and with 125 if there is none but a program is missing.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
build=${AIRLIGHT_BUILD:-$build}
paraview_build=$root/build/paraview-test/plugin
cd "$root"
[[ -n $(git ls-files 2> /dev/null) ]] || {
  echo "skipped: this is no Git checkout, whose files are those to check." >&2
  exit 125
}
findings=0
missing=0

# has PROGRAM: whether it is available; notes missing ones.
has()
{
  command -v "$1" > /dev/null && return
  echo "skipped: no $1; Utilities/install-dependencies.sh --with-analysis installs it." >&2
  missing=1
  return 1
}

# listed PATTERN... : the files to check whose names match.
listed()
{
  local file pattern
  for file in "${files[@]}"; do
    for pattern in "$@"; do
      # shellcheck disable=SC2053 # a pattern it is
      [[ $file != $pattern ]] || echo "$file"
    done
  done
}

check_shell()
{
  local scripts
  mapfile -t scripts < <(listed '*.sh' '.ci/run')
  ((${#scripts[@]})) && has shellcheck || return 0
  echo "shellcheck: ${#scripts[@]} files"
  shellcheck --external-sources "${scripts[@]}" || findings=1
}

# "noqa" at the end of a line suppresses a finding; ParaView's scripts import all names at once.
check_python()
{
  local scripts found file line rest
  mapfile -t scripts < <(listed '*.py')
  ((${#scripts[@]})) && has pyflakes3 || return 0
  echo "pyflakes: ${#scripts[@]} files"
  while IFS=: read -r file line rest; do
    found=$(sed -n "${line}p" "$file")
    [[ $found == *"# noqa"* || $rest == *"paraview.simple"* ]] && continue
    echo "$file:$line:$rest"
    findings=1
  done < <(pyflakes3 "${scripts[@]}" 2>&1 || true)
}

# cppcheck reads a header with the sources that include it, but not GLSL, which takes it minutes. Loops
# stay loops where they read well.
check_cpp()
{
  local sources
  mapfile -t sources < <(listed '*.cxx')
  ((${#sources[@]})) && has cppcheck || return 0
  echo "cppcheck: ${#sources[@]} files"
  cppcheck --std=c++17 --language=c++ --enable=warning,style,performance,portability --quiet \
    --inline-suppr --suppress=useStlAlgorithm --library=Utilities/cppcheck.cfg -j "$jobs" \
    --error-exitcode=1 --template='{file}:{line}: {severity}: {message} [{id}]' \
    -I Module -I Filters -I Rendering -I Testing/Support -I Testing/Benchmark -I Examples/airlight \
    "${sources[@]}" || findings=1
}

# tidy BUILD FILE...: checks those of the files (absolute names) that the build compiles.
tidy()
{
  local folder=$1 sources
  shift
  [[ -e $folder/compile_commands.json ]] || return 0
  mapfile -t sources < <(printf '%s\n' "$@" | grep -Fx -f <(
    sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' "$folder/compile_commands.json") || true)
  ((${#sources[@]})) || return 0
  echo "clang-tidy: ${#sources[@]} files"
  printf '%s\0' "${sources[@]}" |
    xargs -0 -n 1 -P "$jobs" clang-tidy --quiet -p "$folder" 2> /dev/null || findings=1
}

check_tidy()
{
  local sources
  mapfile -t sources < <(listed '*.cxx')
  ((${#sources[@]})) && has clang-tidy || return 0
  [[ -e $build/compile_commands.json ]] ||
    die "clang-tidy needs a build, in build/ or in the folder AIRLIGHT_BUILD."
  ! grep -q '^AIRLIGHT_UNITY_BUILD:BOOL=ON' "$build/CMakeCache.txt" ||
    die "clang-tidy needs files that are compiled by themselves: cmake -DAIRLIGHT_UNITY_BUILD=OFF $build"
  cmake --build "$build" --parallel "$jobs" --target Airlight > /dev/null || # headers made of GLSL
    die "the library does not build."
  tidy "$build" "${sources[@]/#/$root/}"
  tidy "$paraview_build" "${sources[@]/#/$root/}"
}

# changed COMMIT: files that differ from it, and sources that include a changed header.
changed()
{
  local names name
  names=$(git diff --name-only --diff-filter=d "$1" && git ls-files --others --exclude-standard)
  {
    echo "$names"
    while read -r name; do
      name=$(basename "$name" .glsl)
      git grep -lF "\"$name" -- '*.cxx' || true
    done < <(grep -E '\.(h|inl|glsl)$' <<< "$names" || true)
  } | sort -u
}

# One place for the version, and a changelog as the release notes are.
check_releases()
{
  echo "version and changelog"
  python3 Utilities/check-version.py || findings=1
  python3 Utilities/changelog.py --check || findings=1
}

# Who may include whom, and lines of 100 columns in code.
check_rooms()
{
  local found
  echo "includes and columns"
  python3 Utilities/check-includes.py || findings=1
  found=$(git ls-files Module Filters Rendering ParaView Wrapping Examples |
    grep -E '\.(cxx|h|inl|glsl)$' |
    xargs awk 'length > 100 { print FILENAME ":" FNR ": wider than 100 columns" }')
  [[ -z $found ]] || { echo "$found"; findings=1; }
}

with_tidy=1
case ${1---help} in
  -h | --help)
    sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    exit
    ;;
  --quick)
    with_tidy=0
    mapfile -t files < <(git ls-files | grep -vE '^(Examples|Testing|ParaView)/.*\.cxx$')
    ;;
  --all) mapfile -t files < <(git ls-files) ;;
  --changed) mapfile -t files < <(changed "${2:-HEAD}") ;;
  -*) die "unknown option '$1'; try --help." ;;
  *) mapfile -t files < <(realpath --relative-to "$root" "$@") ;;
esac

check_rooms
check_releases
check_shell
check_python
check_cpp
((!with_tidy)) || check_tidy
((!findings)) || die "there are findings; see above. Fix them, or give the reason in a comment there."
((!missing)) || exit 125
echo "no findings"
