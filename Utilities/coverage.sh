#!/usr/bin/env bash
# Measures which lines and branches of Module, Filters and Rendering the tests run.
#
# Usage: Utilities/coverage.sh [CTEST OPTION...]     builds, runs the tests, reports
#        Utilities/coverage.sh --report              reports again
#
# Builds in build/coverage, with GCC. build/coverage/missing.txt lists the lines that do not run, and
# build/coverage/html has the report. Failing tests count, too. Shaders on the graphics card are not
# measured: of the GLSL only Module/glsl, as the classes on the CPU compile it.
# AIRLIGHT_JOBS is the number of parallel jobs (default: one per processor).
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
build=$root/build/coverage
cd "$root" # gcovr takes its filters from here
dependencies=(--with-openvdb --with-analysis)

# A line per folder, from gcovr's JSON summary.
table()
{
  python3 - "$1" << 'END'
import collections
import json
import sys

with open(sys.argv[1]) as file:
    files = json.load(file)["files"]
sums = collections.defaultdict(collections.Counter)
for entry in files:
    for name in (entry["filename"].split("/")[0], "all"):
        for key in ("line_covered", "line_total", "branch_covered", "branch_total"):
            sums[name][key] += entry[key]
print("| folder | lines | run | branches | taken |\n|---|---|---|---|---|")
for name in ("Module", "Filters", "Rendering", "all"):
    s = sums[name]
    lines = 100.0 * s["line_covered"] / max(s["line_total"], 1)
    branches = 100.0 * s["branch_covered"] / max(s["branch_total"], 1)
    print(f"| {name} | {s['line_total']} | {lines:.1f} % | {s['branch_total']} | {branches:.1f} % |")
END
}

# Leaves out branches that only exceptions of the C++ library take.
report()
{
  mkdir -p "$build/html"
  gcovr --root "$root" --object-directory "$build" --exclude-throw-branches \
    --exclude-unreachable-branches --filter Module/ --filter Filters/ --filter Rendering/ \
    --json-summary "$build/summary.json" --txt "$build/missing.txt" \
    --html-details "$build/html/index.html" "$build" > /dev/null ||
    die "gcovr failed; see its message above."
  table "$build/summary.json"
}

case ${1-} in
  -h | --help)
    sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    exit
    ;;
  --report)
    report
    exit
    ;;
esac

step_count=5
step "Installing what is missing"
install_missing cmake ctest g++ gcovr xvfb-run xauth

step "Configuring"
configure -DAIRLIGHT_BUILD_TESTING=ON -DAIRLIGHT_COVERAGE=ON -DCMAKE_CXX_COMPILER=g++

step "Building"
compile all

step "Testing"
find "$build" -name '*.gcda' -delete
(cd "$build" && on_virtual_display ctest --output-on-failure --no-tests=error --timeout 1200 \
  --parallel "$jobs" "$@") || echo "some tests failed; see above." >&2

step "Reporting"
report
