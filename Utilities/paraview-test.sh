#!/usr/bin/env bash
# Fetches ParaView without installing it, builds Airlight and its plugin for it, and runs their tests.
#
# Usage: Utilities/paraview-test.sh [CTEST OPTION...]        all of it
#        Utilities/paraview-test.sh --fetch                  only fetches
#        Utilities/paraview-test.sh --build                  only fetches and builds
#        Utilities/paraview-test.sh --run [-n RANKS] SCRIPT [ARGUMENT...]
#                                                            runs a script in pvpython, or on this
#                                                            number of pvbatch ranks, with the plugin
#        Utilities/paraview-test.sh --window [ARGUMENT...]   opens ParaView's window with the plugin
#        Utilities/paraview-test.sh --empty-window [...]     the same, before the plugin is loaded
#
# ParaView's Debian packages conflict with VTK's Python package. They are therefore unpacked below
# build/paraview-test, and reused. AIRLIGHT_PARAVIEW_PREFIX selects another prefix with a ParaView.
# AIRLIGHT_JOBS is the number of parallel jobs (default: one per processor).
#
# Exits with 125 if ParaView is not available; the tests are then skipped.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

paraview=$build/paraview-test
prefix=${AIRLIGHT_PARAVIEW_PREFIX:-$paraview/prefix/usr}
plugin=$paraview/plugin
packages=(paraview python3-paraview paraview-dev)
# For its window only; the last has its icons.
window_packages=(libqt5help5 libqt5opengl5 libqt5sql5 libqt5sql5-sqlite libqt5svg5)

skip()
{
  echo "skipped: $*" >&2
  exit 125
}

# find_in FOLDER FILE: the folder below FOLDER that has FILE, or nothing.
find_in()
{
  find "$1" -path "*/$2" -printf '%h\n' -quit 2> /dev/null || true
}

# name_modules FOLDER: ParaView's CMake package requests Python modules without the suffix that
# Debian 13 gives them.
name_modules()
{
  local module name
  while IFS= read -r module; do
    name=${module%%.cpython-*}.so
    [[ -e $name ]] || ln -s "$(basename "$module")" "$name"
  done < <(find "$1" -name '*.cpython-*.so')
}

download()
{
  (cd "$1" && timeout 600 apt-get -q download "${packages[@]}") || return
  # Debian 13 names some differently. Without them there is no window.
  local package
  for package in "${window_packages[@]}"; do
    (cd "$1" && { timeout 100 apt-get -q download "$package" ||
      timeout 100 apt-get -q download "${package}t64"; }) || true
  done
}

fetch()
{
  [[ -z ${AIRLIGHT_PARAVIEW_PREFIX-} && ! -d $paraview/prefix ]] || return 0
  command -v apt-get > /dev/null || skip "no apt-get to fetch ParaView with."
  command -v dpkg-deb > /dev/null || skip "no dpkg-deb to unpack ParaView with."
  local temporary package
  mkdir -p "$paraview"
  temporary=$(mktemp -d "$paraview/fetch.XXXXXX")
  # shellcheck disable=SC2064
  trap "rm -rf '$temporary'" EXIT
  if ! download "$temporary"; then
    local as_root=()
    ((EUID == 0)) || as_root=(sudo -n)
    "${as_root[@]}" timeout 300 apt-get -q update || true
    download "$temporary" || skip "ParaView's packages (${packages[*]}) could not be downloaded."
  fi
  for package in "$temporary"/*.deb; do
    dpkg-deb -x "$package" "$temporary/prefix" || skip "$(basename "$package") does not unpack."
  done
  name_modules "$temporary/prefix"
  mv "$temporary/prefix" "$paraview/prefix"
  rm -rf "$temporary"
  trap - EXIT
}

# Sets the environment of ParaView's programs.
use_paraview()
{
  local libraries package python
  libraries=$(find_in "$prefix" 'libvtkRemotingViews-pv*.so')
  python=$(dirname "$(find_in "$prefix" paraview/simple.py)")
  export LD_LIBRARY_PATH=$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
  package=$(dirname "$(find_in "$plugin" airlight/paraview.py)")
  export PYTHONPATH=$package:$root/ParaView/Testing:$python
  export PATH=$prefix/bin:$PATH
}

# The libraries that pvpython and pvbatch lack.
missing_libraries()
{
  (use_paraview && ldd "$prefix"/bin/pvpython* "$prefix"/bin/pvbatch* \
    "$(find_in "$prefix" 'libvtkRemotingViews-pv*.so')"/libvtkRemotingViews-pv*.so \
    2> /dev/null) | awk '/not found/ { print $1 }' | sort -u | paste -sd ' '
}

build_plugin()
{
  local package missing python=()
  package=$(find_in "$prefix" paraview-config.cmake)
  [[ -n $package ]] || skip "no ParaView with its CMake package below $prefix."
  missing=$(missing_libraries)
  [[ -z $missing ]] || skip "ParaView lacks libraries: $missing. Install the packages that have them."
  rm -f "$plugin/built"
  local generator=()
  if [[ ! -e $plugin/CMakeCache.txt ]] && command -v ninja > /dev/null; then
    generator=(-G Ninja)
  fi
  # ParaView's Python is the system's, which need not be the first in PATH.
  [[ ! -x /usr/bin/python3 ]] || python=(-DPython3_EXECUTABLE=/usr/bin/python3)
  # Compiles fast rather than runs fast, for the tests.
  cmake -S "$root/ParaView" -B "$plugin" "${generator[@]}" "${python[@]}" \
    -DParaView_DIR="$package" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
    -DAIRLIGHT_UNITY_BUILD=ON ||
    die "CMake could not configure the plugin; see its message above."
  cmake --build "$plugin" --parallel "$jobs" ||
    die "the plugin does not build; see the compiler's message above."
  touch "$plugin/built"
}

run()
{
  [[ -e $plugin/built ]] ||
    skip "there is no plugin; Utilities/paraview-test.sh --build makes it where ParaView can be had."
  local ranks=0
  if [[ ${1-} == -n ]]; then
    ranks=$2
    shift 2
  fi
  use_paraview
  # ParaView keeps settings, such as a palette of colours, which scripts and tests must not change for
  # the user nor for each other.
  settings=$(mktemp -d)
  trap 'rm -rf "$settings"' EXIT
  export XDG_CONFIG_HOME=$settings
  AIRLIGHT_PLUGIN=$(find_in "$plugin" AirlightParaView.so)/AirlightParaView.so
  export AIRLIGHT_PLUGIN AIRLIGHT_TEST_OUTPUT=${AIRLIGHT_TEST_OUTPUT:-$PWD}
  local command=(pvpython "$@")
  if ((ranks > 0)); then
    command -v mpirun > /dev/null || skip "no mpirun."
    # Child processes of pvpython inherit MPI variables, with which mpirun does nothing.
    local name
    for name in $(compgen -e | grep -E '^(OMPI|PMIX|ORTE)_'); do
      unset "$name"
    done
    # Ranks of a test may share a processor, and the container's only user may be root.
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    command=(mpirun --oversubscribe -n "$ranks" pvbatch "$@")
  fi
  if [[ -n ${DISPLAY-} ]]; then
    "${command[@]}"
  else
    on_virtual_display "${command[@]}"
  fi
}

# open_window [ARGUMENT...]: of ParaView. The plugin is loaded if load is 1.
open_window()
{
  [[ -e $plugin/built ]] ||
    skip "there is no plugin; Utilities/paraview-test.sh --build makes it where ParaView can be had."
  use_paraview
  [[ -x $prefix/bin/paraview ]] || skip "no ParaView with a window."
  local missing icons command=("$prefix/bin/paraview")
  missing=$(ldd "$prefix/bin/paraview" | awk '/not found/ { print $1 }' | paste -sd ' ')
  [[ -z $missing ]] || skip "ParaView's window lacks libraries: $missing."
  icons=$(find_in "$prefix" iconengines/libqsvgicon.so)
  [[ -z $icons ]] || export QT_PLUGIN_PATH=${icons%/*}${QT_PLUGIN_PATH:+:$QT_PLUGIN_PATH}
  if ((load)); then
    command+=(--plugin-search-paths "$(find_in "$plugin" AirlightParaView.so)"
      --plugins AirlightParaView)
  fi
  command+=("$@")
  if [[ -n ${DISPLAY-} ]]; then
    "${command[@]}"
  else
    on_virtual_display "${command[@]}"
  fi
}

case ${1-} in
  -h | --help) sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" ;;
  --fetch) fetch ;;
  --build)
    fetch
    build_plugin
    ;;
  --run)
    shift
    (($#)) || die "--run needs a script."
    run "$@"
    ;;
  --window)
    shift
    load=1
    open_window "$@"
    ;;
  --empty-window)
    shift
    load=0
    open_window "$@"
    ;;
  *)
    step_count=4
    step "Installing what is missing"
    install_missing cmake ctest c++ xvfb-run xauth
    step "Building for ParaView"
    fetch
    build_plugin
    step "Configuring"
    configure -DAIRLIGHT_BUILD_TESTING=ON
    step "Testing"
    cd "$build"
    on_virtual_display ctest --output-on-failure --no-tests=error -R ParaView "$@" ||
      die "some tests failed; see above."
    ;;
esac
